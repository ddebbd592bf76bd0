// The page of a campaign that runs: there after the baseline and the rows that likely matter most, and
// filling itself.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

// With the small study's rows ten realizations; the two of sand.nu come last, and wait for the gate.
constexpr const char* more_rows = R"("initial.sigma_h0_kPa" = { baseline = 25, lower = 15, upper = 35 }
"contact.friction_ratio" = { baseline = 0.5, lower = 0.3, upper = 0.9 }
)";

class LivePage : public testing::Test {
 protected:
  LivePage() {
    std::string study = folder_.read("small.toml");
    folder_.write("small.toml", study.insert(study.find("\n[[windows]]"), more_rows));
  }

  [[nodiscard]] Command command(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{folder_.study(), "--executor", FAKE_REALIZATION, "--slots", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return campaign(words);
  }
  [[nodiscard]] std::vector<std::string> gated() const {
    return {"CPT_FAKE=sand.nu=0.1:wait;sand.nu=0.3:wait", "CPT_FAKE_GATE=" + folder_.file("gate")};
  }
  [[nodiscard]] bool page_says(const std::string& text) const {
    return std::filesystem::exists(folder_.file("small-report/index.html")) &&
           folder_.read("small-report/index.html").find(text) != std::string::npos;
  }
  // Without a limit of its own: the suite's ends a test that waits in vain.
  void wait_for_page(const Background& job) const {
    while (!page_says("\"state\"") && alive(job.pid()))
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }

  StudyFolder folder_;
};

const std::string so_far = "\"state\":\"8 of 10 realizations completed, 2 still to run\"";

// The plan of a study whose campaign runs, and of one whose campaign was killed.
TEST_F(LivePage, APlanTellsWhatRunsNowFromWhatWasInterrupted) {
  const auto plan = [&] { return run(campaign({folder_.study(), "--plan"})).out; };
  const auto says = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
  };
  {
    Background job(command({"--no-report"}), gated());
    ASSERT_TRUE(eventually([&] {
      const std::string text = plan();
      return text.find("8 realizations kept") != std::string::npos &&
             text.find("1 realization running now") != std::string::npos;
    }));
    const std::string now = plan();
    says(now, "a campaign runs on this database now, process " + std::to_string(job.pid()) +
                  " holds small.sqlite.lock");
    EXPECT_EQ(now.find("interrupted"), std::string::npos) << now;
  }
  const std::string then = plan();
  says(then, "1 realization interrupted before and to be run again");
  EXPECT_EQ(then.find("running"), std::string::npos) << then;
}

TEST_F(LivePage, IsThereAfterTheLeadingRowsAndFillsItself) {
  Background job(command(), gated());
  wait_for_page(job);
  EXPECT_TRUE(page_says(so_far));
  EXPECT_TRUE(page_says("\"reload_seconds\":5"));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("small-report/report.pdf")))
      << "the page alone, until the end";
  folder_.write("gate", "");
  const Result result = job.wait();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("small-report/index.html; the open page fills itself"), std::string::npos)
      << result.err;
  EXPECT_TRUE(page_says("\"state\":\"10 of 10 realizations completed\""));
  EXPECT_TRUE(page_says("\"reload_seconds\":0"));
  EXPECT_TRUE(std::filesystem::exists(folder_.file("small-report/report.pdf")));
}

TEST_F(LivePage, OfAStoppedCampaignDoesNotReload) {
  Background job(command(), gated());
  wait_for_page(job);
  ::kill(job.pid(), SIGTERM);
  EXPECT_EQ(job.wait().exit_code, 143);
  EXPECT_TRUE(page_says(so_far));
  EXPECT_TRUE(page_says("\"reload_seconds\":0"));
}

// A file stands where the report's folder would have to be.
TEST_F(LivePage, ThatCannotBeWrittenStopsNoCampaign) {
  folder_.write("small-report", "not a folder");
  folder_.write("gate", "");
  const Result result = run(command(), gated());
  EXPECT_EQ(result.exit_code, 6) << result.err;  // of the report at the end
  EXPECT_NE(result.out.find("10 of 10 realizations completed"), std::string::npos) << result.out;
}

TEST_F(LivePage, IsNotWrittenWithoutAReport) {
  folder_.write("gate", "");
  EXPECT_EQ(run(command({"--no-report"}), gated()).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("small-report")));
}

}  // namespace
}  // namespace cpt::tests

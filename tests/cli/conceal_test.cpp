// A concealed benchmark from plan to page, with realizations that follow a known law instead of the solver.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

class Conceal : public ::testing::Test {
 protected:
  Conceal() {
    folder.write(
        "sand.toml",
        "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[fixed]\n\"penetrometer.final_depth_m\" = 0.30\n"
        "[parameters]\n\"sand.D_r_percent\" = { baseline = 36, lower = 26, upper = 46 }\n"
        "[[windows]]\nname = \"w\"\nfrom_m = 0.2\nto_m = 0.22\n");
    folder.write("bench.toml",
                 "study = \"sand.toml\"\nmechanisms = [\"surface_compaction\", \"density_lens\"]\n"
                 "[[soundings]]\nname = \"a\"\nfrom_m = 0.04\nto_m = 0.26\n[noise]\nmeasurement_percent = 1\n"
                 "[options]\nrepeats = 4\njoint = 3\nconfirm = 0\n"
                 "[cases]\nnothing = 2\nsingle = 2\npair = 1\noutside = 1\n");
  }
  [[nodiscard]] Result call(std::vector<std::string> words) const {
    return run(campaign(words), {"CPT_FAKE=*:law", "CPT_FAKE_SECONDS=0.001"});
  }
  [[nodiscard]] Result conceal() const {
    return call({"conceal", folder.file("bench.toml"), "--quiet", "--executor", FAKE_REALIZATION});
  }
  [[nodiscard]] Result diagnose() const {
    std::vector<std::string> words{"diagnose", "--no-report", "--quiet", "--executor", FAKE_REALIZATION};
    for (int id = 1; id <= 6; ++id)
      words.push_back(folder.file("bench-cases/case-00" + std::to_string(id) + ".toml"));
    return call(words);
  }
  [[nodiscard]] Result reveal() const {
    return call({"reveal", folder.file("bench.toml"), "--out", folder.file("page.md")});
  }
  StudyFolder folder;
};

TEST_F(Conceal, FromPlanToPage) {
  const Result concealed = conceal();
  ASSERT_EQ(concealed.exit_code, 0) << concealed.err;
  for (const char* file : {"bench-cases/case-006.toml", "bench-cases/case-006-1.csv",
                           "bench-cases/seals.json", "bench-sealed/truth.json"})
    EXPECT_TRUE(std::filesystem::exists(folder.file(file))) << file;
  const std::string seals = folder.read("bench-cases/seals.json"),
                    first = folder.read("bench-cases/case-001-1.csv");

  const Result early = reveal();
  EXPECT_EQ(early.exit_code, 2);
  EXPECT_NE(early.err.find("6 of 6 cases have no answer yet"), std::string::npos) << early.err;

  // The truth is not needed for the answers: with it taken away they are the same.
  const Result answered = diagnose();
  ASSERT_EQ(answered.exit_code, 0) << answered.err;
  std::filesystem::rename(folder.file("bench-sealed"), folder.file("away"));
  for (int id = 1; id <= 6; ++id)
    std::filesystem::remove(folder.file("bench-cases/case-00" + std::to_string(id) + ".sqlite"));
  const Result blind = diagnose();
  EXPECT_EQ(blind.exit_code, 0) << blind.err;
  EXPECT_EQ(blind.out, answered.out);
  std::filesystem::rename(folder.file("away"), folder.file("bench-sealed"));

  // Concealed again, the cases are the same.
  ASSERT_EQ(conceal().exit_code, 0);
  EXPECT_EQ(folder.read("bench-cases/seals.json"), seals);
  EXPECT_EQ(folder.read("bench-cases/case-001-1.csv"), first);

  const Result revealed = reveal();
  ASSERT_EQ(revealed.exit_code, 0) << revealed.err;
  const std::string page = folder.read("page.md");
  for (const char* text : {"## The bars", "| false alarms where nothing is missing |", " of 2, ",
                           "## What was missed, and why", "page/strength.svg"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
  EXPECT_TRUE(std::filesystem::exists(folder.file("page/reliability.png")));
}

TEST_F(Conceal, AChangedTruthDoesNotFitItsSeal) {
  ASSERT_EQ(conceal().exit_code, 0);
  ASSERT_EQ(diagnose().exit_code, 0);
  std::string truth = folder.read("bench-sealed/truth.json");
  const std::size_t at = truth.find("\"courant\": 0.") + 13;
  truth[at] = truth[at] == '7' ? '8' : '7';
  folder.write("bench-sealed/truth.json", truth);
  const Result revealed = reveal();
  EXPECT_EQ(revealed.exit_code, 2);
  EXPECT_NE(revealed.err.find("does not fit its seal"), std::string::npos) << revealed.err;
  EXPECT_FALSE(std::filesystem::exists(folder.file("page.md")));
}

TEST_F(Conceal, AnEditedPlanIsNotMixedWithTheOldDraw) {
  ASSERT_EQ(conceal().exit_code, 0);
  folder.write("bench.toml", folder.read("bench.toml") + "two_soundings = 0\n");
  EXPECT_EQ(conceal().exit_code, 0);  // says the same
  std::string plan = folder.read("bench.toml");
  plan.replace(plan.find("single = 2"), 10, "single = 3");
  folder.write("bench.toml", plan);
  const Result edited = conceal();
  EXPECT_EQ(edited.exit_code, 2);
  EXPECT_NE(edited.err.find("drawn for another plan"), std::string::npos) << edited.err;
}

}  // namespace
}  // namespace cpt::tests

// An emulator from the command line: made, asked, stale, grown.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

constexpr const char* emulated_study = R"(profile = "homogeneous_sand"
preset = "quick"
[fixed]
"penetrometer.final_depth_m" = 0.3
[parameters]
"sand.H" = { baseline = 25, upper = 75 }
"sand.nu" = { baseline = 0.2, lower = 0.1, upper = 0.3 }
[design]
kind = "latin_hypercube"
runs = 24
[[windows]]
name = "deep"
from_m = 0.2
to_m = 0.25
)";

class Emulate : public testing::Test {
 protected:
  Emulate() {
    folder.write("sand.toml", emulated_study);
    run_study();
  }
  void run_study() const {
    EXPECT_EQ(run(campaign({study(), "--executor", FAKE_REALIZATION, "--no-report"}), {"CPT_FAKE_SECONDS=0"})
                  .exit_code,
              0);
  }
  [[nodiscard]] std::string study() const { return folder.file("sand.toml"); }
  StudyFolder folder;
};

TEST_F(Emulate, IsMadeAskedAndRefusedWhenStale) {
  const Result none = run(campaign({"predict", study()}));
  EXPECT_EQ(none.exit_code, 6);
  expect_part(none.err, "no such emulator; campaign emulate STUDY makes it");

  const Result made = run(campaign({"emulate", study(), "--format", "csv"}));
  ASSERT_EQ(made.exit_code, 0) << made.out << made.err;
  expect_part(made.out, "deep.q_c_mean_kPa,28,");  // baseline, three bounds, the design
  expect_part(made.out, "\nq_c_kPa,28,");
  expect_part(made.err, "sand-emulator.h5: 28 runs of 2 inputs");

  // At the baseline it says what the run gave.
  const Result at = run(campaign({"predict", study(), "--format", "csv"}));
  ASSERT_EQ(at.exit_code, 0) << at.err;
  const auto number = [](const std::string& text, const std::string& before) {
    return std::stod(text.substr(text.find(before) + before.size()));
  };
  const double predicted = number(at.out, "baseline,deep.q_c_mean_kPa,");
  const Result stored =
      run(campaign({"query", study(), "sql",
                    "select 'x', q_c_mean_kPa from window_mean where realization = 1", "--format", "csv"}));
  EXPECT_NEAR(predicted, number(stored.out, "x,"), 1e-3 * predicted);

  // A run that was not made.
  folder.write("points.csv", "name,sand.H\na,31\nb,52\n");
  const Result points =
      run(campaign({"predict", folder.file("sand-emulator.h5"), "--table", folder.file("points.csv"), "--set",
                    "sand.nu=0.13", "--curves", folder.file("curves.csv"), "--format", "csv"}));
  ASSERT_EQ(points.exit_code, 0) << points.err;
  expect_part(points.out, "a,deep.q_c_mean_kPa,");
  expect_part(points.out, "b,deep.f_s_mean_kPa,");
  expect_part(folder.read("curves.csv"), "point,output,depth_m,value,standard_error,lower,upper,unit");
  expect_part(folder.read("curves.csv"), "\nb,q_c_kPa,");

  // Points to run next are appended, run, and make the emulator stale until it is made anew.
  const Result next = run(campaign({"emulate", study(), "--next", "2"}));
  ASSERT_EQ(next.exit_code, 0) << next.err;
  expect_part(next.out, "[[points]]\nname = \"emulator 1\"\n\"sand.H\" = ");
  EXPECT_EQ(next.out, run(campaign({"emulate", study(), "--next", "2"})).out);
  folder.write("sand.toml", emulated_study + next.out);
  run_study();
  const Result stale = run(campaign({"predict", study()}));
  EXPECT_EQ(stale.exit_code, 6);
  expect_part(stale.err, "is stale: 2 more runs are there; campaign emulate");
  const Result more = run(campaign({"emulate", study(), "--next", "1"}));
  expect_part(more.out, "\"emulator 3\"");
  EXPECT_EQ(run(campaign({"predict", study()})).exit_code, 0);
}

TEST_F(Emulate, SaysWhatIsWrong) {
  ASSERT_EQ(run(campaign({"emulate", study()})).exit_code, 0);
  const auto refused = [&](const std::string& setting) {
    const Result result = run(campaign({"predict", study(), "--set", setting}));
    EXPECT_EQ(result.exit_code, 2) << setting;
    return result.err;
  };
  expect_part(refused("sand.H=80"),
              "--set sand.H=80: must be 25 to 75, as the emulator knows no runs beyond");
  expect_part(refused("sand.nu=0,2"), "is not a number; decimals follow a point");
  expect_part(refused("sand.Nu=0.2"), "sand.Nu is no input of the emulator; did you mean sand.nu?");
  expect_part(refused("sand.H"), "must be NAME=VALUE");
  folder.write("points.csv", "sand.H,sand.e\n80,1\nx,1\n");
  const Result table = run(campaign({"predict", study(), "--table", folder.file("points.csv")}));
  EXPECT_EQ(table.exit_code, 2);
  expect_part(table.err, "points.csv:2:1: error: sand.H: \"80\" must be 25 to 75");
  expect_part(table.err, "points.csv:3:1: error: sand.H: \"x\" is not a number");
  expect_part(table.err, "points.csv:1:8: error: sand.e: is no input of the emulator");
  folder.write("sand-emulator.h5", "rubbish");
  const Result damaged = run(campaign({"predict", study()}));
  EXPECT_EQ(damaged.exit_code, 6);
  expect_part(damaged.err, "sand-emulator.h5: cannot be read as an emulator");
  // A study whose runs do not vary together.
  const Result single = run(campaign({"emulate", folder.study()}));
  EXPECT_EQ(single.exit_code, 6);
}

}  // namespace
}  // namespace cpt::tests

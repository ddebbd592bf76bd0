// Propagations from the command line, with a stand-in for the solver: they stop by their own rule, and a
// study is whole without the files that its distributions came from.
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"
#include "tests/parameters/distributions/with_openturns.hpp"

namespace cpt::tests {
namespace {

const std::string head =
    "profile = \"homogeneous_sand\"\npreset = \"quick\"\n"
    "[parameters]\n\"sand.nu\" = { lower = 0.1, upper = 0.3 }\n\"sand.H\" = { baseline = 50, lower = 25, "
    "upper = 75 }\n"
    "[fixed]\n\"penetrometer.final_depth_m\" = 0.1\n"
    "[[windows]]\nname = \"deep\"\nfrom_m = 0.05\nto_m = 0.09\nthresholds_kPa = [10, 15]\n"
    "[design]\nkind = \"propagation\"\n";

Result start(const StudyFolder& folder, const std::string& design, int ranks = 1) {
  folder.write("grown.toml", head + design);
  const std::vector<std::string> words = {folder.file("grown.toml"), "--executor", FAKE_REALIZATION,
                                          "--no-report"};
  return run(ranks > 1 ? mpirun(ranks, words) : campaign(words), {"CPT_FAKE_SECONDS=0.001"});
}

std::string asked(const StudyFolder& folder, const std::string& what, const std::string& sql = "") {
  std::vector<std::string> words = {"query", folder.file("grown.sqlite"), what};
  if (!sql.empty()) words.push_back(sql);
  words.insert(words.end(), {"--format", "csv"});
  const Result answer = run(campaign(words));
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  return answer.out;
}

std::string count_of(const StudyFolder& folder, const std::string& status) {
  return asked(folder, "sql", "select count(*) as n from realization where status = '" + status + "'");
}

TEST(Propagation, StopsOnceItsFirstRunsSuffice) {
  const StudyFolder folder;
  EXPECT_EQ(start(folder, "runs = 60\n").exit_code, 0);
  EXPECT_EQ(count_of(folder, "completed"), "n\n65\n");
  const Result stopped = start(folder, "runs = 400\nuntil = { half_width_percent = 30 }\n");
  EXPECT_EQ(stopped.exit_code, 0) << stopped.err;
  EXPECT_NE(
      stopped.err.find("the mean is known to ± 30 % in every window after 50 runs: 350 of the design are not "
                       "needed"),
      std::string::npos)
      << stopped.err;
  EXPECT_NE(stopped.out.find("65 of 65 realizations completed, 0 failed"), std::string::npos) << stopped.out;
  EXPECT_EQ(count_of(folder, "not_needed"), "n\n340\n");
  const std::string numbers = asked(folder, "effects");
  EXPECT_NE(numbers.find(",50,0,"), std::string::npos) << numbers;

  // A rule that does not hold asks for all of them again.
  const Result whole = start(folder, "runs = 90\nuntil = { quantile = 0.9, half_width_percent = 1e-6 }\n");
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(count_of(folder, "completed"), "n\n95\n");
  EXPECT_EQ(count_of(folder, "not_needed"), "n\n0\n");
}

// What is handed out when the rule begins to hold differs from run to run; the numbers do not.
TEST(Propagation, ItsNumbersDoNotDependOnRanksOrOnWhenItWasStopped) {
  const std::string design = "runs = 200\nuntil = { quantile = 0.95, half_width_percent = 20 }\n";
  const StudyFolder one, two;
  EXPECT_EQ(start(one, design).exit_code, 0);
  EXPECT_EQ(start(two, design, 2).exit_code, 0);
  const std::string numbers = asked(one, "effects");
  EXPECT_GT(numbers.size(), 300U);
  EXPECT_EQ(numbers, asked(two, "effects"));
  EXPECT_EQ(asked(one, "bands"), asked(two, "bands"));
}

class PropagationOfAFile : public parameters::WithOpenTurns {};

TEST_F(PropagationOfAFile, IsWholeWithoutTheFile) {
  const StudyFolder folder;
  folder.write("lab.csv", "nu;depth\n0.15;1\n0.2;2\n0.22;3\n0.25;4\n0.18;5\n0.21;6\n");
  const std::string text =
      "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[parameters]\n"
      "\"sand.nu\" = { distribution = { kind = \"empirical\", file = \"lab.csv\", column = \"nu\" } }\n"
      "[fixed]\n\"penetrometer.final_depth_m\" = 0.1\n"
      "[[windows]]\nname = \"deep\"\nfrom_m = 0.05\nto_m = 0.09\n[design]\nkind = \"propagation\"\nruns = "
      "40\n";
  folder.write("grown.toml", text);
  const Command command =
      campaign({folder.file("grown.toml"), "--executor", FAKE_REALIZATION, "--no-report"});
  const Result first = run(command, {"CPT_FAKE_SECONDS=0.001"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const std::string numbers = asked(folder, "effects");
  EXPECT_NE(asked(folder, "sql", "select study_text from campaign").find("0.15, 0.2, 0.22, 0.25, 0.18, 0.21"),
            std::string::npos);
  // An equal file is an equal study; one that is gone is an error that names it.
  EXPECT_NE(run(command).err.find("kept: completed before with the same settings"), std::string::npos);
  std::filesystem::remove(folder.file("lab.csv"));
  EXPECT_EQ(asked(folder, "effects"), numbers);
  const Result gone = run(command);
  EXPECT_EQ(gone.exit_code, 2);
  EXPECT_NE(gone.err.find("grown.toml:4:"), std::string::npos) << gone.err;
  EXPECT_NE(gone.err.find("lab.csv"), std::string::npos) << gone.err;
}

}  // namespace
}  // namespace cpt::tests

// Diagnoses from request to report, with realizations that follow a known law instead of the solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

const std::string law = "CPT_FAKE=*:law";

class Diagnose : public ::testing::Test {
 protected:
  Diagnose() {
    folder.write(
        "sand.toml",
        "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[fixed]\n\"penetrometer.final_depth_m\" = 0.30\n"
        "[parameters]\n\"sand.D_r_percent\" = { baseline = 36, lower = 26, upper = 46 }\n"
        "\"contact.friction_ratio\" = { baseline = 0.5, lower = 0.3, upper = 0.9 }\n"
        "[[windows]]\nname = \"w\"\nfrom_m = 0.2\nto_m = 0.22\n");
    write_request("d", "a.csv");
  }
  void write_request(const std::string& name, const std::string& recording) const {
    folder.write(
        name + ".toml",
        "study = \"sand.toml\"\nmechanisms = [\"surface_compaction\", \"wall_friction\", \"density_lens\"]\n"
        "[[soundings]]\nrecording = \"" +
            recording +
            "\"\ncolumns = { depth_m = \"z\", q_c_MPa = \"q\" }\n"
            "from_m = 0.04\nto_m = 0.28\n[noise]\nmeasurement_percent = 1\n[options]\nrepeats = 6\njoint = "
            "4\n");
  }
  // The law with D_r = 39 %, `compaction` near the surface, and a wave of 1 % in place of noise.
  void write_recording(const std::string& name, double compaction, double factor = 1.0) const {
    std::string text = "z,q\n";
    for (double z = 0.03; z < 0.30; z += 0.001)
      text += std::to_string(z) + "," +
              std::to_string(factor * 4.0 * std::sqrt(z) *
                             std::exp(1.5 * 0.03 + 0.9 * compaction * std::exp(-z / 0.05) +
                                      0.01 * std::sin(400.0 * z))) +
              "\n";
    folder.write(name, text);
  }
  [[nodiscard]] Result diagnose(const std::string& name, std::vector<std::string> variables = {}) const {
    variables.push_back(law);
    variables.push_back("CPT_FAKE_SECONDS=0.001");
    return run(campaign({"diagnose", folder.file(name + ".toml"), "--quiet", "--executor", FAKE_REALIZATION}),
               variables);
  }
  StudyFolder folder;
};

TEST_F(Diagnose, FindsWhatIsMissingAndReusesItsRuns) {
  write_recording("a.csv", 0.35);
  const Result result = diagnose("d", {"CPT_FAKE_LOG=" + folder.file("log")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("Sand compacted near the surface can explain what the simulation lacks"),
            std::string::npos)
      << result.out;
  for (const char* file : {"d.sqlite", "d-report/d-diagnosis.md", "d-report/diagnosis.json",
                           "d-report/diagnosis-profile.png", "sand-diagnosis.sqlite"})
    EXPECT_TRUE(std::filesystem::exists(folder.file(file))) << file;
  const std::string log = folder.read("log");
  EXPECT_GT(std::count(log.begin(), log.end(), '\n'), 35);

  // Nothing runs again, and the answer is the same.
  std::filesystem::remove(folder.file("log"));
  const Result again = diagnose("d", {"CPT_FAKE_LOG=" + folder.file("log")});
  EXPECT_EQ(again.out, result.out);
  EXPECT_FALSE(std::filesystem::exists(folder.file("log")));

  // The report of the study says so, too; that of another study would not.
  ASSERT_EQ(
      run(campaign({folder.file("sand.toml"), "--quiet", "--executor", FAKE_REALIZATION}), {law}).exit_code,
      0);
  const std::string page = folder.read("sand-report/index.html");
  EXPECT_NE(page.find("Sand compacted near the surface can explain what the simulation lacks"),
            std::string::npos);
  EXPECT_NE(page.find("\"file\":\"d.sqlite\""), std::string::npos);

  // Another recording against the same study needs no more than its own fitted runs.
  write_recording("b.csv", 0.0);
  write_request("e", "b.csv");
  const Result nothing = diagnose("e", {"CPT_FAKE_LOG=" + folder.file("log")});
  ASSERT_EQ(nothing.exit_code, 0) << nothing.err;
  EXPECT_TRUE(nothing.out.starts_with("Nothing is missing") || nothing.out.starts_with("No firm sign"))
      << nothing.out;
  EXPECT_EQ(nothing.out.find("lacks"), std::string::npos) << nothing.out;
  const std::string few = folder.read("log");
  EXPECT_LE(std::count(few.begin(), few.end(), '\n'), 2);
}

TEST_F(Diagnose, RanksGiveTheSameAnswer) {
  write_recording("a.csv", 0.35);
  const Result one = diagnose("d");
  ASSERT_EQ(one.exit_code, 0) << one.err;
  for (const char* file : {"d.sqlite", "sand-diagnosis.sqlite"}) std::filesystem::remove(folder.file(file));
  const Result two =
      run(mpirun(2, {"diagnose", folder.file("d.toml"), "--quiet", "--executor", FAKE_REALIZATION}),
          {law, "CPT_FAKE_SECONDS=0.001"});
  ASSERT_EQ(two.exit_code, 0) << two.err;
  EXPECT_EQ(one.out, two.out);
}

TEST_F(Diagnose, BadInputIsToldBeforeAnythingRuns) {
  struct Case {
    std::string recording, message;
  };
  const std::string head = "z,q\n";
  std::string constant = head, void_column = head, millimetres = head;
  for (double z = 0.03; z < 0.30; z += 0.001) {
    constant += std::to_string(z) + ",1.5\n";
    void_column += std::to_string(z) + ",\n";
    millimetres += std::to_string(1000.0 * z) + "," + std::to_string(4.0 * std::sqrt(z)) + "\n";
  }
  for (const Case& bad : {Case{head + "0.05,1\n", "10 are needed"}, Case{constant, "constant column"},
                          Case{void_column, "no value of q_c"}, Case{millimetres, "no overlap in depth"},
                          Case{head + "0.05,x\n", "x"}}) {
    folder.write("a.csv", bad.recording);
    const Result result = diagnose("d", {"CPT_FAKE_LOG=" + folder.file("log")});
    EXPECT_EQ(result.exit_code, 2) << bad.message;
    EXPECT_NE(result.err.find(bad.message), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder.file("log")));
  }
  write_recording("a.csv", 0.0, 1e-3);  // kPa in a column of MPa
  const Result units = diagnose("d");
  EXPECT_EQ(units.exit_code, 2);
  EXPECT_NE(units.err.find("mind its unit"), std::string::npos) << units.err;
}

// Recordings that others may not pass on lie in a folder of the user's.
TEST_F(Diagnose, RecordingsMayLieInAnotherFolder) {
  std::filesystem::create_directory(folder.file("elsewhere"));
  write_recording("elsewhere/a.csv", 0.0);
  const auto plan = [&](std::vector<std::string> more, const std::vector<std::string>& variables) {
    std::vector<std::string> command = {"diagnose", folder.file("d.toml"), "--plan"};
    command.insert(command.end(), more.begin(), more.end());
    return run(campaign(command), variables);
  };
  const Result nowhere = plan({}, {"CPT_RECORDINGS="});
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_NE(nowhere.err.find("a.csv"), std::string::npos) << nowhere.err;
  EXPECT_EQ(plan({"--recordings", folder.file("elsewhere")}, {}).exit_code, 0);
  EXPECT_EQ(plan({}, {"CPT_RECORDINGS=" + folder.file("elsewhere")}).exit_code, 0);
  // One beside the request goes first.
  write_recording("a.csv", 0.0);
  EXPECT_EQ(plan({"--recordings", folder.file("nowhere")}, {}).exit_code, 0);
}

TEST_F(Diagnose, PlanTellsHowMuchItTakes) {
  write_recording("a.csv", 0.0);
  const Result result = run(campaign({"diagnose", folder.file("d.toml"), "--plan"}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("realizations, kept in"), std::string::npos);
}

}  // namespace
}  // namespace cpt::tests

// Calibrations from request to answer, with realizations that follow a known law instead of the solver.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

// ln q_c = ... + 1.5 (D_r - 0.36) + 0.4 (friction - 0.5), of the stand-in for the solver.
class Calibrate : public ::testing::Test {
 protected:
  Calibrate() {
    folder.write(
        "sand.toml",
        "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[fixed]\n\"penetrometer.final_depth_m\" = 0.20\n"
        "[parameters]\n\"sand.D_r_percent\" = { baseline = 36, lower = 26, upper = 46 }\n"
        "\"contact.friction_ratio\" = { baseline = 0.5, lower = 0.3, upper = 0.5 }\n"
        "[design]\nkind = \"latin_hypercube\"\nruns = 40\n"
        "[[windows]]\nname = \"w\"\nfrom_m = 0.15\nto_m = 0.17\n");
    folder.write("c.toml", request);
    // D_r = 42 %, friction ratio 0.4
    std::string text = "z,q\n";
    for (double z = 0.03; z < 0.20; z += 0.001)
      text += std::to_string(z) + "," +
              std::to_string(4.0 * std::sqrt(z) *
                             std::exp(1.5 * 0.06 - 0.4 * 0.1 + 0.002 * std::sin(400.0 * z))) +
              "\n";
    folder.write("a.csv", text);
  }
  void run_study() const {
    const Result result =
        run(campaign({folder.file("sand.toml"), "--quiet", "--no-report", "--executor", FAKE_REALIZATION}),
            {"CPT_FAKE=*:law", "CPT_FAKE_SECONDS=0.001"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  [[nodiscard]] Result calibrate(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"calibrate", folder.file("c.toml")});
    return run(campaign(more));
  }
  // Of a CSV file with a name first in each row: row, then column.
  [[nodiscard]] std::map<std::string, std::map<std::string, double>> table(const std::string& file) const {
    std::istringstream lines(folder.read(file));
    std::string line, cell;
    std::getline(lines, line);
    std::vector<std::string> columns;
    for (std::istringstream names(line); std::getline(names, cell, ',');) columns.push_back(cell);
    std::map<std::string, std::map<std::string, double>> rows;
    while (std::getline(lines, line)) {
      std::istringstream cells(line);
      std::string name;
      std::getline(cells, name, ',');
      for (std::size_t k = 1; std::getline(cells, cell, ','); ++k)
        rows[name][columns[k]] = std::atof(cell.c_str());
    }
    return rows;
  }
  const std::string request =
      "study = \"sand.toml\"\n[[soundings]]\nrecording = \"a.csv\"\ncolumns = { depth_m = \"z\", q_c_MPa = "
      "\"q\" }\n"
      "from_m = 0.04\nto_m = 0.18\n[noise]\nmeasurement_percent = 0.5\n[discrepancy]\ndeviation_percent = "
      "0.5\n";
  StudyFolder folder;
};

TEST_F(Calibrate, FindsWhatTheRecordingTells) {
  run_study();
  const Result result = calibrate();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("f_s is left out"), std::string::npos) << result.err;  // the law's does not vary
  for (const char* file : {"draws.csv", "correlation.csv", "bands.csv", "posterior.toml", "marginals.svg",
                           "marginals.png", "bands.svg", "bands.png"})
    EXPECT_TRUE(std::filesystem::exists(folder.file(std::string("c-calibration/") + file))) << file;
  auto posterior = table("c-calibration/posterior.csv");
  auto& density = posterior["sand.D_r_percent"];
  EXPECT_NEAR(density["prior_mean"], 36.0, 0.3);
  EXPECT_NEAR(density["prior_sd"], 20.0 / std::sqrt(12.0), 0.2);
  EXPECT_LT(density["q05"], 42.0);
  EXPECT_GT(density["q95"], 42.0);
  EXPECT_LT(density["sd_over_prior_sd"], 0.5);
  EXPECT_LT(density["r_hat"], 1.01);
  EXPECT_GT(density["bulk_ess"], 400.0);
  // What raises q_c as much: one makes up for the other.
  EXPECT_LT(table("c-calibration/correlation.csv")["sand.D_r_percent"]["contact.friction_ratio"], -0.5);
  EXPECT_NE(result.out.find("The chains agree"), std::string::npos) << result.out;

  // The same bits again, from the stored emulator.
  const std::string draws = folder.read("c-calibration/draws.csv"),
                    bands = folder.read("c-calibration/bands.csv");
  const Result again = calibrate();
  EXPECT_EQ(again.out, result.out);
  EXPECT_EQ(again.err.find("runs of 2 inputs"), std::string::npos) << again.err;
  EXPECT_EQ(folder.read("c-calibration/draws.csv"), draws);
  EXPECT_EQ(folder.read("c-calibration/bands.csv"), bands);
}

TEST_F(Calibrate, ChecksItselfWithRunsHeldOut) {
  run_study();
  const Result result = calibrate({"--check", "10"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("10 recordings made of runs held out, an emulator of 34 others"),
            std::string::npos)
      << result.out;
  EXPECT_TRUE(std::filesystem::exists(folder.file("c-calibration/ranks.svg")));
  const std::string ranks = folder.read("c-calibration/ranks.csv");
  EXPECT_EQ(std::count(ranks.begin(), ranks.end(), '\n'), 1 + 10 * 3);

  const Result most = calibrate({"--check", "35"});
  EXPECT_EQ(most.exit_code, 2);
  EXPECT_NE(most.err.find("16 must be left for the emulator"), std::string::npos) << most.err;
}

TEST_F(Calibrate, WhatCannotBeIsToldAndNothingIsWritten) {
  EXPECT_EQ(calibrate().exit_code, 6);  // no runs yet
  run_study();
  struct Case {
    std::string request, message;
    int code;
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = request;
    return text.replace(text.find(from), from.size(), to);
  };
  for (const Case& bad : {Case{with("to_m = 0.18", "to_m = 0.5"), "c.toml:6:8: error: soundings.to_m", 2},
                          Case{with("\"a.csv\"", "\"none.csv\""), "none.csv", 2},
                          Case{with("q_c_MPa", "q_c_GPa"), "mind the unit of q_c", 2},
                          Case{with("study = \"sand.toml\"", "study = \"sand.toml\"\nchannels = [\"f_s\"]"),
                               "no channel is left", 2}}) {
    folder.write("c.toml", bad.request);
    const Result result = calibrate();
    EXPECT_EQ(result.exit_code, bad.code) << result.err;
    EXPECT_NE(result.err.find(bad.message), std::string::npos) << bad.message << "\n" << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder.file("c-calibration")));
  }
}

}  // namespace
}  // namespace cpt::tests

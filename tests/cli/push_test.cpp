// campaign push from the command line: a push of a few millimetres, and what it leaves behind.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

const std::vector<std::string> few_millimetres{"--set", "penetrometer.final_depth_m=0.024"};

Command push(const StudyFolder& folder, std::vector<std::string> more) {
  std::vector<std::string> words{"push", folder.study()};
  words.insert(words.end(), more.begin(), more.end());
  words.insert(words.end(), few_millimetres.begin(), few_millimetres.end());
  return campaign(words);
}

TEST(Push, WritesFieldsHistoriesProfileAndRadialProfile) {
  const StudyFolder folder;
  const Result result =
      run(push(folder, {"--fields-at", "0,0.023", "--track", "0.0127,0.1", "0.0253,0.1", "--wall-between",
                        "0.1,0.3", "--radial-between", "0.0,0.3", "--out", folder.file("out")}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  expect_has(result.out, "realization 1 of small: completed");
  expect_has(result.out, "fields at 2 depth(s)");
  expect_has(result.out, "histories of 2 material points and 1 parts of the wall");
  for (const char* file : {"out/small-fields/small.pvd", "out/small-fields/small-0m.vtu",
                           "out/small-fields/small-0.023m.vtu", "out/small-histories.h5"})
    EXPECT_TRUE(std::filesystem::exists(folder.file(file))) << file;
  expect_has(folder.read("out/small-profile.csv"), "depth_m,q_c_kPa,f_s_kPa,wall_stress_kPa");
  expect_has(folder.read("out/small-radial.csv"), "r_m,points,void_ratio_start");
  EXPECT_FALSE(std::filesystem::exists(folder.file("small.sqlite"))) << "the campaign is not touched";
}

TEST(Push, GivesTheSameProfileAsAnyOtherRunOfTheRealization) {
  const StudyFolder folder;
  EXPECT_EQ(run(push(folder, {"3", "--threads", "1", "--out", folder.file("plain")})).exit_code, 0);
  EXPECT_EQ(run(push(folder, {"3", "--threads", "2", "--fields-at", "0.0225,0.0235", "--track", "0.02,0.1",
                              "--out", folder.file("watched")}))
                .exit_code,
            0);
  const std::string profile = folder.read("plain/small-3-profile.csv");
  EXPECT_GT(profile.size(), 100U);
  EXPECT_EQ(folder.read("watched/small-3-profile.csv"), profile);
  EXPECT_EQ(folder.read("watched/small-3-radial.csv"), folder.read("plain/small-3-radial.csv"));
}

TEST(Push, KeepsWhatItHasRecordedAlready) {
  const StudyFolder folder;
  const auto again = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--keep", "--out", folder.file("out")});
    const Result result = run(push(folder, more));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  };
  expect_has(again({"--track", "0.02,0.1"}), "realization 1 of small: completed");
  expect_has(again({"--track", "0.02,0.1"}), "realization 1 of small: kept as it is");
  expect_has(again({"--track", "0.03,0.1"}), "completed");
  expect_has(again({"--track", "0.03,0.1", "--set", "sand.H=30"}), "completed");
  expect_has(again({"--track", "0.03,0.1", "--set", "sand.H=30", "--threads", "1"}), "kept as it is");
  folder.write("out/small-histories.h5", "damaged");
  expect_has(again({"--track", "0.03,0.1", "--set", "sand.H=30"}), "completed");
}

TEST(Push, UnusableFolderIsExitCode6) {
  const StudyFolder folder;
  folder.write("file", "no folder");
  const Result result = run(push(folder, {"--out", folder.file("file/out")}));
  EXPECT_EQ(result.exit_code, 6);
  expect_has(result.err, "file/out");
}

TEST(Push, AFailedPushIsExitCode1AndKeepsWhatItHas) {
  const StudyFolder folder;
  folder.write("clay.toml",
               "profile = \"homogeneous_clay\"\npreset = \"quick\"\n[parameters]\n"
               "\"clay.s_u_kPa\" = { lower = 20 }\n"
               "[[windows]]\nname = \"w\"\nfrom_m = 0.1\nto_m = 0.2\n");
  // Far faster than the scaled waves travel.
  const Result result = run(campaign({"push", folder.file("clay.toml"), "--set", "numerics.mass_scaling=1e6",
                                      "penetrometer.speed_m_per_s=0.5", "penetrometer.final_depth_m=0.3",
                                      "--out", folder.file("out")}));
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder.file("out/clay-profile.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("out/clay-radial.csv")));
}

}  // namespace
}  // namespace cpt::tests

// What the program says to words, files and statements that are nearly right.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

struct Bad {
  std::vector<std::string> arguments;
  const char* message;
};

void expect_refused(const std::vector<Bad>& cases) {
  for (const Bad& bad : cases) {
    const Result result = run(campaign(bad.arguments));
    EXPECT_EQ(result.exit_code, 2) << bad.message << "\n" << result.out;
    expect_has(result.err, bad.message);
  }
}

TEST(Hints, MisspeltWordsOfTheCommandLine) {
  const StudyFolder folder;
  const std::string no_ending = folder.file("small");
  expect_refused({
      {{"reprot", folder.study()}, "did you mean 'report'?"},
      {{no_ending}, "small.toml'?"},
      {{folder.study(), "--sltos", "2"}, "did you mean --slots?"},
      {{"run", folder.study(), "--plna"}, "did you mean --plan?"},
      {{"query", folder.study(), "tornadoo"}, "did you mean tornado?"},
      {{"query", folder.study(), "sensitivity", "--formt=csv"}, "did you mean --format?"},
      {{"query", folder.study(), "sensitivity", "--format", "jsn"}, "did you mean json?"},
      {{"list", "quantites"}, "did you mean quantities?"},
      {{"list", "preset"}, "did you mean presets?"},
      {{"element", "triaxal"}, "did you mean triaxial?"},
      {{"element", "triaxial", "--materiall", "sand"}, "did you mean --material?"},
      {{"compare", folder.study(), folder.study(), "mean"}, "did you mean means?"},
      {{"push", folder.study(), "--set", "sand.relative_density=40"}, "did you mean sand.D_r_percent?"},
      {{"push", folder.study(), "--set", "chamber.wall=rigd"}, "did you mean rigid?"},
      {{"push", folder.study(), "--set", "sand.H=2,5"}, "decimals follow a point, not a comma: 2.5"},
      {{"push", folder.study(), "--set", "sand.H=+-5"}, "not a number"},
      {{"push", folder.study(), "--fields-at", "0.2,25 kPa"}, "the number alone, without a unit: 25"},
  });
}

TEST(Hints, MisspeltNamesOfAStudy) {
  const StudyFolder folder;
  folder.write(
      "bad.toml",
      "profile = \"homogenous_sand\"\npreset = \"standart\"\n[fixed]\n\"sand.relative_density\" = 40\n"
      "[parameters]\n\"sand.H\" = { upper = 75 }\n[design]\nkind = \"moris\"\n"
      "[[windows]]\nname = \"w\"\nfrom_m = 0.1\nto_m = 0.2\n");
  const Result result = run(campaign({folder.file("bad.toml")}));
  EXPECT_EQ(result.exit_code, 2);
  for (const char* hint : {"did you mean \"homogeneous_sand\"?", "did you mean \"standard\"?"})
    expect_has(result.err, hint);
  folder.write("names.toml",
               "profile = \"homogeneous_sand\"\n[fixed]\n\"sand.relative_density\" = 40\n"
               "[parameters]\n\"sand.H\" = { upper = 75 }\n[design]\nkind = \"moris\"\n"
               "[[windows]]\nname = \"w\"\nfrom_m = 0.1\nto_m = 0.2\n");
  const Result names = run(campaign({folder.file("names.toml")}));
  EXPECT_EQ(names.exit_code, 2);
  for (const char* hint : {"did you mean sand.D_r_percent?", "did you mean \"morris\"?"})
    expect_has(names.err, hint);
  folder.write("comma.toml", "profile = \"homogeneous_sand\"\n[fixed]\n\"sand.H\" = 2,5\n");
  expect_refused({{{folder.file("comma.toml")}, "comma.toml:3:13: error"},
                  {{folder.file("comma.toml")}, "decimals follow a point, not a comma: 2.5"}});
}

TEST(Hints, AFileOfAnotherKindNamesTheCommandsThatTakeIt) {
  const StudyFolder folder;
  ASSERT_EQ(
      run(campaign({folder.study(), "--executor", FAKE_REALIZATION, "--no-report", "--quiet"})).exit_code, 0);
  const std::string database = folder.file("small.sqlite");
  const std::string request =
      "study = \"small.toml\"\n[[soundings]]\nrecording = \"a.csv\"\nfrom_m = 0.04\nto_m = 0.3\n";
  folder.write("request.toml", request);
  folder.write("plan.toml", request + "[cases]\nsingle = 1\n");
  std::filesystem::copy_file(database, folder.file("copy.toml"));
  expect_refused({
      {{database}, "small.sqlite: is a database, not a study; query, compare"},
      {{"run", database, "--plan"}, "is a database, not a study"},
      {{"push", database}, "is a database, not a study"},
      {{"diagnose", database}, "is a database, not a request for a diagnosis"},
      {{"diagnose", folder.study()}, "is a study, not a request for a diagnosis; run, rerun"},
      {{"diagnose", folder.file("plan.toml")}, "is a plan of concealed cases, not a request"},
      {{"conceal", folder.study()}, "is a study, not a plan of concealed cases"},
      {{"run", folder.file("request.toml")}, "is a request for a diagnosis, not a study; campaign diagnose"},
      {{"query", folder.file("request.toml"), "tornado"}, "is a request for a diagnosis, not a study"},
  });
  // Whatever it is called, a database is taken where one is wanted.
  EXPECT_EQ(run(campaign({"query", folder.file("copy.toml"), "realizations"})).exit_code, 0);
}

TEST(Hints, AMissingStudyHidesNothingOfTheRequest) {
  const StudyFolder folder;
  folder.write("d.toml",
               "study = \"none.toml\"\nmechanisms = [\"density_lense\"]\n[options]\nrepeats = 1\n"
               "[[soundings]]\nrecording = \"a.csv\"\nfrom_m = 0.01\nto_m = 0.3\n");
  expect_refused({{{"diagnose", folder.file("d.toml")}, "cannot be read as a study"},
                  {{"diagnose", folder.file("d.toml")}, "did you mean \"density_lens\"?"},
                  {{"diagnose", folder.file("d.toml")}, "options.repeats: 1 must be a whole number"},
                  {{"diagnose", folder.file("d.toml")}, "soundings.from_m: 0.01 m lies within the start"}});
  folder.write("p.toml",
               "study = \"none.toml\"\n[options]\nrepeats = 1\n[cases]\nsingle = 1\n"
               "[[soundings]]\nname = \"a\"\nfrom_m = 0.04\nto_m = 0.3\n");
  expect_refused({{{"conceal", folder.file("p.toml")}, "cannot be read as a study"},
                  {{"conceal", folder.file("p.toml")}, "options.repeats: 1 must be a whole number"}});
}

TEST(Hints, AWrongStatementIsBadInputWithItsPlace) {
  const StudyFolder folder;
  ASSERT_EQ(
      run(campaign({folder.study(), "--executor", FAKE_REALIZATION, "--no-report", "--quiet"})).exit_code, 0);
  expect_refused({
      {{"query", folder.study(), "sql", "selct 1"}, "sql:1:1: near \"selct\": syntax error"},
      {{"query", folder.study(), "sql", "select staus from realization"},
       "sql:1:8: no such column: staus; did you mean status?"},
      {{"query", folder.study(), "sql", "select * from realizatoin"}, "did you mean realization?"},
      {{"query", folder.study(), "sql", "drop table campaign"}, "only statements that read are run"},
  });
}

TEST(Hints, LayersThatCannotBeMadeAreRefusedAndThoseThatAreOffAreTold) {
  const StudyFolder folder;
  const auto study = [&](const std::string& bottom) {
    folder.write(
        "seam.toml",
        "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[fixed]\n\"penetrometer.final_depth_m\" = 0.1\n"
        "[parameters]\n\"sand.H\" = { upper = 75 }\n[[windows]]\nname = \"w\"\nfrom_m = 0.03\nto_m = 0.09\n"
        "[[layers]]\ntop_m = 0\nbottom_m = 0.06\nsoil = \"sand\"\n[[layers]]\ntop_m = 0.06\nbottom_m = " +
            bottom + "\nsoil = \"clay\"\n[[layers]]\ntop_m = " + bottom +
            "\nbottom_m = 1\nsoil = \"sand\"\n");
    return folder.file("seam.toml");
  };
  for (const char* how : {"--validate", "--plan", "--no-report"}) {
    const Result refused = run(campaign({"run", study("0.062"), how, "--executor", FAKE_REALIZATION}));
    EXPECT_EQ(refused.exit_code, 2) << how;
    expect_has(refused.err, "seam.toml:11:");
    expect_has(refused.err, "error: layers: the clay from 0.06 to 0.062 m, 2 mm thick, would be 0 mm");
    expect_has(refused.err, "wherever it lies is 31.9 mm, for the rows beyond r = 0.2 m");
    const Result told = run(campaign({"run", study("0.076"), how, "--executor", FAKE_REALIZATION}));
    EXPECT_EQ(told.exit_code, 0) << how << told.err << told.out;
    expect_has(told.out, "note: layers are made of whole rows of material points");
    expect_has(told.out, "16 mm thick: it is 12.1 mm thick between r = 0.08 and 0.2 m");
  }
  ASSERT_EQ(run(campaign({"report", folder.file("seam.toml")})).exit_code, 0);
  expect_has(folder.read("seam-report/index.html"), "16 mm thick: it is 12.1 mm thick");
  expect_has(folder.read("seam-report/report.json"), "\"remarks\": [");
}

}  // namespace
}  // namespace cpt::tests

// What the program says and returns for good and bad command lines.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

TEST(CommandLine, HelpHasExamplesAndExitCodes) {
  for (const Command& command : {campaign({}), campaign({"--help"})}) {
    const Result result = run(command);
    EXPECT_EQ(result.exit_code, 0);
    expect_has(result.out, "Examples:");
    expect_has(result.out, "Exit codes:");
    expect_has(result.out, "rerun");
  }
  for (const char* command : {"run", "rerun", "query", "compare", "export", "import", "report", "push",
                              "paper", "numerics", "element", "recording", "diagnose", "list"})
    EXPECT_EQ(run(campaign({command, "--help"})).exit_code, 0) << command;
}

TEST(CommandLine, VersionNamesProgramAndSolver) {
  const Result result = run(campaign({"--version"}));
  EXPECT_EQ(result.exit_code, 0);
  expect_has(result.out, "campaign ");
  expect_has(result.out, "solver ");
}

struct Bad {
  std::vector<std::string> arguments;
  const char* message;
};

TEST(CommandLine, BadInputIsExitCode2WithItsReason) {
  const StudyFolder folder;
  const Bad cases[] = {
      {{"quary"}, "did you mean 'query'?"},
      {{"/nowhere/x.toml"}, "/nowhere/x.toml: cannot be read as a study (No such file or directory)"},
      {{"run"}, "STUDY"},
      {{folder.study(), "--slots", "0"}, "--slots"},
      {{folder.study(), "--no-such-option"}, "--no-such-option"},
      {{"query", folder.study(), "nonsense"}, "nonsense"},
      {{"query", folder.study(), "sql"}, "needs a statement"},
      {{"list", "nonsense"}, "nonsense"},
      {{"rerun", folder.study(), "x"}, "ID"},
      {{"push", folder.study(), "99"}, "has no realization 99; it has 1 to 6"},
      {{"push", folder.study(), "--set", "sand.Hh=3"}, "did you mean sand.H?"},
      {{"push", folder.study(), "--set", "initial.sigma_h0_kPa=4000"}, "stress ratio"},
      {{"push", folder.study(), "--fields-at", "0.2,,0.4"}, "'' is not a number"},
      {{"push", folder.study(), "--fields-at", "0.2,deep"}, "'deep' is not a number"},
      {{"push", folder.study(), "--fields-at", "0.6"}, "must be 0 to 0.53 m, where the push ends"},
      {{"push", folder.study(), "--track", "0.02"}, "must be R_M,DEPTH_M"},
      {{"push", folder.study(), "--track", "0.5,0.5"}, "must be 0 to 0.45 m, the wall"},
      {{"push", folder.study(), "--track", "0.02,1.5"}, "must be 0 to 1 m, the soil's bottom"},
      {{"push", folder.study(), "--wall-between", "0.4,0.4"}, "the first depth must be the smaller one"},
      {{"push", folder.study(), "--radial-between", "0.4,0.2"}, "the first depth must be the smaller one"},
      {{"numerics"}, "STUDY|DB is required"},
      {{"run", "/"}, "/: cannot be read as a study (Is a directory)"},
      {{"diagnose", "/"}, "/: cannot be read as a request (Is a directory)"},
      {{"conceal", "/"}, "/: cannot be read as a plan of concealed cases (Is a directory)"},
      {{"run", "/dev/zero"}, "/dev/zero: cannot be read as a study (more than 64 MiB)"},
      {{"query", "/nowhere/x.toml", "failures"}, "cannot be read as a study (No such file or directory)"},
      {{"recording", "/nowhere/a.gef"},
       "/nowhere/a.gef: cannot be read as a recording (No such file or directory)"},
      {{"recording", "a.csv", "--column", "q_c_MPa"}, "must be QUANTITY=NAME"},
      {{"recording", "a.csv", "--column", "q_c_m=qc"}, "'q_c_m' is no quantity; known are depth_m"},
      {{"recording", "a.csv", "--out", "a.jpg"}, "must end in .svg or .png"},
      {{"recording", "a.csv", "--unit-weight", "180"}, "--unit-weight 180: must be 5 to 40 kN/m3"},
      {{"recording", "a.csv", "--area-quotient", "1.5"}, "--area-quotient 1.5: must be 0.01 to 1"},
      {{"element", "triaxial", "--set", "sand.Hh=3"}, "did you mean sand.H?"},
      {{"element", "calibrate", folder.study(), "--toml", "a.toml"}, "--toml and --plot need --fit"},
      {{"element", "triaxial", "--set", "sand.H"}, "must be NAME=VALUE"},
      {{"element", "triaxial", "--material", "mohr_coulomb", "--set", "mohr_coulomb.phi_deg=2"},
       "mohr_coulomb.psi_deg: mohr_coulomb.psi_deg = 3 must be at most mohr_coulomb.phi_deg = 2"},
      {{"element", "triaxial", "--set", "sand.H=much"}, "not a number"},
      {{"element", "triaxial", "--set", "sand.nu=0.7"}, "must be 0 to 0.45"},
      {{"element", "triaxial", "--set", "clay.s_u_kPa=20"}, "only quantities named sand."},
      {{"element", "triaxial", "--p0_kPa", "10", "--sigma_v0_kPa", "20"}, "either"},
      {{"element", "triaxial", "--material", "clay", "--D_r_percent", "20"}, "for sand"},
  };
  for (const Bad& bad : cases) {
    const Result result = run(campaign(bad.arguments));
    EXPECT_EQ(result.exit_code, 2) << bad.message;
    expect_has(result.err, bad.message);
  }
}

TEST(CommandLine, StudyErrorsAreAllPrintedOnceUnderMpirunToo) {
  const StudyFolder folder;
  folder.write("bad.toml",
               "profile = \"homogeneous_sand\"\n[parameters]\n\"sand.Hh\" = { upper = 75 }\n"
               "\"sand.nu\" = { upper = 0.9 }\n[[windows]]\nname = \"w\"\nfrom_m = 0.1\nto_m = 0.2\n");
  for (const Command& command : {campaign({folder.file("bad.toml")}), mpirun(2, {folder.file("bad.toml")})}) {
    const Result result = run(command);
    EXPECT_EQ(result.exit_code, 2);
    expect_has(result.err, "sand.Hh");
    expect_has(result.err, "sand.nu");
    EXPECT_EQ(result.err.find("2 errors"), result.err.rfind("2 errors"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder.file("bad.sqlite")));
}

TEST(CommandLine, PlanAndValidateRunNothing) {
  const StudyFolder folder;
  const Result plan = run(campaign({folder.study(), "--plan"}));
  EXPECT_EQ(plan.exit_code, 0);
  expect_has(plan.out, "sand.D_r_percent");
  expect_has(plan.out, "new");
  const Result valid = run(campaign({"run", folder.study(), "--validate"}));
  EXPECT_EQ(valid.exit_code, 0) << valid.out;
  expect_has(valid.out, "6 realizations");
  EXPECT_FALSE(std::filesystem::exists(folder.file("small.sqlite")));
}

TEST(CommandLine, UnusableDatabaseIsExitCode6) {
  const StudyFolder folder;
  EXPECT_EQ(run(campaign({"query", folder.study(), "realizations"})).exit_code, 6) << "there is none yet";
  folder.write("small.sqlite", "this is no database, it is a text of more than a few bytes");
  EXPECT_EQ(run(campaign({"query", folder.study(), "realizations"})).exit_code, 6);
  EXPECT_EQ(run(campaign({folder.study(), "--executor", FAKE_REALIZATION})).exit_code, 6);
  EXPECT_EQ(run(mpirun(2, {folder.study(), "--executor", FAKE_REALIZATION})).exit_code, 6);
}

TEST(CommandLine, CalibratesHardeningFromWhatTheElementTestMade) {
  const StudyFolder folder;
  const std::string made = folder.file("made.csv");
  ASSERT_EQ(run(campaign({"element", "triaxial", "--D_r_percent", "51", "--p0_kPa", "160", "--set",
                          "sand.H=60", "--strain_percent", "5", "--steps", "200", "--csv", made}))
                .exit_code,
            0);
  // Its natural strains as a laboratory's per cent of the initial length, its columns under a laboratory's
  // names.
  std::istringstream rows(folder.read("made.csv"));
  std::string lab = "# test = CD 51\n# D_r_percent = 51\n# p0_kPa = 160\neps_a_percent,q_kPa,eps_v_percent\n";
  std::string line;
  for (std::getline(rows, line); std::getline(rows, line);) {
    double eps_a = 0.0, eps_v = 0.0, q = 0.0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &eps_a, &eps_v, &q), 3);
    lab += std::to_string(-100.0 * std::expm1(-eps_a)) + "," + std::to_string(q) + "," +
           std::to_string(-100.0 * std::expm1(-eps_v)) + "\n";
  }
  folder.write("lab.csv", lab);
  const Result result =
      run(campaign({"element", "calibrate", folder.file("lab.csv"), "--csv", folder.file("H.csv")}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  expect_has(result.out, "psi_0");
  const std::string table = folder.read("H.csv");
  double p_0 = 0.0, e_0 = 0.0, psi_0 = 0.0, H = 0.0;
  ASSERT_EQ(std::sscanf(table.c_str() + table.find("CD 51"), "CD 51,%lf,%lf,%lf,%lf", &p_0, &e_0, &psi_0, &H),
            4)
      << table;
  EXPECT_EQ(p_0, 160.0);
  EXPECT_NEAR(H, 60.0, 0.6);

  // The same over all tests at once, from the usual H on.
  const Result fit = run(campaign({"element", "calibrate", folder.file("lab.csv"), "--fit", "H,phi_cs_deg",
                                   "--csv", folder.file("fit.csv"), "--toml", folder.file("fit.toml"),
                                   "--plot", folder.file("fit.svg")}));
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  expect_has(fit.out, "critical_state");
  expect_has(fit.out, "by hand H = ");
  expect_has(folder.read("fit.svg"), "CD 51");
  expect_has(folder.read("fit.toml"), "\"sand.H\" = { distribution = { kind = \"lognormal\", mean = ");
  expect_has(folder.read("fit.toml"), "[correlation]\n\"sand.H\" = { \"sand.phi_cs_deg\" = ");
  const std::string fitted = folder.read("fit.csv");
  double given = 0.0, by_hand = 0.0, value = 0.0, low = 0.0, high = 0.0;
  ASSERT_EQ(std::sscanf(fitted.c_str() + fitted.find("\nH,"), "\nH,-,%lf,%lf,%lf,%lf,%lf", &given, &by_hand,
                        &value, &low, &high),
            5)
      << fitted;
  EXPECT_EQ(given, 25.0);
  EXPECT_NEAR(value, 60.0, 0.6);
  EXPECT_LT(low, value);
  EXPECT_GT(high, value);

  folder.write("bad.csv", "eps_a_percent,q_kPa\n0,0\n1,x\n2,3\n");
  const Result bad = run(campaign({"element", "calibrate", folder.file("bad.csv"), folder.file("none.csv")}));
  EXPECT_EQ(bad.exit_code, 2);
  expect_has(bad.err, "bad.csv:3:3: q_kPa: 'x' is not a number");
  expect_has(bad.err, "none.csv: cannot be read");
  folder.write("bare.csv", "eps_a_percent,q_kPa\n0,0\n1,2\n2,3\n");
  const Result bare = run(campaign({"element", "calibrate", folder.file("bare.csv")}));
  EXPECT_EQ(bare.exit_code, 2);
  expect_has(bare.err, "--p0_kPa");
  expect_has(bare.err, "--D_r_percent");
}

TEST(CommandLine, RecordingIsSummedUpPlottedAndWritten) {
  const StudyFolder folder;
  folder.write("chamber.csv", "z_m,tip\n0.1,0.5\n0.2,-9999\n0.3,0.7\n");
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"recording", folder.file("chamber.csv"),
                                      "--column",  "depth_m=z_m",
                                      "--column",  "q_c_MPa=tip",
                                      "--void",    "-9999",
                                      "--out",     folder.file("plot.svg")};
    words.insert(words.end(), more.begin(), more.end());
    return run(campaign(words));
  };
  const Result table = with({"--csv", folder.file("readings.csv")});
  ASSERT_EQ(table.exit_code, 0) << table.err;
  expect_has(table.out, "rows read       3");
  expect_has(table.out, "1 row, line 3: q_c is void");
  expect_has(folder.read("plot.svg"), "<svg");
  expect_has(folder.read("readings.csv"), "2,0.1,,500,");
  const Result json = with({"--format", "json"});
  expect_has(json.out, "\"quantities\": [");
  expect_has(json.out, "\"first_line\": 3");
  expect_has(with({"--format", "csv"}).out, "part,fact,value,unit,quantity,values,void,min,median,max,");
  EXPECT_EQ(with({"--csv", "/nowhere/readings.csv"}).exit_code, 6);
  folder.write("bad.csv", "depth_m,q_c_MPa\n0.1,x\n");
  const Result bad = run(campaign({"recording", folder.file("bad.csv")}));
  EXPECT_EQ(bad.exit_code, 2);
  expect_has(bad.err, "bad.csv:2:5: error: found 'x', expected a number (q_c_MPa)");
}

TEST(CommandLine, RecordingSaysWhatItReadsOutAndAssumes) {
  const StudyFolder folder;
  std::string rows = "# area_quotient = 0.8\ndepth_m,q_c_MPa,f_s_kPa,u_2_kPa,speed_mm_per_s\n";
  for (int i = 0; i < 60; ++i)
    rows += std::to_string(2.0 + 0.02 * i) + "," +
            (i == 30      ? "9"
             : i % 2 == 0 ? "5.0"
                          : "5.1") +
            ",30,20," + (i < 50 ? "20" : "30") + "\n";
  folder.write("sand.csv", rows);
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"recording", folder.file("sand.csv"), "--out", folder.file("plot.svg")};
    words.insert(words.end(), more.begin(), more.end());
    return run(campaign(words));
  };
  const Result table = with({"--water-table", "0.5", "--csv", folder.file("readings.csv")});
  ASSERT_EQ(table.exit_code, 0) << table.err;
  for (const char* line :
       {"q_t = q_c + (1 - a) u_2", "area quotient a: 0.8 (of the file)",
        "unit weight of the soil: 18 kN/m3 (assumed)", "depth of the water table: 0.5 m (given)",
        "6  sands: clean sand to silty sand", "Spikes of single readings: 1 of q_c",
        "median 20 mm/s; 10 of 60 readings outside of 20 +- 5", "3.18"})
    expect_has(table.out, line);
  expect_has(folder.read("readings.csv"), ",q_t_kPa,R_f_percent,Q_tn,F_r_percent,n,I_c,zone\n");
  expect_has(folder.read("readings.csv"), ",5004,");  // 5000 + 0.2 20 kPa
  expect_has(folder.read("plot.svg"), ">zone<");
  const Result json = with({"--format", "json"});
  for (const char* part :
       {"\"assumptions\": [", "\"soil_behaviour\": [", "\"spikes\": [", "\"odd_speeds\": ["})
    expect_has(json.out, part);
}

TEST(CommandLine, PaperHoldsWhatThereIsAgainstThePaper) {
  const StudyFolder folder;
  const std::string page = folder.file("page.md");
  const Result none = run(campaign({"paper", folder.file(""), "--out", page}));
  EXPECT_EQ(none.exit_code, 6);
  expect_has(none.err, "holds none of homogeneous_sand.sqlite");

  folder.write("homogeneous_sand.toml", folder.read("small.toml"));
  ASSERT_EQ(
      run(campaign({folder.file("homogeneous_sand.toml"), "--executor", FAKE_REALIZATION, "--no-report"}))
          .exit_code,
      0);
  const Result result = run(campaign({"paper", folder.file(""), "--out", page}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  expect_has(result.out, page);
  expect_has(folder.read("page.md"), "| homogeneous_sand | quick | 6 of 6 realizations completed |");
  expect_has(folder.read("page.md"), "homogeneous_clay has not been run");
}

TEST(CommandLine, ListsQuantitiesInThreeFormats) {
  expect_has(run(campaign({"list", "quantities"})).out, "clay.s_u_kPa");
  expect_has(run(campaign({"list", "quantities", "--format", "csv"})).out,
             "name,unit,range,default,meaning,symbol,source");
  expect_has(run(campaign({"list", "quantities", "--format", "json"})).out, "\"clay.s_u_kPa\"");
  for (const char* what : {"profiles", "presets", "queries", "outcomes"})
    EXPECT_EQ(run(campaign({"list", what})).exit_code, 0) << what;
}

TEST(CommandLine, ElementTestsEndAtTheCriticalStateAndAtTwiceTheStrength) {
  const StudyFolder folder;
  const std::string csv = folder.file("sand.csv");
  const Result sand = run(campaign({"element", "triaxial", "--D_r_percent", "51", "--p0_kPa", "320",
                                    "--strain_percent", "200", "--steps", "2000", "--csv", csv}));
  ASSERT_EQ(sand.exit_code, 0) << sand.err;
  const std::string rows = folder.read("sand.csv");
  ASSERT_EQ(rows.substr(0, rows.find_first_of("\r\n")), "eps_a,eps_v,q_kPa,p_kPa,e,psi,p_i_kPa");
  const std::size_t last = rows.rfind('\n', rows.size() - 2) + 1;
  double eps_a = 0.0, eps_v = 0.0, q = 0.0, p = 0.0;
  ASSERT_EQ(std::sscanf(rows.c_str() + last, "%lf,%lf,%lf,%lf", &eps_a, &eps_v, &q, &p), 4);
  EXPECT_NEAR(eps_a, 2.0, 1e-9);
  EXPECT_NEAR(q / p, 1.2, 0.01);  // M_tc of phi_cs = 30 deg

  const Result clay = run(campaign({"element", "triaxial", "--undrained", "--material", "clay", "--set",
                                    "clay.s_u_kPa=33.5", "--csv", folder.file("clay.csv")}));
  ASSERT_EQ(clay.exit_code, 0) << clay.err;
  const std::string clay_rows = folder.read("clay.csv");
  const std::size_t clay_last = clay_rows.rfind('\n', clay_rows.size() - 2) + 1;
  ASSERT_EQ(std::sscanf(clay_rows.c_str() + clay_last, "%lf,%lf,%lf,%lf", &eps_a, &eps_v, &q, &p), 4);
  EXPECT_NEAR(q, 67.0, 1e-6);
}

}  // namespace
}  // namespace cpt::tests

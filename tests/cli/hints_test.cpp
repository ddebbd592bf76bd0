// What the program says to words, files and statements that are nearly right.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

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
      {{"push", folder.study(), "--set", "sand.s_u_kPa=40"},
       "s_u_kPa is a parameter of tresca (no soil here); sand is of norsand"},
      {{"element", "triaxial", "--material", "clay", "--set", "cly.s_u_kPa=40"},
       "did you mean clay.s_u_kPa?"},
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
      {{"diagnose", database}, "is a database, not a request"},
      {{"diagnose", folder.study()}, "is a study, not a request; run, rerun"},
      {{"diagnose", folder.file("plan.toml")}, "is a plan of concealed cases, not a request"},
      {{"conceal", folder.study()}, "is a study, not a plan of concealed cases"},
      {{"recording", folder.study()}, "small.toml: is a study, not a recording; run, rerun"},
      {{"recording", database}, "is a database, not a recording"},
      {{"element", "calibrate", folder.study()}, "is a study, not a triaxial test"},
      {{"import", database, "--study", folder.study(), "--to", folder.file("new.sqlite")},
       "is a database, not a table"},
      {{"run", folder.file("request.toml")}, "is a request, not a study; campaign diagnose"},
      {{"query", folder.file("request.toml"), "tornado"}, "is a request, not a study"},
  });
  // Whatever it is called, a database is taken where one is wanted.
  EXPECT_EQ(run(campaign({"query", folder.file("copy.toml"), "realizations"})).exit_code, 0);
}

// Each used to wait for ever, or to call what it met a damaged file.
TEST(Hints, WhatIsNoFileIsRefusedAtOnceWithItsCause) {
  const StudyFolder folder;
  const std::string pipe = folder.file("pipe.toml"), database = folder.file("pipe.sqlite"),
                    socket = folder.file("socket");
  for (const std::string& name : {pipe, database}) ASSERT_EQ(::mkfifo(name.c_str(), 0600), 0);
  const int listening = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  ASSERT_LT(socket.size(), sizeof address.sun_path);
  socket.copy(address.sun_path, socket.size());
  ASSERT_EQ(::bind(listening, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  expect_refused({
      {{pipe}, "pipe.toml: cannot be read as a study (is a pipe to which nobody writes)"},
      {{"run", pipe, "--plan"}, "cannot be read as a study (is a pipe"},
      {{"query", pipe, "realizations"}, "cannot be read as a study (is a pipe"},
      {{"report", pipe}, "cannot be read as a study (is a pipe"},
      {{"export", pipe}, "cannot be read as a study (is a pipe"},
      {{"compare", pipe, folder.study()}, "cannot be read as a study (is a pipe"},
      {{"push", pipe}, "cannot be read as a study (is a pipe"},
      {{"diagnose", pipe}, "cannot be read as a request (is a pipe"},
      {{"conceal", pipe}, "cannot be read as a plan of concealed cases (is a pipe"},
      {{"recording", pipe}, "cannot be read as a recording (is a pipe"},
      {{"recording", "/"}, "/: cannot be read as a recording (Is a directory)"},
      {{"element", "calibrate", pipe, socket}, "pipe.toml: cannot be read as a triaxial test (is a pipe"},
      {{"element", "calibrate", pipe, socket}, "socket: cannot be read as a triaxial test (is a socket)"},
      {{"import", pipe, "--study", folder.study(), "--to", folder.file("new.sqlite")},
       "cannot be read as a table (is a pipe"},
  });
  const Bad no_databases[] = {
      {{"query", database, "realizations"}, "pipe.sqlite: is a pipe, not a database"},
      {{"report", database}, "is a pipe, not a database"},
      {{"report", database, "--watch"}, "is a pipe, not a database"},
      {{"export", database}, "is a pipe, not a database"},
      {{"compare", database, database}, "is a pipe, not a database"},
      {{"query", socket, "realizations"}, "socket: is a socket, not a database"},
      {{"query", "/dev/zero", "realizations"}, "/dev/zero: is a device, not a database"},
      {{"query", "/", "realizations"}, "/: is a folder, not a database"},
  };
  for (const Bad& bad : no_databases) {
    const Result result = run(campaign(bad.arguments));
    EXPECT_EQ(result.exit_code, 6) << bad.message;
    expect_has(result.err, bad.message);
  }
  ::close(listening);
}

TEST(Hints, APipeThatSomebodyWritesToIsReadAsAFile) {
  const StudyFolder folder;
  folder.write("test.csv", "eps_a_percent,q_kPa\n0,0\n1,x\n2,3\n");
  folder.write("a.gef", "#GEFID = 1, 1, 0\n");
  const auto shell = [&](const std::string& script) {
    return run(
        {"/bin/bash", "-c", "cd " + folder.file("") + "; campaign=" + campaign({}).front() + "; " + script});
  };
  for (const char* script : {"(sleep 0.1; cat small.toml) | $campaign run /dev/stdin --plan",
                             "$campaign run <(sleep 0.1; cat small.toml) --plan"}) {
    const Result plan = shell(script);
    EXPECT_EQ(plan.exit_code, 0) << plan.err;
    expect_has(plan.out, "sand.H");
  }
  expect_has(shell("$campaign element calibrate <(cat test.csv)").err, ":3:3: q_kPa: 'x' is not a number");
  expect_has(shell("$campaign recording <(cat a.gef)").err, "#EOH");
  expect_has(shell("$campaign run <(:)").err, "is a pipe to which nobody writes");
}

TEST(Hints, ASignalThatEndsTheWaitForAPipeIsNoFaultOfTheFile) {
  const StudyFolder folder;
  const std::string pipe = folder.file("pipe.toml");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int writer = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);  // who says nothing
  Background waiting(campaign({pipe}), {});
  const auto reads = [&] {
    std::error_code gone;
    for (const auto& open :
         std::filesystem::directory_iterator("/proc/" + std::to_string(waiting.pid()) + "/fd", gone))
      if (std::filesystem::read_symlink(open, gone) == pipe) return true;
    return false;
  };
  EXPECT_TRUE(eventually(reads));
  EXPECT_TRUE(eventually([&] { return ::kill(waiting.pid(), SIGTERM) != 0 || !alive(waiting.pid()); }));
  const Result result = waiting.wait();
  EXPECT_EQ(result.exit_code, 143);
  expect_has(result.err, "pipe.toml: a signal ended the wait for it");
  ::close(writer);
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

TEST(Hints, ColumnsWithoutNamesNameTheOption) {
  const StudyFolder folder;
  folder.write("odd.csv", "z,q\n0.1,2\n0.2,3\n");
  expect_refused(
      {{{"recording", folder.file("odd.csv")}, "expected --column q_c_MPa=NAME, or in a request columns"},
       {{"recording", folder.file("odd.csv")}, "expected --column depth_m=NAME"},
       {{"recording", folder.file("odd.csv")}, "columns of the file: z,q"}});
}

TEST(Hints, TheVerdictOnNoiseSaysWhichNoise) {
  const StudyFolder folder;
  const auto ask = [&](const char* what) {
    EXPECT_EQ(
        run(campaign({folder.study(), "--executor", FAKE_REALIZATION, "--no-report", "--quiet"})).exit_code,
        0);
    return run(campaign({"query", folder.study(), what})).err;
  };
  for (const char* what : {"sensitivity", "tornado"})
    expect_has(ask(what),
               "note: above_noise in deep: |si| > si_noise, the spread of the baseline inside the window");
  folder.write("small.toml", "repeats = 4\n" + folder.read("small.toml"));
  expect_has(ask("tornado"), "note: above_noise in deep: |si| > si_half_width, half the 95 % interval");
}

TEST(Hints, CampaignsWithoutACommonWindowAreToldSo) {
  const StudyFolder folder;
  std::string other = folder.read("small.toml");
  other.replace(other.find("\"deep\""), 6, "\"deeper\"");
  folder.write("other.toml", other);
  for (const char* study : {"small.toml", "other.toml"})
    ASSERT_EQ(run(campaign({folder.file(study), "--executor", FAKE_REALIZATION, "--no-report", "--quiet"}))
                  .exit_code,
              0);
  for (const char* what : {"means", "sensitivity"}) {
    const Result result = run(campaign({"compare", folder.study(), folder.file("other.toml"), what}));
    EXPECT_EQ(result.exit_code, 0);
    expect_has(result.err, "no window of a has the name of one of b");
    expect_has(result.err, "a has deep (0.5054 to 0.5255 m); b has deeper (0.5054 to 0.5255 m)");
    EXPECT_EQ(run(campaign({"compare", folder.study(), folder.study(), what})).err, "");
  }
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

TEST(Hints, LayersThatCannotBeMadeAreRefusedAndWhatIsOffIsTold) {
  const StudyFolder folder;
  const auto study = [&](const std::string& bottom) {
    folder.write(
        "seam.toml",
        "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[fixed]\n\"penetrometer.final_depth_m\" = 0.1\n"
        "\"interface_mixing.thickness_mm\" = 3\n"
        "[parameters]\n\"sand.H\" = { upper = 75 }\n[[windows]]\nname = \"w\"\nfrom_m = 0.03\nto_m = 0.09\n"
        "[[layers]]\ntop_m = 0\nbottom_m = 0.06\nsoil = \"sand\"\n[[layers]]\ntop_m = 0.06\nbottom_m = " +
            bottom + "\nsoil = \"clay\"\n[[layers]]\ntop_m = " + bottom +
            "\nbottom_m = 1\nsoil = \"sand\"\n");
    return folder.file("seam.toml");
  };
  for (const char* how : {"--validate", "--plan", "--no-report"}) {
    const Result refused = run(campaign({"run", study("0.062"), how, "--executor", FAKE_REALIZATION}));
    EXPECT_EQ(refused.exit_code, 2) << how;
    expect_has(refused.err, "seam.toml:16:");
    expect_has(refused.err,
               "error: layers: the clay from 0.06 to 0.062 m, 2 mm thick, is lower than a cell around the "
               "tip, 6.33 mm");
    const Result told = run(campaign({"run", study("0.076"), how, "--executor", FAKE_REALIZATION}));
    EXPECT_EQ(told.exit_code, 0) << how << told.err << told.out;
    expect_has(told.out, "note: the mixed zone, 3 mm thick, lies between rows of material points");
  }
  ASSERT_EQ(run(campaign({"report", folder.file("seam.toml")})).exit_code, 0);
  expect_has(folder.read("seam-report/index.html"), "the mixed zone, 3 mm thick");
  expect_has(folder.read("seam-report/report.json"), "\"remarks\": [");
}

}  // namespace
}  // namespace cpt::tests

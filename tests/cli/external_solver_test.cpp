// Another program as the solver of a study, from the command line: shell and awk programs that are on every
// machine, run by the program itself. Nothing here stands in for anything.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

namespace fs = std::filesystem;

// Ishigami's function; where the study's folder has a file "gated", runs with x3 above 0.9 wait for one
// called "gate" and say who they are.
constexpr const char* ishigami = R"sh(
read -r inputs
set -- $(echo "$inputs" | tr -c '0-9.e+-' ' ' | awk '{ print $2, $4, $6 }')
if [ -e "$CAMPAIGN_STUDY_FOLDER/gated" ] && awk "BEGIN { exit !($3 > 0.9) }"; then
  echo $$ >> "$CAMPAIGN_STUDY_FOLDER/waiting"
  while [ ! -e "$CAMPAIGN_STUDY_FOLDER/gate" ]; do sleep 0.02; done
fi
awk "BEGIN { printf \"{\\\"f\\\": %.17g}\", sin($1) + 7 * sin($2)^2 + 0.1 * ($3)^4 * sin($1) }"
)sh";

std::string ishigami_study(int rows, const std::string& more = "") {
  std::string study = "[solver]\ncommand = [\"sh\", \"ishigami.sh\"]\n" + more +
                      "[solver.inputs]\nx1 = 0\nx2 = 0\nx3 = { default = 0, min = -3.2, max = 3.2 "
                      "}\n[solver.outputs]\nf = {}\n"
                      "[parameters]\n";
  for (const char* x : {"x1", "x2", "x3"})
    study += std::string(x) + " = { lower = -3.14159, upper = 3.14159 }\n";
  return study + "[design]\nkind = \"sobol\"\nruns = " + std::to_string(rows) + "\n";
}

// What a table in CSV says, by column.
std::map<std::string, std::vector<std::string>> columns_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  std::vector<std::string> names;
  const auto cells = [](const std::string& text) {
    std::vector<std::string> found(1);
    bool quoted = false;
    for (const char c : text)
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        found.emplace_back();
      else
        found.back() += c;
    return found;
  };
  names = cells(line);
  std::map<std::string, std::vector<std::string>> columns;
  while (std::getline(lines, line)) {
    const std::vector<std::string> values = cells(line);
    for (std::size_t k = 0; k < names.size() && k < values.size(); ++k)
      columns[names[k]].push_back(values[k]);
  }
  return columns;
}

class ExternalSolver : public testing::Test {
 protected:
  void SetUp() override { folder.write("ishigami.sh", ishigami); }

  std::string study(const std::string& text) {
    folder.write("other.toml", text);
    return folder.file("other.toml");
  }
  Result campaign_of(const std::string& text, std::vector<std::string> more = {"--no-report"}) {
    more.insert(more.begin(), study(text));
    return run(campaign(more));
  }
  // Of the database, in CSV.
  std::string asked(const std::string& what, const std::string& sql = "") {
    std::vector<std::string> words = {"query", folder.file("other.toml"), what};
    if (!sql.empty()) words.push_back(sql);
    words.insert(words.end(), {"--format", "csv"});
    const Result answer = run(campaign(words));
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    return answer.out;
  }
  std::string results() {
    return asked("sql",
                 "select id, parameter, side, status, reason, settings_hash, outputs from realization "
                 "left join curve on realization = id order by id") +
           asked("windows") + asked("effects");
  }

  // Nothing is called after what is not there.
  void expect_no_push_in_report() {
    for (const auto& entry : fs::directory_iterator(folder.file("other-report"))) {
      const std::string ending = entry.path().extension();
      if (ending != ".csv" && ending != ".svg" && ending != ".json") continue;
      const std::string content = folder.read("other-report/" + entry.path().filename().string());
      for (const char* word : {"q_c", "energy_error", "depth_m"})
        EXPECT_EQ(content.find(word), std::string::npos) << entry.path() << ": " << word;
    }
  }

  StudyFolder folder;
};

TEST_F(ExternalSolver, FindsTheIndicesOfIshigamisFunction) {
  const Result result = campaign_of(ishigami_study(32));
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  // The numbers are the program's.
  const auto samples = columns_of(asked(
      "sql",
      "select max(case quantity when 'x1' then value end) as x1, max(case quantity when 'x2' then value end) "
      "as x2, max(case quantity when 'x3' then value end) as x3, q_c_mean_kPa as f from realization_input "
      "join window_mean using (realization) group by realization"));
  ASSERT_EQ(samples.at("f").size(), 1U + 6U + 32U * 5U);
  for (std::size_t k = 0; k < samples.at("f").size(); ++k) {
    const auto x = [&](const char* name) { return std::stod(samples.at(name)[k]); };
    EXPECT_NEAR(x("f"),
                std::sin(x("x1")) + 7 * std::pow(std::sin(x("x2")), 2) +
                    0.1 * std::pow(x("x3"), 4) * std::sin(x("x1")),
                1e-12);
  }
  // Saltelli et al. (2008), Ishigami with a = 7, b = 0.1: what the intervals of the estimator have to hold.
  const std::map<std::string, double> truth = {{"first_order x1", 0.3139}, {"first_order x2", 0.4424},
                                               {"first_order x3", 0.0},    {"total_order x1", 0.5576},
                                               {"total_order x2", 0.4424}, {"total_order x3", 0.2437}};
  const auto effects = columns_of(asked("effects"));
  std::size_t found = 0;
  for (std::size_t k = 0; k < effects.at("value").size(); ++k) {
    const auto known = truth.find(effects.at("quantity")[k] + " " + effects.at("parameter")[k]);
    if (known == truth.end()) continue;
    ++found;
    EXPECT_LE(std::stod(effects.at("lower")[k]) - 0.1, known->second) << known->first;
    EXPECT_GE(std::stod(effects.at("upper")[k]) + 0.1, known->second) << known->first;
  }
  EXPECT_EQ(found, truth.size());
  EXPECT_FALSE(fs::exists(folder.file("other.work"))) << "nothing of completed runs is left";
  EXPECT_FALSE(fs::exists(folder.file("other.checkpoints")));
}

TEST_F(ExternalSolver, RanksDoNotChangeAResultAndRerunAgrees) {
  ASSERT_EQ(campaign_of(ishigami_study(2)).exit_code, 0);
  const std::string alone = results();
  fs::remove(folder.file("other.sqlite"));
  const Result ranks = run(mpirun(2, {folder.file("other.toml"), "--no-report"}));
  ASSERT_EQ(ranks.exit_code, 0) << ranks.err;
  EXPECT_EQ(results(), alone);
  const Result again = run(campaign({"rerun", folder.file("other.toml"), "5"}));
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
  EXPECT_NE(again.out.find("its outputs are identical bit for bit"), std::string::npos) << again.out;
  EXPECT_FALSE(fs::exists(folder.file("other.rerun-0005")));
}

TEST_F(ExternalSolver, KilledMasterTakesItsProgramsAlongAndResumesToTheSame) {
  ASSERT_EQ(campaign_of(ishigami_study(2)).exit_code, 0);
  const std::string undisturbed = results();
  for (const char* file : {"other.sqlite", "other.h5"}) fs::remove(folder.file(file));
  folder.write("gated", "");
  Background job(mpirun(2, {folder.file("other.toml"), "--no-report", "--slots", "1"}), {});
  const auto waiting = [&] {
    std::vector<pid_t> pids;
    std::ifstream lines(folder.file("waiting"));
    for (pid_t pid = 0; lines >> pid;) pids.push_back(pid);
    return pids;
  };
  ASSERT_TRUE(eventually([&] { return waiting().size() == 2; })) << job.err_so_far();
  const std::vector<pid_t> programs = waiting();
  const std::vector<pid_t> ranks = children_of(job.pid());
  ASSERT_EQ(ranks.size(), 2U);
  ASSERT_EQ(::kill(ranks.front(), SIGKILL), 0);
  EXPECT_NE(job.wait().exit_code, 0);
  EXPECT_TRUE(eventually([&] { return std::none_of(programs.begin(), programs.end(), alive); }))
      << "programs go with their campaign";
  folder.write("gate", "");
  const Result resumed = run(mpirun(2, {folder.file("other.toml"), "--no-report"}));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("kept: completed before with the same settings"), std::string::npos)
      << resumed.err;
  EXPECT_EQ(results(), undisturbed);
}

// A program that does what its input says.
std::string failing_study(const std::string& points, const std::string& limits = "") {
  return "[solver]\ncommand = [\"sh\", \"fail.sh\"]\n[solver.inputs]\nway = 0\n[solver.outputs]\nf = {}\n"
         "s = { over = \"t\" }\n" +
         limits + points;
}
constexpr const char* failing = R"sh(
way=$(tr -c '0-9' ' ' < inputs.json)
case $((way)) in
  1) echo "no such material" >&2; exit 3 ;;
  2) kill -SEGV $$ ;;
  3) echo '<html>rubbish</html>' ;;
  4) echo '{"f": NaN, "t": [1], "s": [1]}' ;;
  5) echo '{"f": 1, "t": [1, 2], "s": [1]}' ;;
  6) echo '{"f": 1}' ;;
  7) awk 'BEGIN { while (1) print "much" }' ;;
  8) (sleep 100000 & echo $! > "$CAMPAIGN_STUDY_FOLDER/left"); echo '{"f": 1, "t": [1], "s": [1]}' ;;
  9) sleep 100000 & sleep 100000 ;;
  10) ;;
  *) echo '{"f": 1, "t": [1, 2], "s": [3, 4]}' ;;
esac
)sh";

TEST_F(ExternalSolver, FailuresAreOnRecordAndTheOthersGoOn) {
  folder.write("fail.sh", failing);
  std::string points;
  for (const char* way : {"1", "2", "3", "4", "5", "6", "7", "8", "10"})
    points += std::string("[[points]]\nname = \"way ") + way + "\"\nway = " + way + "\n";
  const Result result = campaign_of(failing_study(points, "[limits]\nmost_megabytes = 0.1\n"));
  EXPECT_EQ(result.exit_code, 1) << result.err;
  const auto runs = columns_of(asked("sql", "select parameter, status, reason from realization order by id"));
  const std::map<std::string, std::pair<std::string, std::string>> expected = {
      {"way 1", {"crashed", "exit code 3; its last words: no such material"}},
      {"way 2", {"crashed", "killed by signal 11 (Segmentation fault)"}},
      {"way 3", {"crashed", "its results have no f (standard output)"}},
      {"way 4", {"did_not_converge", "its results hold NaN or an infinite number (standard output)"}},
      {"way 5", {"crashed", "s has 1 numbers and its abscissa t has 2 (standard output)"}},
      {"way 6", {"crashed", "its results have no s (standard output)"}},
      {"way 7", {"crashed", "wrote more than 0.1 MB"}},
      {"way 8", {"completed", ""}},
      {"way 10", {"crashed", "it wrote no results (standard output)"}}};
  for (std::size_t k = 1; k < runs.at("status").size(); ++k) {
    const auto& [status, reason] = expected.at(runs.at("parameter")[k]);
    EXPECT_EQ(runs.at("status")[k], status) << runs.at("parameter")[k];
    EXPECT_EQ(runs.at("reason")[k].substr(0, reason.size()), reason) << runs.at("parameter")[k];
  }
  EXPECT_NE(result.err.find("the program left 1 process behind, which was ended"), std::string::npos)
      << result.err;
  EXPECT_TRUE(eventually([&] { return !alive(static_cast<pid_t>(std::stoi(folder.read("left")))); }));
  // The work folders of failed ones, and of no other, are there to be looked at.
  EXPECT_TRUE(fs::exists(folder.file("other.work/0002/inputs.json")));
  EXPECT_EQ(folder.read("other.work/0002/stderr.txt"), "no such material\n");
  EXPECT_FALSE(fs::exists(folder.file("other.work/0001")));
}

TEST_F(ExternalSolver, LimitsOfTimeEndTheWholeGroup) {
  folder.write("fail.sh", failing);
  const std::string hangs = "[fixed]\nway = 9\n";
  for (const auto& [limits, reason] :
       {std::pair("[limits]\nwall_minutes = 0.005\n", "reached its wall-clock limit of 0.3 s"),
        std::pair("[limits]\nhang_minutes = 0.005\n", "hung: wrote nothing for 0.3 s")}) {
    const Result result = campaign_of(failing_study(hangs, limits), {"--no-report", "--retry-failed"});
    EXPECT_EQ(result.exit_code, 1) << result.err;
    const auto runs = columns_of(asked("failures"));
    EXPECT_EQ(runs.at("status"), std::vector<std::string>{"time_limit"});
    EXPECT_EQ(runs.at("reason").front().substr(0, 60), reason);
  }
}

TEST_F(ExternalSolver, ThatIsNotThereIsAFailureOfEachRun) {
  const std::string text =
      "[solver]\ncommand = [\"no-such-program\"]\n[solver.inputs]\nx = 0\n[solver.outputs]\nf = {}\n";
  EXPECT_EQ(campaign_of(text).exit_code, 1);
  EXPECT_NE(asked("failures").find("cannot start no-such-program: No such file or directory"),
            std::string::npos);
  const Result checked = campaign_of(text, {"--validate"});
  EXPECT_EQ(checked.exit_code, 2);
  EXPECT_NE(checked.out.find("no-such-program: there is no such program"), std::string::npos) << checked.out;
}

TEST_F(ExternalSolver, RunsAgainAfterACrashAndFindsItsCheckpoints) {
  folder.write("twice.sh",
               "if [ ! -e \"$CAMPAIGN_CHECKPOINTS/state\" ]; then echo 7 > \"$CAMPAIGN_CHECKPOINTS/state\"; "
               "exit 9; fi\n"
               "echo \"{\\\"f\\\": $(cat \"$CAMPAIGN_CHECKPOINTS/state\")}\"\n");
  const std::string text =
      "[solver]\ncommand = [\"sh\", \"twice.sh\"]\n[solver.inputs]\nx = 0\n[solver.outputs]\nf = {}\n";
  const Result again = campaign_of(text + "[limits]\nretries = 1\n");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.err.find("try 1 of 2: exit code 9; runs again"), std::string::npos) << again.err;
  EXPECT_EQ(columns_of(asked("windows")).at("mean"), std::vector<std::string>{"7"});
  EXPECT_FALSE(fs::exists(folder.file("other.checkpoints"))) << "they go with the end of the run";
}

TEST_F(ExternalSolver, AnotherVersionDoesNotTakeOldResults) {
  ASSERT_EQ(campaign_of(ishigami_study(2, "version = \"1\"\n")).exit_code, 0);
  const Result same = campaign_of(ishigami_study(2, "version = \"1\"\n"));
  EXPECT_NE(same.err.find("17 realizations kept"), std::string::npos) << same.err;
  const Result other = campaign_of(ishigami_study(2, "version = [\"echo\", \"2.1\"]\n"), {"--plan"});
  EXPECT_NE(other.out.find("version 2.1"), std::string::npos) << other.out;
  EXPECT_NE(other.out.find("made by solver version 1, this is 2.1: kept but unused"), std::string::npos)
      << other.out;
  EXPECT_EQ(other.out.find("17 realizations kept"), std::string::npos) << other.out;
  const Result none =
      campaign_of(ishigami_study(2, "version = [\"sh\", \"-c\", \"echo broken; exit 4\"]\n"), {"--plan"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("solver.version: exit code 4; its last words: broken"), std::string::npos)
      << none.err;
}

TEST_F(ExternalSolver, IsAskedElsewhereAndTold) {
  const std::string text = ishigami_study(2);
  const Result asks = campaign_of(text, {"--plan", "--format", "csv"});
  ASSERT_EQ(asks.exit_code, 0) << asks.err;
  EXPECT_EQ(asks.out.substr(0, asks.out.find('\n')), "realization,name,x1,x2,x3");
  const auto points = columns_of(asks.out);
  ASSERT_EQ(points.at("name").size(), 17U);
  EXPECT_EQ(points.at("name").front(), "baseline");
  EXPECT_EQ(points.at("name")[1], "x1 lower");
  EXPECT_FALSE(fs::exists(folder.file("other.sqlite"))) << "nothing has run";
  // Somebody else finds the results, in another order.
  std::string told = "f,x3,x2,x1,name\n";
  for (std::size_t k = 17; k-- > 0;) {
    const auto x = [&](const char* name) { return std::stod(points.at(name)[k]); };
    std::ostringstream f;
    f.precision(17);
    f << std::sin(x("x1")) + 7 * std::pow(std::sin(x("x2")), 2) +
             0.1 * std::pow(x("x3"), 4) * std::sin(x("x1"));
    told += f.str() + "," + points.at("x3")[k] + "," + points.at("x2")[k] + "," + points.at("x1")[k] + "," +
            points.at("name")[k] + "\n";
  }
  folder.write("told.csv", told);
  const Result import = run(campaign({"import", folder.file("told.csv"), "--study", folder.file("other.toml"),
                                      "--to", folder.file("told.sqlite")}));
  ASSERT_EQ(import.exit_code, 0) << import.out << import.err;
  EXPECT_NE(import.out.find("17 realizations, 17 completed, 0 failed"), std::string::npos) << import.out;
  ASSERT_EQ(campaign_of(text).exit_code, 0);
  const auto own = columns_of(asked("effects"));
  const auto imported =
      columns_of(run(campaign({"query", folder.file("told.sqlite"), "effects", "--format", "csv"})).out);
  ASSERT_EQ(imported.at("quantity"), own.at("quantity"));
  for (std::size_t k = 0; k < own.at("value").size(); ++k)
    EXPECT_NEAR(std::stod(imported.at("value")[k]), std::stod(own.at("value")[k]), 1e-9);
}

TEST_F(ExternalSolver, CurvesAndTheirTemplate) {
  const fs::path source = fs::path(CPT_SOURCE) / "examples/external";
  for (const char* file : {"consolidation.in", "consolidation.awk"}) {
    std::ifstream stream(source / file);
    folder.write(file, {std::istreambuf_iterator<char>(stream), {}});
  }
  std::ifstream stream(source / "consolidation.toml");
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const Result result = campaign_of(text, {});
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  const auto means = columns_of(asked("windows"));
  // The baseline: m_v times load times thickness, in millimetres; and the mean of the series of Terzaghi
  // (1943) over its eight times within the first year.
  double mean = 0.0;
  for (int days = 50; days <= 350; days += 50) {
    double share = 1.0;
    for (int m = 0; m < 100; ++m) {
      const double M = 2.0 * std::atan(1.0) * (2 * m + 1);
      share -= 2.0 / (M * M) * std::exp(-M * M * 2.0 * days / 365.0 / 16.0);
    }
    mean += 200.0 * share / 8.0;
  }
  ASSERT_EQ(means.at("window")[0], "final");
  EXPECT_NEAR(std::stod(means.at("mean")[0]), 200.0, 1e-9);
  EXPECT_EQ(means.at("output_unit")[0], "mm");
  EXPECT_EQ(means.at("min")[0], "") << "a scalar has no spread";
  ASSERT_EQ(means.at("window")[7], "first_year");
  EXPECT_NEAR(std::stod(means.at("mean")[7]), mean, 1e-6);
  EXPECT_EQ(means.at("bins")[7], "8");
  expect_no_push_in_report();
  const std::string figure = folder.read("other-report/tornado_first_year.svg");
  EXPECT_NE(figure.find("average settlement</tspan><tspan> (mm)"), std::string::npos);
  EXPECT_NE(figure.find("time 0–365 d"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder.file("other-report/profiles.svg")));
}

// How the numbers of a design settle, too.
TEST_F(ExternalSolver, DesignsAreDrawnInTheOutputsUnit) {
  std::string text = ishigami_study(8);
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("f = {}", "f = { unit = \"mm\" }");
  replace("kind = \"sobol\"\nruns", "kind = \"morris\"\ntrajectories");
  ASSERT_EQ(campaign_of(text, {}).exit_code, 0);
  expect_no_push_in_report();
  const std::string figure = folder.read("other-report/convergence_f.svg");
  EXPECT_NE(figure.find("<tspan> (mm)"), std::string::npos) << figure;
  for (const char* word : {"kPa", "average", "nan"})
    EXPECT_EQ(figure.find(word), std::string::npos) << word << " in " << figure;
}

// An emulator of a scalar, of a window and of a curve over the program's own abscissa, each in its own unit.
TEST_F(ExternalSolver, IsEmulatedAndPredicted) {
  folder.write("decay.awk", R"awk({
  gsub(/[^0-9.e+-]+/, " "); a = $1; b = $2
  printf "{\"product\": %.17g, \"time\": [0, 1, 2, 3, 4], \"load\": [", a * b
  for (t = 0; t < 5; ++t) printf "%s%.17g", t ? ", " : "", a * exp(-b * t)
  print "]}" })awk");
  const Result ran = campaign_of(
      "[solver]\ncommand = [\"awk\", \"-f\", \"decay.awk\"]\n[solver.inputs]\na = 2\nb = 0.5\n"
      "[solver.outputs]\nproduct = { unit = \"mm\" }\nload = { unit = \"kN\", over = \"time\", over_unit = "
      "\"d\" }\n"
      "[parameters]\na = { lower = 1, upper = 3 }\nb = { lower = 0.4, upper = 0.6 }\n"
      "[[windows]]\nname = \"late\"\noutput = \"load\"\nfrom = 2\nto = 4\n"
      "[design]\nkind = \"latin_hypercube\"\nruns = 40\n");
  ASSERT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  const Result made = run(campaign({"emulate", folder.file("other.toml"), "--format", "csv"}));
  ASSERT_EQ(made.exit_code, 0) << made.out << made.err;
  EXPECT_EQ(columns_of(made.out).at("output"),
            (std::vector<std::string>{"product", "late.load_mean", "load"}));
  EXPECT_EQ(columns_of(made.out).at("unit"), (std::vector<std::string>{"mm", "kN", "kN"}));
  const Result at = run(campaign({"predict", folder.file("other.toml"), "--set", "a=2.5", "--set", "b=0.45",
                                  "--curves", folder.file("curve.csv"), "--format", "csv"}));
  ASSERT_EQ(at.exit_code, 0) << at.err;
  const auto averages = columns_of(at.out), curve = columns_of(folder.read("curve.csv"));
  EXPECT_NEAR(std::stod(averages.at("value")[0]), 2.5 * 0.45, 0.01);
  EXPECT_EQ(averages.at("unit")[0], "mm");
  const double late = 2.5 / 3.0 * (std::exp(-0.9) + std::exp(-1.35) + std::exp(-1.8));
  EXPECT_NEAR(std::stod(averages.at("value")[1]), late, 0.01);
  ASSERT_EQ(curve.at("time_d").size(), 5U);
  EXPECT_NEAR(std::stod(curve.at("value")[3]), 2.5 * std::exp(-1.35), 0.01);
  EXPECT_EQ(curve.at("unit")[3], "kN");
  const Result next = run(campaign({"emulate", folder.file("other.toml"), "--next", "2"}));
  EXPECT_EQ(next.exit_code, 0) << next.err;
  EXPECT_NE(next.out.find("[[points]]"), std::string::npos) << next.out;
}

TEST_F(ExternalSolver, CommandsAboutPushesRefuseIt) {
  (void)study(ishigami_study(2));
  const Result result = run(campaign({"push", folder.file("other.toml")}));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("its solver is another program"), std::string::npos) << result.err;
}

// The first thing that a user of Python tries.
TEST_F(ExternalSolver, ExampleInPython) {
  if (run({"python3", "--version"}).exit_code != 0) GTEST_SKIP() << "python3 is not installed";
  const fs::path source = fs::path(CPT_SOURCE) / "examples/external";
  std::ifstream script(source / "ishigami.py");
  folder.write("ishigami.py", {std::istreambuf_iterator<char>(script), {}});
  const Result result = campaign_of(
      "[solver]\ncommand = [\"python3\", \"ishigami.py\"]\n[solver.inputs]\nx1 = 1.5707963267948966\nx2 = "
      "0.0\nx3 = 2.0\n"
      "[solver.outputs]\nf = {}\n");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NEAR(std::stod(columns_of(asked("windows")).at("mean").front()), 2.6, 1e-15);
}

// The code of the notebook, cell by cell, as Jupyter would run it.
TEST_F(ExternalSolver, NotebookRuns) {
  if (run({"/usr/bin/python3", "-c", "import pandas, numpy"}).exit_code != 0)
    GTEST_SKIP() << "python3 with pandas is not installed";
  ASSERT_EQ(run(campaign({folder.study(), "--executor", FAKE_REALIZATION, "--no-report"})).exit_code, 0);
  const std::string notebook = (fs::path(CPT_SOURCE) / "examples/notebooks/campaign.ipynb").string();
  const Result result =
      run({"/usr/bin/python3", "-c",
           "import json, sys\n"
           "cells = json.load(open(sys.argv[1]))['cells']\n"
           "there = {}\n"
           "for cell in cells:\n"
           "    if cell['cell_type'] == 'code': exec(''.join(cell['source']), there)\n"
           "print(len(there['runs']), list(there['table'].columns), len(there['baseline']) > 1)\n",
           notebook},
          {"CAMPAIGN_DATABASE=" + folder.file("small.sqlite")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out.substr(0, 2), "6 ") << result.out;
  EXPECT_NE(result.out.find("'sand.nu'"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("True"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace cpt::tests

// What is printed cannot be written: a full device, a closed descriptor, a pipe whose reader has gone. No
// command is ended by it, none reports success, and what it does besides is done.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

namespace fs = std::filesystem;

std::string quoted(const Command& command) {
  std::string text;
  for (const std::string& word : command) text += (text.empty() ? "'" : " '") + word + "'";
  return text;
}

Result shell(const std::string& script, const std::vector<std::string>& variables = {}) {
  return run({"/bin/sh", "-c", script}, variables);
}

const std::vector<std::string> law = {"CPT_FAKE=*:law", "CPT_FAKE_SECONDS=0.001"};

// A folder in which every command has what it needs.
class Output : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new StudyFolder;
    folder->write("sand.toml",
                  "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[fixed]\n"
                  "\"penetrometer.final_depth_m\" = 0.30\n[parameters]\n"
                  "\"sand.D_r_percent\" = { baseline = 36, lower = 26, upper = 46 }\n"
                  "[[windows]]\nname = \"w\"\nfrom_m = 0.2\nto_m = 0.22\n");
    std::string recording = "z,q\n";
    for (double z = 0.03; z < 0.30; z += 0.001)
      recording += std::to_string(z) + "," + std::to_string(4.0 * std::sqrt(z) * std::exp(0.045)) + "\n";
    folder->write("a.csv", recording);
    folder->write(
        "d.toml",
        "study = \"sand.toml\"\nmechanisms = [\"density_lens\"]\n[[soundings]]\nrecording = \"a.csv\"\n"
        "columns = { depth_m = \"z\", q_c_MPa = \"q\" }\nfrom_m = 0.04\nto_m = 0.28\n"
        "[noise]\nmeasurement_percent = 1\n[options]\nrepeats = 6\njoint = 4\nconfirm = 0\n");
    folder->write("bench.toml",
                  "study = \"sand.toml\"\nmechanisms = [\"density_lens\"]\n[[soundings]]\nname = \"a\"\n"
                  "from_m = 0.04\nto_m = 0.26\n[noise]\nmeasurement_percent = 1\n"
                  "[options]\nrepeats = 4\njoint = 3\nconfirm = 0\n[cases]\nnothing = 1\nsingle = 1\n");
    ASSERT_EQ(run(campaign({folder->study(), "--quiet", "--executor", FAKE_REALIZATION}), law).exit_code, 0);
    fs::create_directory(folder->file("runs"));
    fs::copy_file(folder->file("small.sqlite"), folder->file("runs/homogeneous_sand.sqlite"));
    ASSERT_EQ(run(campaign({"export", folder->study(), "--format", "dakota"})).exit_code, 0);
    ASSERT_EQ(run(campaign(diagnosis()), law).exit_code, 0);
    ASSERT_EQ(run(campaign(concealed()), law).exit_code, 0);
    for (const char* id : {"1", "2"})
      ASSERT_EQ(run(campaign({"diagnose", folder->file(std::string("bench-cases/case-00") + id + ".toml"),
                              "--no-report", "--quiet", "--executor", FAKE_REALIZATION}),
                    law)
                    .exit_code,
                0);
    ASSERT_EQ(run(campaign(push())).exit_code, 0);
    for (const char* preset : {"quick", "standard"}) write_sample(preset);
    ASSERT_EQ(run(campaign({"emulate", sample()})).exit_code, 0);
    folder->write("prior.toml",
                  "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[parameters]\n"
                  "\"sand.D_r_percent\" = { baseline = 36, lower = 26, upper = 46 }\n"
                  "[fixed]\n\"penetrometer.final_depth_m\" = 0.2\n"
                  "[[windows]]\nname = \"deep\"\nfrom_m = 0.15\nto_m = 0.17\n"
                  "[design]\nkind = \"latin_hypercube\"\nruns = 20\n");
    folder->write("c.toml",
                  "study = \"prior.toml\"\n[[soundings]]\nrecording = \"a.csv\"\n"
                  "columns = { depth_m = \"z\", q_c_MPa = \"q\" }\nfrom_m = 0.04\nto_m = 0.18\n");
    ASSERT_EQ(
        run(campaign({folder->file("prior.toml"), "--no-report", "--quiet", "--executor", FAKE_REALIZATION}),
            law)
            .exit_code,
        0);
    ASSERT_EQ(run(campaign({"emulate", folder->file("prior.toml")})).exit_code, 0);
  }
  static void TearDownTestSuite() { delete folder; }

  // A propagation with its runs: quick.toml, standard.toml.
  static void write_sample(const std::string& preset) {
    folder->write(preset + ".toml", "profile = \"homogeneous_sand\"\npreset = \"" + preset +
                                        "\"\n[parameters]\n"
                                        "\"sand.nu\" = { lower = 0.1, upper = 0.3 }\n"
                                        "\"sand.H\" = { lower = 20, upper = 75 }\n"
                                        "[fixed]\n\"penetrometer.final_depth_m\" = 0.1\n"
                                        "[[windows]]\nname = \"deep\"\nfrom_m = 0.05\nto_m = 0.09\n"
                                        "[design]\nkind = \"propagation\"\nruns = 40\n");
    ASSERT_EQ(run(campaign({folder->file(preset + ".toml"), "--no-report", "--quiet", "--executor",
                            FAKE_REALIZATION}),
                  {"CPT_FAKE_SECONDS=0.001"})
                  .exit_code,
              0);
  }

  static std::string sample() { return folder->file("quick.toml"); }
  static std::vector<std::string> diagnosis() {
    return {"diagnose", folder->file("d.toml"), "--quiet", "--no-report", "--executor", FAKE_REALIZATION};
  }
  static std::vector<std::string> concealed() {
    return {"conceal", folder->file("bench.toml"), "--quiet", "--executor", FAKE_REALIZATION};
  }
  static std::vector<std::string> push() {
    return {
        "push",  folder->study(),     "--fields-every", "0.002", "--set", "penetrometer.final_depth_m=0.024",
        "--out", folder->file("push")};
  }

  // Every command of the program, with a command line that prints something and ends with code 0.
  static std::vector<std::vector<std::string>> commands() {
    const std::string study = folder->study();
    return {{"--help"},
            {"--version"},
            {study, "--executor", FAKE_REALIZATION},
            {study, "--plan"},
            {study, "--validate"},
            {"rerun", study, "2", "--executor", FAKE_REALIZATION},
            {"query", study, "realizations"},
            {"query", study, "sql", "select id from realization", "--format", "csv"},
            {"compare", study, study},
            {"combine", folder->file("standard.toml"), sample()},
            {"emulate", sample()},
            {"predict", sample(), "--set", "sand.H=50"},
            {"calibrate", folder->file("c.toml")},
            {"prune", study},
            {"export", study, "--to", folder->file("tables")},
            {"import", folder->file("small.dat"), "--study", study, "--to", folder->file("copy.sqlite")},
            {"report", study, "--directory", folder->file("page")},
            {"report", study, "--directory", folder->file("page"), "--watch", "--every", "0.1"},
            push(),
            {"view", folder->file("push"), "--out", folder->file("view")},
            {"element", "triaxial", "--p0_kPa", "100", "--steps", "50"},
            {"recording", folder->file("a.csv"), "--column", "depth_m=z", "--column", "q_c_MPa=q", "--out",
             folder->file("a.svg")},
            {"list", "quantities"},
            {"list", "quantities", "--format", "json"},
            {"reference"},
            {"reference", "--man"},
            {"completion", "bash"},
            {"numerics", study, "--out", folder->file("numerics.md")},
            concealed(),
            diagnosis(),
            {"reveal", folder->file("bench.toml"), "--out", folder->file("revealed.md")},
            {"paper", "--out", folder->file("paper.md"), folder->file("runs")}};
  }

  // Runs a command as `{}` in a script.
  static Result run_in(std::string script, const std::vector<std::string>& words) {
    fs::remove(folder->file("copy.sqlite"));  // an import makes a new database
    script.replace(script.find("{}"), 2, quoted(campaign(words)));
    return shell(script, law);
  }

  static StudyFolder* folder;
};

StudyFolder* Output::folder = nullptr;

TEST_F(Output, EveryCommandIsTried) {
  const Result help = run(campaign({"--help"}));
  const std::size_t from = help.out.find("Subcommands:");
  ASSERT_NE(from, std::string::npos) << help.out;
  std::string tried;
  for (const auto& words : commands()) tried += " " + words.front() + " ";
  std::istringstream lines(help.out.substr(from, help.out.find("\n\n", from) - from));
  std::string line;
  std::getline(lines, line);
  int known = 0;
  for (; std::getline(lines, line); ++known) {
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    if (name.empty() || name == "run") continue;  // a study is named without it
    EXPECT_NE(tried.find(" " + name + " "), std::string::npos) << name;
  }
  EXPECT_GT(known, 15);
}

TEST_F(Output, FullStandardOutputIsExitCode6) {
  for (const auto& words : commands()) {
    const Result result = run_in("{} > /dev/full", words);
    EXPECT_EQ(result.exit_code, 6) << quoted(words) << result.err;
    EXPECT_NE(result.err.find("standard output cannot be written (No space left on device)"),
              std::string::npos)
        << quoted(words) << result.err;
  }
}

TEST_F(Output, ClosedStandardOutputIsExitCode6) {
  for (const auto& words : commands()) {
    const Result result = run_in("{} >&-", words);
    EXPECT_EQ(result.exit_code, 6) << quoted(words) << result.err;
    EXPECT_NE(result.err.find("standard output cannot be written (it is closed)"), std::string::npos)
        << quoted(words) << result.err;
  }
}

// The reader closes the pipe first and then opens the gate.
TEST_F(Output, AReaderThatHasGoneIsExitCode6WithoutAWord) {
  for (const auto& words : commands()) {
    const std::string gate = folder->file("gate"), code = folder->file("code");
    fs::remove(gate);
    const Result result = run_in("{ until [ -e '" + gate + "' ]; do sleep 0.01; done; {} 2> '" + code +
                                     ".err'; echo $? > '" + code + "'; } | { exec <&-; : > '" + gate + "'; }",
                                 words);
    EXPECT_EQ(folder->read("code"), "6\n") << quoted(words);
    EXPECT_EQ(folder->read("code.err").find("standard output"), std::string::npos) << quoted(words);
  }
}

TEST_F(Output, StandardErrorThatCannotBeWrittenChangesNothing) {
  bool full = false;
  for (const auto& words : commands()) {
    full = !full;  // one way or the other
    const Result result = run_in(full ? "{} 2> /dev/full" : "{} <&- 2>&-", words);
    EXPECT_EQ(result.exit_code, 0) << full << quoted(words) << result.err;
    EXPECT_FALSE(result.out.empty()) << full << quoted(words);
  }
}

TEST_F(Output, WithAllOfThemClosedTheCodeStillTells) {
  for (const auto& words : commands())
    EXPECT_EQ(run_in("{} <&- >&- 2>&-", words).exit_code, 6) << quoted(words);
  EXPECT_EQ(run_in("{} <&- >&- 2>&-", {"query", folder->study(), "nonsense"}).exit_code, 2);
  EXPECT_EQ(run_in("{} <&- >&- 2>&-", {"query", folder->file("none.toml"), "failures"}).exit_code, 2);
}

// A file that reaches its size limit: the system's signal for that would kill.
TEST_F(Output, ALimitOfFileSizesIsExitCode6) {
  const Result result = run_in("ulimit -f 1; {} > '" + folder->file("big") + "'", {"reference"});
  EXPECT_EQ(result.exit_code, 6);
  EXPECT_NE(result.err.find("File too large"), std::string::npos) << result.err;
}

// What a campaign, an export or a report does besides printing is done as ever.
TEST_F(Output, WhatIsDoneBesidesIsKept) {
  for (const char* streams : {"> /dev/full 2>&1", ">&- 2>&-", "<&- > /dev/full 2>&-"}) {
    const StudyFolder own;
    const auto at_work = [&](std::vector<std::string> words) {
      return shell(quoted(campaign(std::move(words))) + " " + streams, law).exit_code;
    };
    EXPECT_EQ(at_work({own.study(), "--executor", FAKE_REALIZATION}), 6) << streams;
    EXPECT_EQ(contents(own.file("small.sqlite")), contents(folder->file("small.sqlite"))) << streams;
    EXPECT_EQ(own.read("small.h5").size(), folder->read("small.h5").size()) << streams;
    for (const char* file : {"index.html", "report.pdf", "profiles.png"})
      EXPECT_FALSE(own.read(std::string("small-report/") + file).empty()) << streams << file;
    EXPECT_EQ(at_work({"export", own.study()}), 6) << streams;
    EXPECT_FALSE(own.read("small-export/sensitivity.csv").empty()) << streams;
    for (const auto& entry : fs::recursive_directory_iterator(own.file(".")))
      EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
    EXPECT_FALSE(fs::exists(own.file("small.sqlite.lock")));
  }
}

TEST_F(Output, MpiRanksToo) {
  const StudyFolder own;
  const Result result =
      shell(quoted(mpirun(2, {own.study(), "--executor", FAKE_REALIZATION, "--no-report"})) + " <&-", law);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  // What mpirun itself cannot write.
  const std::string command_line =
      quoted(mpirun(2, {own.study(), "--executor", FAKE_REALIZATION, "--no-report"}));
  for (const char* where : {" > /dev/full", " >&-"}) {
    fs::remove(own.file("small.sqlite"));
    const Result lost = shell(command_line + where, law);
    EXPECT_EQ(lost.exit_code, 6) << where << lost.err;
    EXPECT_NE(lost.err.find("mpirun's standard output cannot be written"), std::string::npos) << lost.err;
    EXPECT_EQ(contents(own.file("small.sqlite")), contents(folder->file("small.sqlite"))) << where;
  }
  // A wrapper gives each rank output that cannot be written.
  own.write("wrapped", "#!/bin/sh\nexec \"$@\" > /dev/full 2> /dev/full\n");
  fs::permissions(own.file("wrapped"), fs::perms::owner_all);
  Command command = mpirun(2, {own.study(), "--executor", FAKE_REALIZATION, "--no-report"});
  command.insert(std::find(command.begin(), command.end(), campaign({}).front()), own.file("wrapped"));
  fs::remove(own.file("small.sqlite"));
  EXPECT_EQ(run(command, law).exit_code, 6);
  EXPECT_EQ(contents(own.file("small.sqlite")), contents(folder->file("small.sqlite")));
}

}  // namespace
}  // namespace cpt::tests

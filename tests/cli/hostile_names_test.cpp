// Names with SQL, HTML, shell and path characters, of files, studies and points, stay names.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

// No slash, so that it may be a file's name.
const std::string hostile =
    "x'); DROP TABLE realization;-- $(touch hacked) `touch hacked` <script>alert(1)<x> & | *.. %s \"q\"";

std::string in_toml(std::string text) {
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
  return '"' + text + '"';
}

class HostileNames : public testing::Test {
 protected:
  HostileNames() {
    std::string study = folder.read("small.toml");
    study.replace(0, study.find('\n'), "title = " + in_toml("../../" + hostile + "</script>"));
    folder.write(hostile + ".toml",
                 study + "\n[[points]]\nname = " + in_toml("/tmp/../" + hostile) + "\n\"sand.H\" = 50\n");
  }
  [[nodiscard]] std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.file(".")))
      names.insert(entry.path().filename());
    return names;
  }
  StudyFolder folder;
};

TEST_F(HostileNames, RunQueryReportAndCompareTreatThemAsText) {
  const std::string study = folder.file(hostile + ".toml"), database = folder.file(hostile + ".sqlite");
  const Result result = run(mpirun(2, {study, "--executor", FAKE_REALIZATION}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const std::string ending : {".sqlite", ".h5", "-report"})
    EXPECT_TRUE(std::filesystem::exists(folder.file(hostile + ending))) << ending;
  for (const Command& command :
       {campaign({"query", study, "realizations"}),
        campaign({"query", database, "sensitivity", "--format", "csv"}),
        campaign({"compare", database, study, "settings"}), campaign({"report", database}),
        campaign({"rerun", study, "7", "--executor", FAKE_REALIZATION})}) {
    const Result answer = run(command);
    EXPECT_EQ(answer.exit_code, 0) << command[1] << ": " << answer.err;
  }
  const Result title =
      run(campaign({"query", database, "sql", "select title from campaign", "--format", "json"}));
  EXPECT_NE(title.out.find("DROP TABLE realization;-- $(touch hacked)"), std::string::npos) << title.out;
  EXPECT_EQ(
      run(campaign({"query", database, "sql", "select count(*) as n from realization", "--format", "csv"}))
          .out,
      "n\n7\n");

  const std::string page = folder.read(hostile + "-report/index.html");
  EXPECT_NE(page.find("DROP TABLE realization"), std::string::npos);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  for (const std::string& name : files()) EXPECT_NE(name, "hacked");
  EXPECT_FALSE(std::filesystem::exists("hacked"));
}

TEST_F(HostileNames, SlurmScriptPassesThemOnAsOneWord) {
  folder.write("srun", "#!/bin/sh\nprintf '%s\\n' \"$@\"\nexit 138\n");
  folder.write("scontrol", "#!/bin/sh\nprintf '%s\\n' \"$@\"\n");
  for (const char* program : {"srun", "scontrol"})
    std::filesystem::permissions(folder.file(program), std::filesystem::perms::owner_all);
  const Result result =
      run({"env", "PATH=" + folder.file("") + ":/usr/bin:/bin", "SLURM_JOB_ID=7", "CAMPAIGN=a b", "bash",
           CPT_SOURCE "/examples/slurm/campaign.sbatch", hostile + ".toml", "--no-report"});
  EXPECT_EQ(result.exit_code, 138) << result.err;
  EXPECT_EQ(result.out, "--mpi=pmix\na b\n" + hostile + ".toml\n--no-report\nrequeue\n7\n");
  EXPECT_FALSE(std::filesystem::exists("hacked"));
}

}  // namespace
}  // namespace cpt::tests

// The program as `cmake --install` leaves it, used far from the sources.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Installed : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new StudyFolder;
    const Result result =
        run({CPT_CMAKE, "--install", CPT_BUILD, "--prefix", folder_->file("prefix"), "--strip"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static fs::path prefix() { return folder_->file("prefix"); }
  static fs::path documentation() { return prefix() / "share/doc/campaign"; }
  // In the folder of the study, which is not that of the sources.
  static Result installed(const Command& arguments) {
    Command command{"/usr/bin/env", "--chdir=" + prefix().parent_path().string(),
                    (prefix() / "bin/campaign").string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run(command);
  }

  static StudyFolder* folder_;
};
StudyFolder* Installed::folder_ = nullptr;

TEST_F(Installed, TellsWhatItIs) {
  for (const char* option : {"--help", "--version"}) {
    const Result here = run(campaign({option})), there = installed({option});
    EXPECT_EQ(there.exit_code, 0) << there.err;
    EXPECT_EQ(there.out, here.out);
  }
  const Result list = installed({"list", "quantities"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_NE(list.out.find("sand.D_r_percent"), std::string::npos);
}

TEST_F(Installed, DoesNotKnowWhereItsSourcesAre) {
  if (std::string(CPT_SANITIZE) != "") GTEST_SKIP() << "a sanitizer names sources where it finds something";
  const std::string program = text_of(prefix() / "bin/campaign");
  EXPECT_GT(program.size(), 1000000u);
  EXPECT_EQ(program.find(CPT_SOURCE), std::string::npos);
}

TEST_F(Installed, RunsAStudyAndDrawsItsReport) {
  const Result plan = installed({(documentation() / "examples/sens.toml").string(), "--plan"});
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_NE(plan.out.find("sand.D_r_percent"), std::string::npos);

  const Result result =
      run({"/usr/bin/env", "CPT_FAKE=*:law", "CPT_FAKE_SECONDS=0.001", (prefix() / "bin/campaign").string(),
           folder_->study(), "--executor", FAKE_REALIZATION});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string page = folder_->read("small-report/index.html");
  EXPECT_NE(page.find("Copyright 2010-2023 Mike Bostock"), std::string::npos)
      << "D3's licence is in the page";
  EXPECT_TRUE(fs::exists(folder_->file("small-report/report.pdf")));
}

TEST_F(Installed, BringsCompletionManPageAndLicences) {
  const Result script = installed({"completion", "bash"}), man = installed({"reference", "--man"});
  EXPECT_EQ(text_of(prefix() / "share/bash-completion/completions/campaign"), script.out);
  const Result unpacked =
      run({"gzip", "--decompress", "--stdout", (prefix() / "share/man/man1/campaign.1.gz").string()});
  EXPECT_EQ(unpacked.out, man.out);
  int licences = 0;
  for (const auto& file : fs::directory_iterator(fs::path(CPT_SOURCE) / "reports/html/vendor")) {
    if (file.path().extension() != ".LICENSE") continue;
    const fs::path name = file.path().filename();
    EXPECT_EQ(text_of(documentation() / "licences" / name), text_of(file.path()));
    EXPECT_NE(text_of(documentation() / "copyright").find(name.string()), std::string::npos) << name;
    ++licences;
  }
  EXPECT_GE(licences, 5);
}

// Links of Markdown pages to files, without what follows a '#'.
TEST_F(Installed, LinksOfItsDocumentsLeadSomewhere) {
  const std::regex link(R"re(\]\(([^)#: ]+)(#[^)]*)?\))re");
  int links = 0;
  for (const auto& file : fs::recursive_directory_iterator(documentation())) {
    if (file.path().extension() != ".md") continue;
    const std::string text = text_of(file.path());
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match, ++links)
      EXPECT_TRUE(fs::exists(file.path().parent_path() / (*match)[1].str()))
          << file.path() << ": " << (*match)[1];
  }
  EXPECT_GE(links, 50);
}

// What a campaign leaves beside its study is no example.
TEST_F(Installed, ExamplesAreStudiesAndRecordingsAlone) {
  for (const auto& file : fs::recursive_directory_iterator(documentation() / "examples")) {
    const std::string ending = file.path().extension();
    EXPECT_TRUE(file.is_directory() || ending == ".toml" || ending == ".csv" || ending == ".sbatch")
        << file.path();
  }
}

}  // namespace
}  // namespace cpt::tests

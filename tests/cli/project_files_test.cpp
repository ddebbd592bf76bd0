// The files that say under which terms the program comes and how to cite it: complete, and agreeing with each
// other.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace cpt::tests {
namespace {

namespace fs = std::filesystem;

const fs::path source = CPT_SOURCE;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Words alone: layout, and the '.' that stands for an empty line in Debian's form, left out.
std::string words_of(const std::string& text) {
  std::istringstream stream(text);
  std::string words, word;
  while (stream >> word)
    if (word != ".") words += word + " ";
  return words;
}

std::string value(const YAML::Node& node, const char* key) {
  EXPECT_TRUE(node[key] && node[key].IsScalar()) << key;
  return node[key] && node[key].IsScalar() ? node[key].as<std::string>() : "";
}

// The keys that the form 1.2.0 requires, and those that a reader of the citation needs.
TEST(Citation, HasWhatTheFormRequires) {
  const YAML::Node citation = YAML::LoadFile(source / "CITATION.cff");
  EXPECT_EQ(value(citation, "cff-version"), "1.2.0");
  EXPECT_NE(value(citation, "message"), "");
  EXPECT_NE(value(citation, "title"), "");
  EXPECT_EQ(value(citation, "type"), "software");
  EXPECT_EQ(value(citation, "version"), CPT_VERSION);
  ASSERT_TRUE(citation["authors"].IsSequence());
  ASSERT_EQ(citation["authors"].size(), 1u);
  EXPECT_EQ(value(citation["authors"][0], "name"), "the campaign authors");

  ASSERT_TRUE(citation["references"].IsSequence());
  ASSERT_EQ(citation["references"].size(), 1u);
  const YAML::Node paper = citation["references"][0];
  EXPECT_EQ(value(paper, "type"), "article");
  EXPECT_EQ(value(paper, "doi"), "10.1016/j.compgeo.2023.105378");
  EXPECT_EQ(value(paper, "year"), "2023");
  ASSERT_EQ(paper["authors"].size(), 5u);
  for (const YAML::Node& author : paper["authors"]) {
    EXPECT_NE(value(author, "family-names"), "");
    EXPECT_NE(value(author, "given-names"), "");
  }
  // README cites the same paper.
  const std::string readme = words_of(text_of(source / "README.md"));
  EXPECT_NE(readme.find(words_of(value(paper, "title") + ".")), std::string::npos) << value(paper, "title");
  EXPECT_NE(readme.find(value(paper, "doi")), std::string::npos);
}

TEST(Licence, IsTheSameInTheCitationAndInThePackage) {
  const std::string licence = text_of(source / "LICENSE");
  const std::string package = text_of(source / "packaging/copyright");
  EXPECT_EQ(value(YAML::LoadFile(source / "CITATION.cff"), "license"), "BSD-3-Clause");
  std::smatch holder;
  ASSERT_TRUE(std::regex_search(licence, holder, std::regex(R"re(Copyright \(c\) (\d{4}, .+))re")));
  EXPECT_NE(package.find("Files: *\nCopyright: " + holder[1].str() + "\nLicense: BSD-3-Clause\n"),
            std::string::npos)
      << holder[1];
  const std::string terms = words_of(licence.substr(licence.find("Redistribution and use")));
  EXPECT_NE(words_of(package).find("License: BSD-3-Clause " + terms), std::string::npos);
}

// What is vendored comes under its own terms: each holder is named in the package's copyright file.
TEST(Licence, NamesTheHoldersOfVendoredSources) {
  const std::string package = text_of(source / "packaging/copyright");
  const std::regex holder(R"re(Copyright (?:\(c\) )?([0-9-]+),? (.+))re");
  int holders = 0;
  for (const auto& file : fs::directory_iterator(source / "reports/html/vendor")) {
    if (file.path().extension() == ".LICENSE") {
      const std::string text = text_of(file.path());
      EXPECT_NE(package.find("licences/" + file.path().filename().string()), std::string::npos)
          << file.path();
      std::smatch match;
      ASSERT_TRUE(std::regex_search(text, match, holder)) << file.path();
      EXPECT_NE(package.find(match[2].str()), std::string::npos) << file.path() << ": " << match[2];
      ++holders;
    } else {
      EXPECT_NE(package.find("Files: reports/html/vendor/" + file.path().filename().string() + "\n"),
                std::string::npos)
          << file.path();
    }
  }
  EXPECT_GE(holders, 5);
}

// Newest first, and what has no version yet above all versions.
TEST(Changelog, HasWhatIsUnreleasedOnTopAndThisVersion) {
  const std::string text = text_of(source / "CHANGELOG.md");
  const std::regex heading(R"re(^## (.+)$)re", std::regex::multiline);
  std::vector<std::string> headings;
  for (std::sregex_iterator match(text.begin(), text.end(), heading), end; match != end; ++match)
    headings.push_back((*match)[1]);
  ASSERT_GE(headings.size(), 2u);
  EXPECT_EQ(headings[0], "Unreleased");
  EXPECT_EQ(headings[1].substr(0, headings[1].find(' ')), CPT_VERSION);
}

}  // namespace
}  // namespace cpt::tests

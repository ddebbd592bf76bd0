// Columns of CSV files that a study's distributions are made of.
#include "parameters/study_data.hpp"

#include <gtest/gtest.h>

#include "parameters/document.hpp"

namespace cpt::parameters {
namespace {

FieldTable table(const std::vector<std::string>& names, const std::vector<std::vector<std::string>>& rows) {
  FieldTable made{"lab.csv", "lab", {}, {}};
  int line = 1;
  for (const std::string& name : names) made.names.push_back({name, {line, 1}});
  for (const auto& row : rows) {
    ++line;
    made.rows.emplace_back();
    for (const std::string& text : row) made.rows.back().push_back({text, {line, 1}});
  }
  return made;
}

constexpr const char* study = R"(
[parameters]
"sand.phi_cs_deg" = { distribution = { kind = "empirical", file = "lab.csv", column = "phi" } }
sand.nu = { distribution = { kind = "empirical", file = "lab.csv", column = "nu \"x\"" } }
"sand.H" = { distribution = { kind = "normal", mean = 30, cv = 0.1 } }
)";

TEST(StudyData, IsWhatTheDistributionsAskForAndTheStudyLacks) {
  const auto wanted = wanted_files(study);
  ASSERT_EQ(wanted.size(), 1U);
  EXPECT_EQ(wanted[0].file, "lab.csv");
  EXPECT_EQ(wanted[0].place.line, 3);
  EXPECT_EQ(wanted[0].columns, (std::vector<std::string>{"phi", "nu \"x\""}));
  EXPECT_TRUE(wanted_files(std::string(study) + "[data.\"lab.csv\"]\nphi = [1]\n").empty());
  EXPECT_TRUE(wanted_files("no TOML =").empty());
}

TEST(StudyData, StandsBehindTheStudyAsTheFileHasIt) {
  const auto wanted = wanted_files(study);
  ErrorList errors("study.toml");
  const std::string section = data_section(
      table({"phi", "nu \"x\""},
            {{"30.1", "0.2"}, {"29", ""}, {"31", ".25"}, {"30", "1e-1"}, {"28.5", "0.2"}, {"", "0.3"}}),
      wanted[0], errors);
  EXPECT_TRUE(errors.empty()) << format(errors.sorted());
  const auto whole = parse_document(study + section);
  ASSERT_TRUE(std::holds_alternative<Value>(whole)) << section;
  const Value& data = std::get<Value>(whole).find("data")->value.find("lab.csv")->value;
  EXPECT_EQ(data.find("phi")->value.items.size(), 5U);
  EXPECT_EQ(data.find("phi")->value.items[0].number, 30.1);
  EXPECT_EQ(data.find("nu \"x\"")->value.items[2].number, 0.1);
  EXPECT_TRUE(wanted_files(study + section).empty());
}

TEST(StudyData, SaysWhatIsWrongWithTheFile) {
  struct Case {
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> rows;
    std::string message;
  };
  const std::vector<std::vector<std::string>> few = {{"1", "1"}, {"2", "2"}, {"3", "3"}, {"4", "4"}};
  for (const Case& bad :
       {Case{{"phy", "other"}, few, "lab.csv has no column \"phi\""},
        Case{{"phi", "nu \"x\""}, few, "has 4 numbers in column \"phi\", not 5 to 10000"},
        Case{{"phi", "nu \"x\""}, {{"30,5", "1"}}, "lab.csv:2:1: \"30,5\" is not a finite number"},
        Case{{"phi", "nu \"x\""}, {{"nan", "1"}}, "is not a finite number"}}) {
    ErrorList errors("study.toml");
    EXPECT_EQ(data_section(table(bad.names, bad.rows), wanted_files(study)[0], errors), "");
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors.sorted()[0].line, 3);
    EXPECT_NE(errors.sorted()[0].message.find(bad.message), std::string::npos) << format(errors.sorted());
  }
}

}  // namespace
}  // namespace cpt::parameters

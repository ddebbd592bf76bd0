// AGS4: groups, units, several pushes, blanks.
#include <cmath>

#include "tests/recordings/files.hpp"

namespace cpt::recordings {
namespace {

const ReadOptions first{.format = {}, .columns = {}, .voids = {}, .push = "CPT1/1"};

TEST(Ags4, ReadsTheChosenPushAndCountsTheOthers) {
  const Recording r = from_corpus("two_pushes.ags", first);
  EXPECT_EQ(r.format, "AGS4");
  EXPECT_EQ(r.id, "CPT1/1");
  EXPECT_EQ(r.date, "2024-05-06");
  EXPECT_EQ(r.x, 1000.5);
  EXPECT_EQ(r.y, 2000.25);
  EXPECT_EQ(r.elevation, 12.3);
  EXPECT_NEAR(r.cone_area, 15e-4, 1e-12);
  EXPECT_EQ(r.area_quotient, 0.85);
  EXPECT_EQ(r.rows_read, 4);
  ASSERT_EQ(r.readings.size(), 3U);
  ASSERT_EQ(r.set_aside.size(), 1U);
  EXPECT_EQ(r.set_aside[0].lines.rows, 1);
  EXPECT_EQ(r.set_aside[0].reason, "belongs to another push");
  EXPECT_DOUBLE_EQ(r.readings[0].depth, 0.02);
  EXPECT_DOUBLE_EQ(r.readings[0].q_c, 1.25e6);
  EXPECT_DOUBLE_EQ(r.readings[0].f_s, 10e3);
  EXPECT_DOUBLE_EQ(r.readings[0].u_2, -5e3);
}

TEST(Ags4, BlankIsVoidAndDoubledQuotesAreOne) {
  const Recording r = from_corpus("two_pushes.ags", first);
  EXPECT_TRUE(std::isnan(r.readings[1].f_s));
  EXPECT_EQ(remark(r, "f_s is void").lines.rows, 1);
  EXPECT_TRUE(std::any_of(r.facts.begin(), r.facts.end(),
                          [](const Fact& fact) { return fact.value == "Dike \"North\""; }));
}

TEST(Ags4, UnitsAreThoseOfTheUnitRow) {
  const Recording r =
      recording(with(corpus("two_pushes.ags"), "\"MN/m2\",\"m\"", "\"kPa\",\"m\""), "a.ags", first);
  EXPECT_DOUBLE_EQ(r.readings[0].q_c, 1.25e3);
  expect_has(remark(r, "unit of SCPT_RES").why, "prescribes MN/m2");
  EXPECT_EQ(remark(r, "median q_c").lines.rows, 0);
}

TEST(Ags4, SeveralPushesWantAChoice) {
  const std::string text = corpus("two_pushes.ags");
  expect_has(refusal(text, "a.ags"),
             "found 2 pushes, expected one push\n    hint: choose one of CPT1/1, CPT1/2");
  expect_has(refusal(text, "a.ags", {.format = {}, .columns = {}, .voids = {}, .push = "CPT2"}),
             "0 pushes named 'CPT2'");
}

TEST(Ags4, BrokenFilesAreRefusedWithTheirPlace) {
  const std::string text = corpus("two_pushes.ags");
  expect_has(refusal(with(text, "\"1.500\"", "\"1.5x\""), "a.ags", first),
             "a.ags:25:20: error: found '1.5x', expected a number or nothing (SCPT_RES)");
  expect_has(refusal(with(text, "\"1.500\",", ""), "a.ags", first),
             "found 5 values, expected 6, one for each heading of SCPT");
  expect_has(refusal(with(text, "\"1.500\"", "\"1.500"), "a.ags", first), "a.ags:25:27: error");
  expect_has(refusal(with(text, "\"GROUP\",\"SCPT\"", "\"GROUP\",\"SCPX\""), "a.ags"),
             "hint: groups of this file: PROJ, LOCA, SCPG, SCPX");
  expect_has(refusal(with(text, "SCPT_RES", "SCPT_XXX"), "a.ags", first), "group SCPT without SCPT_RES");
  expect_has(refusal("\"DATA\",\"x\"\n", "a.ags"),
             "a.ags:1:2: error: found 'DATA', expected \"GROUP\" first");
}

// The group SCPT again, with other headings and units, as where two deliveries were joined.
std::string again(const std::string& rows) {
  return corpus("two_pushes.ags") +
         "\n\"GROUP\",\"SCPT\"\n\"HEADING\",\"LOCA_ID\",\"SCPG_TESN\",\"SCPT_DPTH\",\"SCPT_RES\"\n"
         "\"UNIT\",\"\",\"\",\"cm\",\"kPa\"\n" +
         rows;
}

TEST(Ags4, AGroupThatStandsTwiceIsReadWhole) {
  const std::string text =
      again("\"DATA\",\"CPT1\",\"1\",\"8\",\"2000\"\n\"DATA\",\"CPT3\",\"1\",\"10\",\"2500\"\n");
  const Recording r = recording(text, "a.ags", first);
  ASSERT_EQ(r.readings.size(), 4U);
  EXPECT_NEAR(r.readings[3].depth, 0.08, 1e-12);
  EXPECT_NEAR(r.readings[3].q_c, 2e6, 1e-6);
  EXPECT_TRUE(std::isnan(r.readings[3].f_s));
  EXPECT_EQ(r.rows_read, 6);
  EXPECT_EQ(r.set_aside[0].lines.rows, 2);
  EXPECT_EQ(remark(r, "2 groups SCPT").done, "rows of all are read");
  expect_has(refusal(text, "a.ags"), "choose one of CPT1/1, CPT1/2, CPT3/1");
}

TEST(Ags4, RowsOfBothGroupsMustNotContradictEachOther) {
  const std::string text = corpus("two_pushes.ags");
  const std::string group = text.substr(text.find("\"GROUP\",\"SCPT\""));
  const Recording r = recording(text + "\n" + group, "a.ags", first);
  EXPECT_EQ(r.readings.size(), 3U);
  EXPECT_EQ(r.rows_read, 8);
  ASSERT_EQ(r.set_aside.size(), 2U);
  EXPECT_EQ(r.set_aside[1].lines.rows, 3);
  expect_has(refusal(text + "\n" + with(group, "\"1.500\"", "\"1.600\""), "a.ags", first),
             "a.ags:34:1: error: found another reading at 0.04 m than in line 25");
}

TEST(Ags4, HeadingsAndUnitsStandOnceInAGroup) {
  const std::string text = corpus("two_pushes.ags");
  const std::string units = "\"UNIT\",\"\",\"\",\"MN/m2\",\"m\",\"kN/m2\",\"kN/m2\"\n";
  const std::string row = "\"DATA\",\"CPT1\",\"1\",\"1.500\"";
  EXPECT_EQ(recording(with(text, row, units + row), "a.ags", first).readings.size(), 3U);
  expect_has(refusal(with(text, row, with(units, "MN/m2", "kPa") + row), "a.ags", first),
             "a.ags:25:2: error: found other units in the same group SCPT");
  expect_has(refusal(with(text, row, "\"HEADING\",\"SCPT_DPTH\"\n" + row), "a.ags", first),
             "a.ags:25:2: error: found other headings in the same group SCPT");
  expect_has(refusal(with(text, "SCPT_FRES", "SCPT_RES"), "a.ags", first), "a second heading 'SCPT_RES'");
}

TEST(Ags4, AFactThatIsNotKnownIsARemark) {
  std::string text = with(corpus("two_pushes.ags"), "\"1000.50\"", "\"1000,50\"");
  text = with(text, "\"12.30\"", "\"unknown\"");
  const Recording r = recording(text, "a.ags", first);
  EXPECT_EQ(r.x, 1000.5);
  EXPECT_TRUE(std::isnan(r.elevation));
  expect_has(remark(r, "no number where the header").found, "LOCA_GL 'unknown'");
}

TEST(Ags4, Ags3IsNamed) {
  std::string text =
      "\"**PROJ\"\r\n\"*PROJ_ID\"\r\n\"7\"\r\n\r\n\"**STCN\"\r\n\"*HOLE_ID\",\"*STCN_DPTH\"\r\n";
  for (int i = 0; i < 30; ++i) text += "\"C1\",\"0.5\"\r\n";
  for (const char* name : {"a.ags", "a.txt"})
    EXPECT_EQ(refusal(text, name),
              std::string(name) +
                  ":1:1: error: found '\"**PROJ\"', a group of AGS 3, expected AGS 4\n"
                  "    hint: AGS 3 is not read: export it as AGS 4, or its readings (group STCN) as CSV");
}

}  // namespace
}  // namespace cpt::recordings

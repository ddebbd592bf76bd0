// CSV with a column map.
#include "recordings/csv.hpp"

#include <cmath>

#include "tests/recordings/files.hpp"

namespace cpt::recordings {
namespace {

ReadOptions columns(ColumnMap map) {
  return {.format = {}, .columns = std::move(map), .voids = {}, .push = {}};
}

TEST(Csv, ReadsTheMappedColumns) {
  const Recording r = from_corpus("chamber.csv", chamber());
  EXPECT_EQ(r.id, "C1");
  EXPECT_EQ(r.date, "2024-05-06");
  EXPECT_EQ(r.predrilled_depth, 0.015);
  EXPECT_EQ(r.depth_rule, DepthRule::stated);
  ASSERT_EQ(r.readings.size(), 5U);
  EXPECT_DOUBLE_EQ(r.readings[0].q_c, 0.5e6);
  EXPECT_DOUBLE_EQ(r.readings[0].f_s, 5e3);
  EXPECT_EQ(r.readings[0].line, 6);
  EXPECT_TRUE(r.readings[0].predrilled);
  EXPECT_TRUE(std::isnan(r.readings[1].f_s));
  EXPECT_TRUE(std::isnan(r.readings[2].q_c));  // -9999
  EXPECT_TRUE(std::isnan(r.readings[3].q_c));  // nan
  EXPECT_EQ(remark(r, "q_c is void").lines.rows, 2);
  expect_has(remark(r, "columns: note").done, "not read");
}

TEST(Csv, ColumnsNamedAsQuantitiesNeedNoMap) {
  const Recording r = recording("depth_cm,q_c_kPa,u_2_kPa\n10,500,-3\n20,600,4\n", "a.csv");
  EXPECT_DOUBLE_EQ(r.readings[1].depth, 0.2);
  EXPECT_DOUBLE_EQ(r.readings[1].q_c, 600e3);
  EXPECT_DOUBLE_EQ(r.readings[0].u_2, -3e3);
}

TEST(Csv, ALengthAloneIsTakenAsDepthAndTold) {
  const Recording r = recording("length_m,q_c_MPa\n1,2\n2,3\n", "a.csv");
  EXPECT_EQ(r.depth_rule, DepthRule::length);
  EXPECT_EQ(remark(r, "neither corrected depth nor inclination").lines.rows, 2);
}

TEST(Csv, UndeclaredVoidsAndNegativeValuesAreToldAndKept) {
  const Recording r = recording("depth_m,q_c_MPa\n1,2\n2,-9999\n3,2.5\n", "a.csv");
  EXPECT_DOUBLE_EQ(r.readings[1].q_c, -9999e6);
  EXPECT_EQ(remark(r, "beyond 500 MPa").lines.rows, 1);
  EXPECT_EQ(remark(r, "negative q_c").lines.first, 3);
}

TEST(Csv, BrokenFilesAreRefusedWithTheirPlace) {
  const std::string text = corpus("chamber.csv");
  expect_has(refusal(with(text, "0.60", "0,60"), "a.csv", chamber()),
             "a.csv:7:6: error: found '0,60', expected a number (q_c_MPa)");
  expect_has(refusal(with(text, ";b", ""), "a.csv", chamber()), "a.csv:7:1: error: found 3 fields");
  expect_has(refusal(text, "a.csv"), "no column for q_c");
  expect_has(refusal(text, "a.csv", columns({{"q_c_MPa", "tip"}, {"depth_m", "z_m"}})),
             "found 0 columns named 'tip'");
  expect_has(refusal(text, "a.csv", columns({{"q_c_m", "tip_MPa"}, {"depth_m", "z_m"}})), "quantity 'q_c_m'");
  expect_has(refusal(text, "a.csv", columns({{"depth_m", "z_m"}, {"depth_cm", "z_m"}})), "twice");
  expect_has(refusal("# nothing\n", "a.csv"), "no line of column names");
}

TEST(Csv, QuantitiesCarryAUnitOfTheirKind) {
  for (const char* good :
       {"depth_m", "q_c_MPa", "q_c_kPa", "f_s_Pa", "inclination_deg", "speed_mm_per_s", "time_s"})
    EXPECT_EQ(quantity_problem(good), "") << good;
  for (const char* bad : {"depth", "q_c", "q_c_m", "depth_MPa", "", "q_c_"})
    EXPECT_NE(quantity_problem(bad), "") << bad;
}

}  // namespace
}  // namespace cpt::recordings

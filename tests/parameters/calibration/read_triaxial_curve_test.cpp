#include "parameters/calibration/read_triaxial_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::calibration {
namespace {

TriaxialCurve good(std::string_view text) {
  const CurveOrProblems read = parse_triaxial_curve(text, "lab/dense.csv");
  if (const auto* problems = std::get_if<std::vector<CurveProblem>>(&read)) {
    ADD_FAILURE() << format(*problems);
    return {};
  }
  return std::get<TriaxialCurve>(read);
}

std::string bad(std::string_view text) {
  const CurveOrProblems read = parse_triaxial_curve(text, "lab/dense.csv");
  const auto* problems = std::get_if<std::vector<CurveProblem>>(&read);
  return problems != nullptr ? format(*problems) : "no problem";
}

TEST(ReadTriaxialCurve, CommentsGiveTheStateAndColumnsTheReadings) {
  const TriaxialCurve curve = good(
      "\xEF\xBB\xBF# test = CD 7\r\n# D_r_percent = 80\r\n# p0_kPa = 160\r\n# made by hand\r\n\r\n"
      "q_kPa, eps_a_percent "
      ",cell_kPa,eps_v_percent\r\n0,0,160,0\r\n212.4,0.25,160,0.05\r\n300,0.5,160,-0.1\r\n");
  EXPECT_EQ(curve.name, "CD 7");
  EXPECT_DOUBLE_EQ(curve.D_r, 0.8);
  EXPECT_DOUBLE_EQ(curve.p_0, 160e3);
  EXPECT_TRUE(std::isnan(curve.e_0));
  ASSERT_EQ(curve.readings.size(), 3u);
  EXPECT_DOUBLE_EQ(curve.readings[1].eps_a, 0.0025);
  EXPECT_DOUBLE_EQ(curve.readings[1].q, 212.4e3);
  EXPECT_DOUBLE_EQ(curve.readings[2].eps_v, -0.001);
}

TEST(ReadTriaxialCurve, VolumetricStrainMayBeMissingAndFieldsSetApartOtherwise) {
  for (const char* text :
       {"eps_a_percent;q_kPa\n0;0\n1;2\n2;3", "eps_a_percent\tq_kPa\n0\t0\n1\t2\n2\t3\n"}) {
    const TriaxialCurve curve = good(text);
    EXPECT_EQ(curve.name, "dense");
    ASSERT_EQ(curve.readings.size(), 3u);
    EXPECT_DOUBLE_EQ(curve.readings[2].q, 3e3);
    EXPECT_TRUE(std::isnan(curve.readings[2].eps_v));
    EXPECT_TRUE(std::isnan(curve.p_0));
  }
}

TEST(ReadTriaxialCurve, NumbersAndEndsOfOtherProgramsAreReadRightly) {
  const TriaxialCurve curve = good(std::string_view(
      "# p0_kPa = +1.6D+02\neps_a_percent,q_kPa,eps_v_percent,\r\n+0,0,0,\r\n1.0E0,2.5d1,\xE2\x88\x92"
      "0.5,\r\n2,3e1,-1,\r\n\x1A\0\0",
      100));
  EXPECT_DOUBLE_EQ(curve.p_0, 160e3);
  ASSERT_EQ(curve.readings.size(), 3u);
  EXPECT_DOUBLE_EQ(curve.readings[1].q, 25e3);
  EXPECT_DOUBLE_EQ(curve.readings[1].eps_v, -0.005);
  EXPECT_EQ(
      good("# made = by hand\n# operator = 7 of us\neps_a_percent,q_kPa\n0,0\n1,2\n2,3\n").readings.size(),
      3u);
}

struct Bad {
  const char* text;
  const char* message;
};

TEST(ReadTriaxialCurve, ProblemsNameFileLineAndColumn) {
  const Bad cases[] = {
      {"eps_a_percent,q_kPa\n0,0\n1,2\n2,abc\n", "lab/dense.csv:4:3: q_kPa: 'abc' is not a number"},
      {"eps_a_percent;q_kPa\n0;0\n1;2\n2; 3,5\n",
       ":4:4: q_kPa: '3,5' is not a number; decimals follow a point, not a comma: 3.5"},
      {"eps_a_percent;q_kPa\n0;0\n1;2\n2;+-3\n", ":4:3: q_kPa: '+-3' is not a number"},
      {"eps_a_percent;q_kPa\n0;0\n1;2\n2;1 003\n",
       "'1 003' is not a number; thousands are not set apart: 1003"},
      {"eps_a_percent;q_kPa\n0;0\n1;2\n2;3 kPa\n", "the number alone, without a unit: 3"},
      {"eps_a_percent;q_kPa\n0;0\n1;2\neps_a_percent;q_kPa\n2;3\n",
       ":4:1: eps_a_percent: 'eps_a_percent' is not a number; the line of names stands here again"},
      {"eps_a_percent;q_kPa\n0;0\n\x1A\n1;2\n2;3\n", ":3:1: has 1 fields"},
      {"\xFF\xFEq", "is UTF-16: save it as UTF-8"},
      {"# p0_kPa = 160\n# p0_kPa = 80\neps_a_percent;q_kPa\n0;0\n1;2\n2;3\n", ":2:11: p0_kPa is there twice"},
      {"# p0_kpa = 160\neps_a_percent;q_kPa\n0;0\n1;2\n2;3\n",
       ":1:3: p0_kpa = 160 is not read; did you mean p0_kPa?"},
      {"# p0_kPa = 160 kPa\neps_a_percent;q_kPa\n0;0\n1;2\n2;3\n", "without a unit: 160"},
      {"# e0 = 0,62\neps_a_percent;q_kPa\n0;0\n1;2\n2;3\n", "not a comma: 0.62"},
      {"eps_a (%),q (MPa)\n0,0\n1,2\n2,3\n", "there is no column q_kPa but eps_a (%),q (MPa);"},
      {"eps_a_percent,q_kPa,eps_v_percent\n0,0,0\n0,5,120\n",
       ":3:5: eps_v_percent = 120: must be -100 to 100"},
      {"eps_a_percent,q_kPa\n0,0\n1,nan\n2,3\n", ":3:3: q_kPa: 'nan' is not a number"},
      {"eps_a_percent,q_kPa\n0,0\n1\n2,3\n", ":3:1: has 1 fields where the line of names has 2"},
      {"eps_a_percent,q_kPa\n0,0\n2,2\n1,3\n", ":4:1: eps_a_percent = 1 falls"},
      {"eps_a_percent,q_kPa\n0,0\n1,2\n120,3\n", ":4:1: eps_a_percent = 120: must be 0 to 100"},
      {"# p0_kPa = much\neps_a_percent,q_kPa\n0,0\n1,2\n2,3\n", ":1:11: p0_kPa = much: must be a number"},
      {"strain,q_kPa\n0,0\n1,2\n2,3\n", ":1:1: there is no column eps_a_percent"},
      {"eps_a_percent,q_kPa,q_kPa\n0,0,0\n1,2,2\n2,3,3\n", ":1:21: column q_kPa is there twice"},
      {"eps_a_percent,q_kPa\n0,0\n1,2\n", "lab/dense.csv: has 2 readings; a curve needs 3"},
      {"# e0 = 0.6\n# D_r_percent = 80\neps_a_percent,q_kPa\n0,0\n1,2\n2,3\n", "both e0 and D_r_percent"},
      {"", "has no line of column names"},
  };
  for (const Bad& c : cases) EXPECT_NE(bad(c.text).find(c.message), std::string::npos) << bad(c.text);
}

TEST(ReadTriaxialCurve, AllProblemsAreToldAtOnce) {
  EXPECT_EQ(bad("eps_a_percent,q_kPa\n0,x\n1,y\n2,3\n"),
            "lab/dense.csv:2:3: q_kPa: 'x' is not a number\nlab/dense.csv:3:3: q_kPa: 'y' is not a number");
}

}  // namespace
}  // namespace cpt::calibration

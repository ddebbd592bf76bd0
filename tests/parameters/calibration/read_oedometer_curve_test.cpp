#include "parameters/calibration/read_oedometer_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::calibration {
namespace {

std::string refused(std::string_view text) {
  const OedometerOrProblems read = parse_oedometer_curve(text, "lab/loose.csv");
  const auto* problems = std::get_if<std::vector<CurveProblem>>(&read);
  return problems != nullptr ? format(*problems) : "no problem";
}

TEST(ReadOedometerCurve, CommentsGiveTheStateAndColumnsTheReadings) {
  const OedometerOrProblems read = parse_oedometer_curve(
      "\xEF\xBB\xBF# test = OE 3\r\n# K0 = 0.45\r\n# e0 = 0.8125\r\n# by hand\r\ne;sigma_v_kPa\r\n"
      "0.812;10\r\n0.81;20\r\n0.81;20\r\n0.8;4e1\r\n",
      "lab/loose.csv");
  ASSERT_TRUE(std::holds_alternative<OedometerCurve>(read));
  const auto& curve = std::get<OedometerCurve>(read);
  EXPECT_EQ(curve.name, "OE 3");
  EXPECT_DOUBLE_EQ(curve.K_0, 0.45);
  EXPECT_DOUBLE_EQ(curve.e_0, 0.8125);
  ASSERT_EQ(curve.readings.size(), 4U);
  EXPECT_DOUBLE_EQ(curve.readings[3].sigma_v, 40e3);
  EXPECT_DOUBLE_EQ(curve.readings[3].e, 0.8);
}

TEST(ReadOedometerCurve, FactsMayBeMissing) {
  const auto read = parse_oedometer_curve("sigma_v_kPa,e\n10,0.8\n20,0.79\n40,0.78", "lab/loose.csv");
  ASSERT_TRUE(std::holds_alternative<OedometerCurve>(read));
  EXPECT_EQ(std::get<OedometerCurve>(read).name, "loose");
  EXPECT_TRUE(std::isnan(std::get<OedometerCurve>(read).K_0));
  EXPECT_TRUE(std::isnan(std::get<OedometerCurve>(read).e_0));
}

TEST(ReadOedometerCurve, ProblemsNameFileLineAndColumn) {
  const struct {
    const char *text, *message;
  } cases[] = {
      {"sigma_v_kPa,e\n10,0.8\n20,x\n", "lab/loose.csv:3:4: e: 'x' is not a number"},
      {"sigma_v_kPa,e\n10,0.8\n20,0.79\n15,0.79\n", ":4:1: sigma_v_kPa = 15 falls: leave out unloading"},
      {"sigma_v_kPa,e\n0,0.8\n", ":2:1: sigma_v_kPa = 0: must be 0.01 to 1000000"},
      {"sigma_v_kPa,e\n10,80\n", ":2:4: e = 80: must be 0.05 to 5"},
      {"# K0 = 7\nsigma_v_kPa,e\n", ":1:7: K0 = 7: must be a number from 0.1 to 3"},
      {"# k0 = 0.5\nsigma_v_kPa,e\n", ":1:3: k0 = 0.5 is not read; did you mean K0?"},
      {"sigma_v_kPa,w\n10,0.8\n", ":1:1: there is no column e but sigma_v_kPa,w;"},
      {"sigma_v_kPa,e\n10,0.8\n20,0.7\n", "lab/loose.csv: has 2 readings; a curve needs 3"},
      {"sigma_v_kPa,e\n10,0.8\n10,0.8\n10,0.8\n", "has no reading beyond its first stress"},
      {"", "has no line of column names"},
  };
  for (const auto& c : cases)
    EXPECT_NE(refused(c.text).find(c.message), std::string::npos) << refused(c.text);
}

TEST(ReadOedometerCurve, IsToldFromATriaxialTestByItsNames) {
  EXPECT_TRUE(is_oedometer_curve("\xEF\xBB\xBF# sigma\n\r\n e , sigma_v_kPa\n"));
  EXPECT_FALSE(is_oedometer_curve("# sigma_v_kPa\neps_a_percent,q_kPa\n"));
  EXPECT_FALSE(is_oedometer_curve(""));
}

}  // namespace
}  // namespace cpt::calibration

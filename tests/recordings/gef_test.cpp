// GEF-CPT: columns by quantity, voids, separators, signs, labels, and what is said of broken files.
#include <cmath>
#include <numbers>

#include "tests/recordings/files.hpp"

namespace cpt::recordings {
namespace {

TEST(Gef, ReadsHeaderAndColumnsInSiUnits) {
  const Recording r = from_corpus("plain.gef");
  EXPECT_EQ(r.format, "GEF-CPT");
  EXPECT_EQ(r.id, "A1");
  EXPECT_EQ(r.date, "2024-05-07");
  EXPECT_EQ(r.x, 120000.5);
  EXPECT_EQ(r.y, 480000.25);
  EXPECT_EQ(r.elevation, -1.5);
  EXPECT_NEAR(r.cone_area, 15e-4, 1e-12);
  EXPECT_EQ(r.area_quotient, 0.75);
  EXPECT_EQ(r.rows_read, 5);
  ASSERT_EQ(r.readings.size(), 5U);
  EXPECT_EQ(r.readings[1].line, 24);
  EXPECT_DOUBLE_EQ(r.readings[1].q_c, 2.5e6);
  EXPECT_DOUBLE_EQ(r.readings[1].f_s, 20e3);
  EXPECT_TRUE(std::isnan(r.readings[1].u_2));
  EXPECT_DOUBLE_EQ(r.readings[4].q_c, 5e6);
}

TEST(Gef, VoidsArePerColumnAndTold) {
  const Recording r = from_corpus("plain.gef");
  EXPECT_TRUE(std::isnan(r.readings[0].q_c));
  EXPECT_TRUE(std::isnan(r.readings[2].f_s));
  EXPECT_FALSE(std::isnan(r.readings[2].q_c));
  EXPECT_EQ(remark(r, "q_c is void").lines.rows, 1);
  EXPECT_EQ(remark(r, "f_s is void").lines.rows, 2);
  EXPECT_EQ(remark(r, "f_s is void").lines.last, 25);
}

TEST(Gef, LengthIsCorrectedByTheInclinationButNotByAFailedOne) {
  const Recording r = from_corpus("plain.gef");
  EXPECT_EQ(r.depth_rule, DepthRule::from_inclination);
  EXPECT_DOUBLE_EQ(r.readings[2].depth, 1.5);   // 60 degrees are no inclination of a cone
  EXPECT_NEAR(r.readings[4].depth, 2.4, 1e-9);  // cos = 0.8 over the last half metre
  EXPECT_EQ(remark(r, "45 degrees").lines.rows, 1);
  expect_has(remark(r, "but an inclination").done, "up to 0.100 m");
}

TEST(Gef, PredrilledRowsStayAndTheDriftIsOnlyTold) {
  const Recording r = from_corpus("plain.gef");
  EXPECT_TRUE(r.readings[0].predrilled);
  EXPECT_FALSE(r.readings[1].predrilled);
  EXPECT_EQ(remark(r, "predrilled").lines.rows, 1);
  EXPECT_NEAR(r.q_c_zero.drift, 10e3, 1e-6);
  expect_has(remark(r, "zero of q_c").done, "not applied");
}

TEST(Gef, TakesColumnsByQuantityAndSeparatorsFromTheHeader) {
  const Recording r = from_corpus("odd.gef");
  EXPECT_EQ(r.rows_read, 5);
  ASSERT_EQ(r.readings.size(), 5U);
  EXPECT_DOUBLE_EQ(r.readings[1].q_c, 1.0e6);
  EXPECT_DOUBLE_EQ(r.readings[1].f_s, 10e3);  // the label says kPa where the format prescribes MPa
  EXPECT_DOUBLE_EQ(r.readings[2].q_c, 1.1e6);
  EXPECT_TRUE(std::isnan(r.readings[2].f_s));
  EXPECT_EQ(r.readings[2].line, 16);
  EXPECT_EQ(remark(r, "empty fields").lines.rows, 1);
  expect_has(remark(r, "unit of q_c").found, "'Mpa'");
  expect_has(remark(r, "unit of f_s").why, "prescribes MPa");
  const double x = std::tan(3.0 * std::numbers::pi / 180.0), y = std::tan(4.0 * std::numbers::pi / 180.0);
  EXPECT_NEAR(r.readings[1].inclination, std::atan(std::sqrt(x * x + y * y)), 1e-12);
}

TEST(Gef, NegativeDepthsAreTurnedAndMissingOnesGoOn) {
  const Recording r = from_corpus("odd.gef");
  EXPECT_EQ(r.depth_rule, DepthRule::stated);
  EXPECT_DOUBLE_EQ(r.readings[0].depth, 0.98);  // void: vertical to here
  EXPECT_DOUBLE_EQ(r.readings[1].depth, 0.99);
  EXPECT_DOUBLE_EQ(r.readings[1].length, 1.00);
  EXPECT_EQ(remark(r, "depth is negative").lines.rows, 4);
  EXPECT_EQ(remark(r, "length is negative").lines.rows, 5);
  EXPECT_EQ(remark(r, "no corrected depth").lines.rows, 1);
}

TEST(Gef, TimeGapsAreStops) {
  const Recording r = from_corpus("odd.gef");
  EXPECT_FALSE(r.readings[3].after_stop);
  EXPECT_TRUE(r.readings[4].after_stop);  // 17 s for a step that takes 1 s
  expect_has(remark(r, "stood still").found, "1 time, 16 s in all, at 1.03 m");
}

TEST(Gef, DeclaredSeparatorsThatAreNotThereAreToldAndLeft) {
  const Recording r = recording(
      with(corpus("plain.gef"), "#EOH=", "#COLUMNSEPARATOR= ;\n#RECORDSEPARATOR= !\n#EOH="), "a.gef");
  EXPECT_EQ(r.readings.size(), 5U);
  expect_has(remark(r, "declares ';'").done, "blanks");
  expect_has(remark(r, "declares '!'").done, "line ends");
}

TEST(Gef, OldEncodingsBecomeUtf8) {
  const Recording r = recording(with(corpus("plain.gef"), "CP15-CF75", "conus \xB0\xEB"), "a.gef");
  EXPECT_EQ(remark(r, "not UTF-8").done, "read as windows-1252");
  EXPECT_TRUE(std::any_of(r.facts.begin(), r.facts.end(),
                          [](const Fact& fact) { return fact.value == "conus \u00B0\u00EB"; }));
}

TEST(Gef, CorrectedDepthsThatCannotBeAreNotUsed) {
  const Recording r = recording(with(corpus("odd.gef"), "1.3;-1.05", "1.3;-7.05"), "a.gef");
  EXPECT_EQ(r.depth_rule, DepthRule::from_inclination);
  EXPECT_EQ(remark(r, "longer than").lines.rows, 1);
  EXPECT_NEAR(r.readings[4].depth, 0.98 + 0.08 * std::cos(r.readings[4].inclination), 1e-3);
}

TEST(Gef, UnsortedRowsAreOrderedAndRepeatedDepthsMarked) {
  std::string text = corpus("plain.gef");
  text = with(text, "2.00 4.0e0", "1.50 4.0e0");
  text += "1.20 6.0 0.040 0.0\n";
  const Recording r = recording(text, "a.gef");
  ASSERT_EQ(r.readings.size(), 6U);
  EXPECT_DOUBLE_EQ(r.readings[2].q_c, 6e6);
  EXPECT_EQ(r.readings[2].line, 28);
  EXPECT_EQ(remark(r, "less than in the row before").lines.rows, 1);
  EXPECT_EQ(remark(r, "row before again").lines.rows, 1);
  EXPECT_EQ(remark(r, "promises 5 rows").lines.rows, 0);
}

TEST(Gef, AThousandfoldIsRemarkedButNotCorrected) {
  const Recording r = recording(with(corpus("plain.gef"), "2, MPa, cone", "2, kPa, cone"), "a.gef");
  EXPECT_DOUBLE_EQ(r.readings[1].q_c, 2.5e3);
  expect_has(remark(r, "median q_c is 3.5 kPa").why, "factor of 1000");
}

TEST(Gef, BrokenFilesAreRefusedWithTheirPlace) {
  const std::string text = corpus("plain.gef");
  expect_has(refusal(with(text, "3.0 -9999.0", "3,0 -9999.0"), "a.gef"),
             "a.gef:25:6: error: found '3,0', expected a number (q_c)\n    hint: decimals follow a point");
  expect_has(refusal(with(text, "2.5 0.020 0.0", "2.5 0.020"), "a.gef"),
             "a.gef:24:1: error: found a row of 3 values, expected 4");
  expect_has(refusal(with(text, "#EOH=\n", ""), "a.gef"), "a.gef:22:1: error: found '0.50 -9999.0");
  expect_has(refusal(text.substr(0, 200), "a.gef"), "expected #EOH=");
  expect_has(refusal(with(text, "resistance, 2", "resistance, 4"), "a.gef"), "a column of q_c");
  expect_has(refusal(with(text, "length, 1", "length, 5"), "a.gef"), "a column of length or depth");
  expect_has(refusal(with(text, "length, 1", "length"), "a.gef"), "a.gef:4:14: error");
  expect_has(refusal(with(text, "GEF-CPT-Report", "GEF-BORE-Report"), "a.gef"), "a.gef:19:17: error");
  expect_has(refusal(text.substr(0, text.find("0.50 -")), "a.gef"), "found no row");
  expect_has(refusal("", "a.gef"), "found the end of the file");
}

TEST(Gef, WhatTheHeaderDoesNotKnowIsOneRemark) {
  std::string text = with(corpus("plain.gef"), "20, 1.500, MPa", "20, -, MPa (megaPascal)");
  text = with(text, "21, 1.510, MPa", "21, onbekend, MPa (megaPascal)");
  text = with(text, "13, 1.0, m", "13, , m (meter)");
  text = with(text, "1, 1500, mm2", "1, 1500, furlong2");
  text = with(text, "31000, -1.5", "31000, -");
  const Recording r = recording(text, "a.gef");
  EXPECT_EQ(r.readings.size(), 5U);
  EXPECT_TRUE(std::isnan(r.q_c_zero.before));
  EXPECT_TRUE(std::isnan(r.predrilled_depth));
  EXPECT_TRUE(std::isnan(r.elevation));
  EXPECT_TRUE(std::isnan(r.cone_area));
  const Remark told = remark(r, "no number where the header");
  EXPECT_EQ(told.found,
            "no number where the header should have one: zid '-', measurementvar 1 '1500 furlong2', "
            "measurementvar 13 '', measurementvar 20 '-', measurementvar 21 'onbekend'");
  EXPECT_EQ(told.lines.first, 12);
  EXPECT_EQ(told.lines.last, 18);
}

TEST(Gef, UnitsAsTheNationalRegisterWritesThem) {
  std::string text = with(corpus("plain.gef"), "2, MPa, cone", "2, MPa (megaPascal), cone");
  text = with(text, "1, m, pen", "1, m (meter), pen");
  text = with(text, "4, degrees,", "4, \u00B0 (graden),");
  text = with(text, "1, 1500, mm2", "1, 1500, mm2 (vierkante millimeter)");
  const Recording r = recording(text, "a.gef");
  EXPECT_DOUBLE_EQ(r.readings[1].q_c, 2.5e6);
  EXPECT_NEAR(r.cone_area, 15e-4, 1e-12);
  EXPECT_NEAR(r.readings[4].depth, 2.4, 1e-9);
  EXPECT_EQ(remark(r, "unit of ").lines.rows, -1) << "nothing odd about it";
}

TEST(Gef, DecimalCommasOfTheHeaderAreNotCut) {
  std::string text = with(corpus("plain.gef"), "3, 0.75, -", "3, 0,75, -");
  text = with(text, "120000.5, 480000.25", "120000,5, 480000,25");
  text = with(text, "31000, -1.5", "31000, -1,5");
  text = with(text, "13, 1.0, m", "13, 1,0, m");
  text = with(text, "2, -9999.000000", "2, -9999,000000");
  const Recording r = recording(text, "a.gef");
  EXPECT_EQ(r.area_quotient, 0.75);
  EXPECT_EQ(r.x, 120000.5);
  EXPECT_EQ(r.y, 480000.25);
  EXPECT_EQ(r.elevation, -1.5);
  EXPECT_EQ(r.predrilled_depth, 1.0);
  EXPECT_TRUE(std::isnan(r.readings[0].q_c));
  EXPECT_EQ(remark(r, "no number where").lines.rows, -1);
  // Without blanks a unit still is no number; a position may mean both.
  text = with(corpus("plain.gef"), "#MEASUREMENTVAR= 3, 0.75, -, area quotient",
              "#MEASUREMENTVAR=3,0,75,-,area");
  text = with(text, " 31000, 120000.5, 480000.25", "31000,120000,5,480000,25");
  const Recording tight = recording(text, "a.gef");
  EXPECT_EQ(tight.area_quotient, 0.75);
  EXPECT_TRUE(std::isnan(tight.x));
  expect_has(remark(tight, "no number where").found, "xyid '120000,5,480000,25'");
  // Whole coordinates stay two.
  const Recording whole =
      recording(with(corpus("plain.gef"), " 31000, 120000.5, 480000.25", " 31000, 120000,480000"), "a.gef");
  EXPECT_EQ(whole.x, 120000.0);
  EXPECT_EQ(whole.y, 480000.0);
}

TEST(Gef, TextsBehindTheLastColumn) {
  for (const std::string separator : {" ", ";"}) {
    std::string text = corpus("plain.gef");
    if (separator == ";") {
      const std::size_t data = text.find("#EOH=") + 6;
      std::string rows = text.substr(data);
      std::replace(rows.begin(), rows.end(), ' ', ';');
      text = with(text.substr(0, data), "#EOH", "#COLUMNSEPARATOR= ;\n#EOH") + rows;
    }
    const std::string declared = with(text, "#EOH", "#COLUMNTEXT= 1, on\n#EOH");
    const std::string row = "0.030" + separator + "0.0";
    const Recording r = recording(with(declared, row, row + separator + "rod change, at last"), "a.gef");
    EXPECT_EQ(r.readings.size(), 5U);
    EXPECT_DOUBLE_EQ(r.readings[3].q_c, 4e6);
    EXPECT_EQ(remark(r, "texts behind the last column").lines.rows, 1);
    EXPECT_TRUE(std::any_of(r.facts.begin(), r.facts.end(),
                            [](const Fact& fact) { return fact.value == "rod change, at last"; }));
    expect_has(refusal(with(text, row, row + separator + "rod"), "a.gef"), "need #COLUMNTEXT");
    // Numbers are no text: they may be decimals that were cut off.
    expect_has(refusal(with(declared, row, row + separator + "5"), "a.gef"), "a row of 5 values, expected 4");
    expect_has(refusal(with(with(declared, "1, on", "1, uit"), row, row + separator + "rod"), "a.gef"),
               "a row of 5 values");
  }
}

TEST(Gef, WrappedHeaderLinesGoOn) {
  const Recording r = recording(with(corpus("plain.gef"), "#COLUMNINFO= 2, MPa, cone resistance, 2",
                                     "#COLUMNINFO= 2, MPa,\n  cone resistance,\n2"),
                                "a.gef");
  EXPECT_DOUBLE_EQ(r.readings[1].q_c, 2.5e6);
  EXPECT_EQ(remark(r, "header lines without '#'").lines.first, 6);
  expect_has(
      refusal(with(corpus("plain.gef"), "#COLUMNINFO= 2, MPa, cone", "#COLUMNINFO= 2,\n ksc, cone"), "a.gef"),
      "a.gef:6:2: error: found 'ksc', expected the unit of q_c");
}

TEST(Gef, HugeVoidsAndVoidsInWords) {
  for (const char* value :
       {"1.0E+30", "3.4028235E+38", "-3.402823466e+038", "1.79769313486232E+308", "NaN", "-"}) {
    std::string text = corpus("plain.gef");
    for (std::size_t at; (at = text.find("-9999.0")) != text.npos;)
      text.replace(at, text.compare(at, 12, "-9999.000000") == 0 ? 12 : 7, value);
    const Recording r = recording(text, "a.gef");
    EXPECT_EQ(remark(r, "q_c is void").lines.rows, 1) << value;
    EXPECT_EQ(remark(r, "f_s is void").lines.rows, 2) << value;
  }
  expect_has(refusal(with(corpus("plain.gef"), "3.0 -9999.0", "1e30 -9999.0"), "a.gef"),
             "a void that is not declared");
}

}  // namespace
}  // namespace cpt::recordings

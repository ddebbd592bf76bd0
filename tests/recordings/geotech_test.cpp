// Geotech .cpt: keys, times, stops, zeros.
#include <cmath>

#include "recordings/clock.hpp"
#include "tests/recordings/files.hpp"

namespace cpt::recordings {
namespace {

TEST(Geotech, ReadsKeysInSiUnits) {
  const Recording r = from_corpus("stops.cpt");
  EXPECT_EQ(r.format, "Geotech CPT");
  EXPECT_EQ(r.id, "57");
  EXPECT_EQ(r.date, "22.09.2022");
  EXPECT_EQ(r.predrilled_depth, 4.0);
  EXPECT_EQ(r.area_quotient, 0.869);
  EXPECT_NEAR(r.cone_area, 1e-3, 1e-12);
  EXPECT_TRUE(std::isnan(r.x)) << "0, 0 is no position";
  ASSERT_EQ(r.readings.size(), 6U);
  EXPECT_EQ(r.rows_read, 6);
  EXPECT_DOUBLE_EQ(r.readings[0].q_c, 3.5e6);
  EXPECT_DOUBLE_EQ(r.readings[0].f_s, 17.5e3);
  EXPECT_DOUBLE_EQ(r.readings[0].u_2, 28.5e3);
  EXPECT_DOUBLE_EQ(r.readings[1].speed, 0.020);
  EXPECT_DOUBLE_EQ(r.readings[1].time, 21.0);
  EXPECT_TRUE(std::isnan(r.readings[2].u_2));
  EXPECT_FALSE(r.readings[0].predrilled);
  EXPECT_EQ(remark(r, "not UTF-8").lines.rows, 0);
  EXPECT_EQ(remark(r, "keys of the rows: O").done, "not read");
}

TEST(Geotech, DepthFollowsFromTheInclination) {
  const Recording r = from_corpus("stops.cpt");
  EXPECT_EQ(r.depth_rule, DepthRule::from_inclination);
  EXPECT_DOUBLE_EQ(r.readings[2].depth, 4.04);  // 60 degrees are not used
  EXPECT_NEAR(r.readings[3].depth, 4.056, 1e-9);
}

TEST(Geotech, StopsAreThoseOfTheFlagAndTheClock) {
  const Recording r = from_corpus("stops.cpt");
  for (const std::size_t i : {0U, 2U, 3U, 5U}) EXPECT_FALSE(r.readings[i].after_stop) << i;
  EXPECT_TRUE(r.readings[1].after_stop);
  EXPECT_TRUE(r.readings[4].after_stop);
  expect_has(remark(r, "stood still").found, "2 times");
  EXPECT_TRUE(std::any_of(r.facts.begin(), r.facts.end(), [](const Fact& fact) {
    return fact.name == "flag F=13: Depth unchanged for 5 second" && fact.value == "2";
  }));
}

TEST(Geotech, LastZeroIsAChangeUnlessItIsAsLargeAsTheFirst) {
  const Recording r = from_corpus("stops.cpt");
  EXPECT_NEAR(r.q_c_zero.before, 7.0e6, 1e-3);
  EXPECT_NEAR(r.q_c_zero.drift, 10e3, 1e-3);
  EXPECT_NEAR(r.u_2_zero.drift, -500.0, 1e-6);
  const Recording absolute = recording(with(corpus("stops.cpt"), "NA=0.0100", "NA=7.0100"), "a.cpt");
  EXPECT_NEAR(absolute.q_c_zero.after, 7.01e6, 1e-3);
  EXPECT_NEAR(absolute.q_c_zero.drift, 10e3, 1e-3);
}

TEST(Geotech, FurtherSoundingsAreSetAside) {
  const std::string text = corpus("stops.cpt");
  const Recording r = recording(text + text, "a.cpt");
  EXPECT_EQ(r.rows_read, 12);
  EXPECT_EQ(r.readings.size(), 6U);
  ASSERT_EQ(r.set_aside.size(), 1U);
  EXPECT_EQ(r.set_aside[0].lines.rows, 6);
}

TEST(Geotech, RowsWithoutDepthAreSetAside) {
  const Recording r = recording(with(corpus("stops.cpt"), "D=4.040,", ""), "a.cpt");
  EXPECT_EQ(r.rows_read, 6);
  EXPECT_EQ(r.readings.size(), 5U);
  ASSERT_EQ(r.set_aside.size(), 1U);
  EXPECT_EQ(r.set_aside[0].reason, "neither depth nor length");
  EXPECT_EQ(r.set_aside[0].lines.first, 6);
}

TEST(Geotech, BrokenFilesAreRefusedWithTheirPlace) {
  const std::string text = corpus("stops.cpt");
  expect_has(refusal(with(text, "QC=4.6000", "QC=4..6"), "a.cpt"),
             "a.cpt:6:12: error: found '4..6', expected a number (QC)");
  expect_has(refusal(with(text, "#\r\n", ""), "a.cpt"),
             "a.cpt:9:1: error: found '#$', expected '#' on a line of its own");
  expect_has(refusal("D=1,QC=2\n", "a.cpt"), "a.cpt:1:1: error: found 'D=1,QC=2', expected '$'");
  expect_has(refusal("$\nHK=1\n#\nD=1\n", "a.cpt"), "no value of q_c");
}

TEST(Clock, ReadsCountsAndDates) {
  EXPECT_DOUBLE_EQ(*seconds_of("354645046"), 354645.046);
  EXPECT_NEAR(*seconds_of("20220324111309784") - *seconds_of("20220324111154002"), 75.782, 1e-6);
  EXPECT_DOUBLE_EQ(*seconds_of("20220301000000") - *seconds_of("20220228235959"), 1.0);
  for (const char* wrong :
       {"", "12x", "20221324111309784", "20220230111309784", "20220324251309784", "1234567890123"})
    EXPECT_FALSE(seconds_of(wrong)) << wrong;
}

}  // namespace
}  // namespace cpt::recordings

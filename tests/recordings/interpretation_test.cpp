// Spikes, speed of the push, and what an interpretation takes from the file or assumes.
#include "recordings/interpretation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::recordings {
namespace {

Recording made(int rows) {
  Recording r;
  for (int i = 0; i < rows; ++i) {
    Reading reading;
    reading.line = i + 1;
    reading.depth = 1.0 + 0.02 * i;
    // Sand that becomes denser, with some scatter.
    reading.q_c = 5e6 + 20e3 * i + 30e3 * ((i * 7) % 5 - 2);
    reading.f_s = 30e3 + 100.0 * ((i * 3) % 7 - 3);
    reading.u_2 = 10e3 + 200.0 * i;
    r.readings.push_back(reading);
  }
  return r;
}

TEST(Spikes, ASingleReadingThatStandsOut) {
  Recording r = made(100);
  EXPECT_TRUE(spikes(r).empty());
  r.readings[40].q_c = 9e6;
  r.readings[60].f_s = 5e3;
  r.readings[70].u_2 = -90e3;
  const std::vector<Spike> found = spikes(r);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].reading, 40U);
  EXPECT_EQ(found[0].quantity, "q_c");
  EXPECT_EQ(found[0].value, 9e6);
  EXPECT_NEAR(found[0].neighbours, 5.8e6, 60e3);
  EXPECT_EQ(found[1].quantity, "f_s");
  EXPECT_EQ(found[2].quantity, "u_2");
}

TEST(Spikes, LayersStepsAndStopsAreNone) {
  Recording r = made(100);
  for (std::size_t i = 50; i < 100; ++i) r.readings[i].q_c *= 3.0;  // a denser layer
  for (std::size_t i = 20; i < 23; ++i) r.readings[i].q_c = 9e6;    // a thin one of three readings
  r.readings[80].u_2 = -90e3;
  r.readings[80].after_stop = true;
  EXPECT_TRUE(spikes(r).empty());
  Recording few = made(5);
  few.readings[2].q_c = 90e6;
  EXPECT_TRUE(spikes(few).empty()) << "without three neighbours on each side nothing can be said";
}

TEST(Spikes, StepsOfASensorAreNone) {
  Recording r = made(50);
  for (Reading& reading : r.readings) {
    reading.q_c = 1e6;
    reading.f_s = 10e3;
    reading.u_2 = 0.0;
  }
  r.readings[20].q_c += 40e3;
  r.readings[21].f_s += 1e3;
  r.readings[22].u_2 += 4e3;
  EXPECT_TRUE(spikes(r).empty());
}

TEST(PushSpeed, IsTheFilesOwnExceptBehindStops) {
  Recording r = made(10);
  for (Reading& reading : r.readings) reading.speed = 0.020;
  r.readings[3].speed = 0.0;
  r.readings[4].after_stop = true;
  r.readings[4].speed = 0.045;
  r.readings[7].speed = 0.026;
  r.readings[8].speed = 0.028;
  const PushSpeed speed = push_speed(r);
  EXPECT_EQ(speed.source, SpeedSource::recorded);
  EXPECT_TRUE(std::isnan(speed.speed[3]));
  EXPECT_TRUE(std::isnan(speed.speed[4]));
  const std::vector<OddSpeed> odd = odd_speeds(r, speed);
  ASSERT_EQ(odd.size(), 1U);
  EXPECT_NEAR(odd[0].from, 1.14, 1e-9);
  EXPECT_NEAR(odd[0].to, 1.16, 1e-9);
  EXPECT_EQ(odd[0].readings, 2);
  EXPECT_NEAR(odd[0].median, 0.027, 1e-12);
}

TEST(PushSpeed, FollowsFromTimeAndDepth) {
  Recording r = made(100);  // 0.02 m a row
  for (std::size_t i = 0; i < 100; ++i)
    r.readings[i].time = i <= 50 ? 1.0 * static_cast<double>(i) : 50.0 + 2.0 * static_cast<double>(i - 50);
  const PushSpeed speed = push_speed(r);
  EXPECT_EQ(speed.source, SpeedSource::from_time);
  EXPECT_NEAR(speed.speed[20], 0.020, 1e-9);
  EXPECT_NEAR(speed.speed[80], 0.010, 1e-9);
  const std::vector<OddSpeed> odd = odd_speeds(r, speed);
  ASSERT_EQ(odd.size(), 1U);
  EXPECT_NEAR(odd[0].from, 2.0, 0.1);  // the clock counts seconds: 20 of them are needed
  EXPECT_NEAR(odd[0].to, 2.98, 1e-9);
  EXPECT_NEAR(odd[0].median, 0.010, 5e-4);
}

TEST(PushSpeed, IsNotTakenAcrossAStopNorFromTimesThatStandStill) {
  Recording r = made(20);
  for (std::size_t i = 0; i < 20; ++i) r.readings[i].time = static_cast<double>(i) + (i >= 10 ? 600.0 : 0.0);
  r.readings[10].after_stop = true;
  const PushSpeed speed = push_speed(r);
  for (const std::size_t i : {8U, 9U, 10U, 11U}) EXPECT_NEAR(speed.speed[i], 0.020, 1e-9) << i;
  EXPECT_TRUE(odd_speeds(r, speed).empty());
  for (Reading& reading : r.readings) reading.time = 5.0;
  EXPECT_EQ(spread(push_speed(r).speed).values, 0);
  EXPECT_EQ(push_speed(made(5)).source, SpeedSource::none);
}

TEST(PushSpeed, ACoarseClockMakesNoOddSpeeds) {
  Recording r = made(100);
  // 22 mm/s by a clock of whole seconds: steps of 0.02 m take 0 or 1 s of it.
  for (std::size_t i = 0; i < 100; ++i)
    r.readings[i].time = std::floor(0.02 * static_cast<double>(i) / 0.022);
  EXPECT_TRUE(odd_speeds(r, push_speed(r)).empty());
}

const Assumption* assumption(const Interpretation& it, const std::string& what) {
  for (const Assumption& a : it.assumptions)
    if (a.what.find(what) != std::string::npos) return &a;
  return nullptr;
}

TEST(Interpretation, SaysWhatWasAssumed) {
  Recording r = made(100);
  r.area_quotient = 0.8;
  const Interpretation it = interpret(r);
  ASSERT_TRUE(it.corrected);
  EXPECT_NEAR(it.q_t[10], r.readings[10].q_c + 0.2 * r.readings[10].u_2, 1e-6);
  EXPECT_NEAR(it.R_f[10], 100.0 * r.readings[10].f_s / it.q_t[10], 1e-9);
  EXPECT_EQ(assumption(it, "area quotient")->origin, Origin::from_file);
  EXPECT_EQ(assumption(it, "unit weight")->origin, Origin::assumed);
  EXPECT_EQ(assumption(it, "unit weight")->value, 18.0);
  EXPECT_EQ(assumption(it, "water table")->value, 1.0);
  EXPECT_FALSE(it.intervals.empty());
  const Interpretation given = interpret(r, {17e3, 0.5, 10e3, 0.6});
  EXPECT_EQ(assumption(given, "unit weight")->origin, Origin::given);
  EXPECT_EQ(assumption(given, "area quotient")->value, 0.6);
  EXPECT_NEAR(given.ground[0].sigma_v0, 27e3, 1e-6);
  EXPECT_NEAR(given.ground[0].effective_sigma_v0, 27e3 - 0.5 * 9.81e3, 1e-6);
}

TEST(Interpretation, SaysWhatIsMissing) {
  Recording r = made(100);
  const Interpretation no_quotient = interpret(r);
  EXPECT_FALSE(no_quotient.corrected);
  EXPECT_EQ(no_quotient.why_not_corrected, "the file gives no area quotient of the cone");
  EXPECT_EQ(no_quotient.q_t[5], r.readings[5].q_c);
  r.area_quotient = 80.0;
  EXPECT_EQ(interpret(r).why_not_corrected, "the file's area quotient is not between 0 and 1");
  for (Reading& reading : r.readings) reading.u_2 = reading.f_s = not_given;
  const Interpretation bare = interpret(r);
  EXPECT_EQ(bare.why_not_corrected, "the recording has no u_2");
  EXPECT_EQ(bare.why_no_behaviour, "the recording has no f_s");
  EXPECT_TRUE(bare.intervals.empty());
  EXPECT_EQ(bare.behaviour.size(), 100U);
}

TEST(Interpretation, PredrilledRowsAreNoSoil) {
  Recording r = made(100);
  for (std::size_t i = 0; i < 50; ++i) r.readings[i].predrilled = true;
  const Interpretation it = interpret(r);
  EXPECT_EQ(it.behaviour[10].zone, 0);
  ASSERT_EQ(it.intervals.size(), 1U);
  EXPECT_NEAR(it.intervals[0].from, 1.99, 1e-9);
}

}  // namespace
}  // namespace cpt::recordings

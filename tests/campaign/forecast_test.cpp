#include "campaign/forecast.hpp"

#include <gtest/gtest.h>

#include "campaign/progress_display.hpp"

namespace cpt::campaign {
namespace {

TEST(Forecast, KnowsNothingAtFirst) {
  Forecast forecast;
  forecast.started(1, 1, 0.0);
  EXPECT_FALSE(forecast.remaining_seconds(3, 2, 0.0));
  EXPECT_EQ(forecast.point_steps_per_second(0.0), 0.0);
}

TEST(Forecast, ProgressOfTheFirstRealizationIsEnough) {
  Forecast forecast;
  forecast.started(1, 1, 0.0);
  forecast.progressed(1, 0.25, 1000.0, 10.0);
  // 40 s each: 30 s are left of the first, 3 more follow on the same core.
  EXPECT_DOUBLE_EQ(forecast.remaining_seconds(3, 1, 10.0).value(), 150.0);
  EXPECT_DOUBLE_EQ(forecast.remaining_seconds(3, 2, 10.0).value(), 75.0);
  // Never shorter than what the longest still needs.
  EXPECT_DOUBLE_EQ(forecast.remaining_seconds(0, 8, 10.0).value(), 30.0);
}

TEST(Forecast, FinishedRealizationsTeachTheirCoreSeconds) {
  Forecast forecast;
  forecast.started(1, 2, 0.0);
  forecast.ended(1, true, 5000.0, 30.0);
  EXPECT_DOUBLE_EQ(forecast.remaining_seconds(4, 2, 30.0).value(), 4 * 60.0 / 2);
  EXPECT_EQ(forecast.remaining_seconds(0, 2, 30.0).value(), 0.0);
}

TEST(Forecast, FailedRealizationsTeachNothing) {
  Forecast forecast;
  forecast.started(1, 1, 0.0);
  forecast.ended(1, false, 10.0, 1.0);
  EXPECT_FALSE(forecast.remaining_seconds(4, 2, 1.0));
}

TEST(Forecast, SpeedCountsEveryStepOnce) {
  Forecast forecast;
  forecast.started(1, 1, 0.0);
  forecast.started(2, 1, 0.0);
  forecast.progressed(1, 0.1, 1000.0, 1.0);
  forecast.progressed(2, 0.1, 3000.0, 1.0);
  forecast.ended(1, true, 2000.0, 2.0);
  EXPECT_DOUBLE_EQ(forecast.point_steps_per_second(2.0), 5000.0 / 2.0);
}

TEST(Forecast, SpeedForgetsTheDistantPast) {
  Forecast forecast;
  forecast.started(1, 1, 0.0);
  for (int second = 1; second <= 100; ++second)
    forecast.progressed(1, 0.005 * second, second <= 50 ? 0.0 : 100.0 * (second - 50), second);
  EXPECT_NEAR(forecast.point_steps_per_second(100.0), 100.0, 1e-9);
}

TEST(ProgressLine, SaysEverything) {
  EXPECT_EQ(progress_line({{7, 2, 11, 1}, 250.0, 13.24e6}),
            "12/21 done, 2 running, 1 failed, ETA 4 min 10 s, 13.2 million material-point steps/s");
  EXPECT_EQ(progress_line({{19, 2, 0, 0}, {}, 0.0}), "0/21 done, 2 running, 0 failed, ETA not known yet");
  EXPECT_EQ(progress_line({{0, 0, 21, 0}, 0.0, 0.0}), "21/21 done, 0 running, 0 failed");
}

TEST(ProgressLine, DurationsReadWell) {
  EXPECT_EQ(format_duration(0.2), "0 s");
  EXPECT_EQ(format_duration(59.4), "59 s");
  EXPECT_EQ(format_duration(61.0), "1 min 01 s");
  EXPECT_EQ(format_duration(7500.0), "2 h 05 min");
}

}  // namespace
}  // namespace cpt::campaign

#include "results/statistics/windows.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "results/push/push_start.hpp"

namespace cpt::results {
namespace {

using parameters::Window;

const solver::DepthProfile profile{{0.1, 0.2, 0.3, 0.4, 0.5}, {10.0, 40.0, 20.0, 40.0, 5.0}, {0, 0, 0, 0, 0}};

TEST(Windows, FixedWindowIsItsInterval) {
  const auto interval = resolve_window({"w", Window::Kind::fixed, 0.15, 0.35, 0.0}, {});
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval.value.from, 0.15);
  EXPECT_EQ(interval.value.to, 0.35);
}

TEST(Windows, PeakIsTheShallowestLargestAndTroughTheLeast) {
  const auto peak = resolve_window({"w", Window::Kind::peak, 0.0, 1.0, 0.1}, profile);
  ASSERT_TRUE(peak);
  EXPECT_DOUBLE_EQ(peak.value.from, 0.15);
  EXPECT_DOUBLE_EQ(peak.value.to, 0.25);
  const auto trough = resolve_window({"w", Window::Kind::trough, 0.2, 0.45, 0.1}, profile);
  ASSERT_TRUE(trough);
  EXPECT_DOUBLE_EQ(trough.value.from, 0.25);
}

TEST(Windows, SearchStaysInItsRangeAndSkipsWhatIsNotANumber) {
  solver::DepthProfile holes = profile;
  holes.q_c[1] = std::numeric_limits<double>::quiet_NaN();
  const auto peak = resolve_window({"w", Window::Kind::peak, 0.1, 0.5, 0.02}, holes);
  ASSERT_TRUE(peak);
  EXPECT_DOUBLE_EQ(peak.value.from, 0.39);
}

TEST(Windows, TheEdgeOfTheRangeIsNoExtreme) {
  const solver::DepthProfile rising{{0.1, 0.2, 0.3, 0.4}, {1.0, 2.0, 3.0, 4.0}, {0, 0, 0, 0}};
  const solver::DepthProfile level{{0.1, 0.2, 0.3, 0.4}, {2.0, 2.0, 2.0, 2.0}, {0, 0, 0, 0}};
  const auto expect_problem = [](const Resolved<Interval>& window, const char* part) {
    ASSERT_FALSE(window);
    EXPECT_NE(window.problem.find(part), std::string::npos) << window.problem;
  };
  expect_problem(
      resolve_window({"w", Window::Kind::peak, 0.1, 0.3, 0.02}, rising),
      "no peak between 0.1 and 0.3 m: its largest q_c there lies at the lower end of the range, 0.3 m; "
      "widen between_m of window w");
  expect_problem(
      resolve_window({"w", Window::Kind::trough, 0.1, 0.3, 0.02}, rising),
      "no trough between 0.1 and 0.3 m: its least q_c there lies at the upper end of the range, 0.1 m");
  expect_problem(resolve_window({"w", Window::Kind::trough, 0.1, 0.3, 0.02}, level), "no trough");
  expect_problem(resolve_window({"w", Window::Kind::peak, 0.15, 0.25, 0.02}, rising), "no peak");  // one bin
  expect_problem(resolve_window({"w", Window::Kind::peak, 0.0, 1.0, 0.02}, rising), "no peak");  // all of it
}

TEST(Windows, PeakWithoutBinsIsAProblemThatNamesRangeAndWindow) {
  const auto peak = resolve_window({"embedded sand", Window::Kind::peak, 0.6, 0.7, 0.02}, profile);
  ASSERT_FALSE(peak);
  EXPECT_NE(peak.problem.find("embedded sand"), std::string::npos);
  EXPECT_NE(peak.problem.find("0.6"), std::string::npos);
}

TEST(Windows, AverageTakesBinsWithCentresInsideEndsIncluded) {
  const auto mean = average(profile, {0.2, 0.4});
  ASSERT_TRUE(mean);
  EXPECT_EQ(mean.value.bins, 3);
  EXPECT_DOUBLE_EQ(mean.value.mean, 100.0 / 3.0);
  EXPECT_EQ(mean.value.min, 20.0);
  EXPECT_EQ(mean.value.max, 40.0);
}

TEST(Windows, BinsOnTheEdgeCountWhateverTheRounding) {
  // 0.3 - 0.1 is not 0.2 in floating point; the bin at 0.2 must still be found.
  EXPECT_EQ(average(profile, {0.3 - 0.1, 0.1 + 0.2}).value.bins, 2);
}

TEST(Windows, AverageOfNoBinIsAProblem) {
  const auto mean = average(profile, {0.41, 0.49});
  ASSERT_FALSE(mean);
  EXPECT_NE(mean.problem.find("0.41"), std::string::npos);
}

// First bins of a push into sand and of one into clay, as the solver makes them.
TEST(StartOfThePush, IsWhatFallsSteeplyBeforeTheFirstRise) {
  const std::vector<double> depth{0.02175, 0.02225, 0.02275, 0.02325, 0.02375, 0.02425};
  const std::vector<double> none(depth.size(), 0.0);
  EXPECT_EQ(bins_of_start({depth, {1.71e6, 5.5e5, 4.5e5, 4.54e5, 4.9e5, 5.1e5}, none}), 2U);
  EXPECT_EQ(bins_of_start({depth, {1.88e6, 1.69e5, 9.8e4, 1.35e5, 1.68e5, 1.47e5}, none}), 2U);
  EXPECT_EQ(bins_of_start({depth, {4.4e5, 4.5e5, 4.6e5, 4.7e5, 4.6e5, 4.9e5}, none}), 0U) << "rises at once";
  EXPECT_EQ(bins_of_start({depth, {4.6e5, 4.5e5, 4.6e5, 4.7e5, 4.6e5, 4.9e5}, none}), 0U) << "noise";
  EXPECT_EQ(bins_of_start({{0.02, 0.03, 0.04}, {3e6, 2e6, 1e6}, {0, 0, 0}}), 0U)
      << "a soil that softens downward";
  EXPECT_EQ(bins_of_start({}), 0U);
}

}  // namespace
}  // namespace cpt::results

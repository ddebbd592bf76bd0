#include "parameters/designs/propagation.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <vector>

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(PropagationPlaces, GrowWithoutMovingAndLieWithin) {
  const MatrixXd few = propagation_places(5, 37, 3), many = propagation_places(5, 200, 3);
  EXPECT_EQ(many.topRows(37), few);
  EXPECT_GT(many.minCoeff(), 0.0);
  EXPECT_LT(many.maxCoeff(), 1.0);
  EXPECT_NE(propagation_places(5, 37, 4), few);
}

// 32 points of a section fall into 32 equal intervals of every input, one in each.
TEST(PropagationPlaces, EverySectionFillsTheRange) {
  const MatrixXd places = propagation_places(4, 32 * propagation_sections, 1);
  for (Index section = 0; section < propagation_sections; ++section)
    for (Index j = 0; j < 4; ++j) {
      std::vector<int> taken(32);
      for (Index i = section; i < places.rows(); i += propagation_sections)
        ++taken[static_cast<std::size_t>(places(i, j) * 32.0)];
      for (const int count : taken) EXPECT_EQ(count, 1);
    }
}

TEST(LatinPlaces, EveryTenRunsFillTheRangeAndMoreKeepThem) {
  const MatrixXd places = latin_places(4, 100, 5);
  for (Index first = 0; first < 100; first += latin_runs)
    for (Index j = 0; j < 4; ++j) {
      std::vector<int> taken(latin_runs);
      for (Index k = 0; k < latin_runs; ++k)
        ++taken[static_cast<std::size_t>(places(first + k, j) * latin_runs)];
      for (const int count : taken) EXPECT_EQ(count, 1);
    }
  EXPECT_EQ(latin_places(4, 37, 5), places.topRows(37));
  EXPECT_EQ(section_of(9, true), 0);
  EXPECT_EQ(section_of(10, true), 1);
  EXPECT_EQ(section_of(100, true), 0);
  EXPECT_EQ(section_of(13, false), 3);
}

TEST(SampleNumbers, AreThoseOfKnownSamples) {
  const VectorXd sample = VectorXd::LinSpaced(9, 1.0, 9.0);
  EXPECT_DOUBLE_EQ(sample_deviation(sample), std::sqrt(7.5));
  EXPECT_DOUBLE_EQ(sample_quantile(sample, 0.5), 5.0);
  EXPECT_NEAR(sample_quantile(sample, 0.25), (9.0 + 1.0 / 3.0) * 0.25 + 1.0 / 3.0, 1e-12);  // R: type = 8
  EXPECT_EQ(sample_quantile(sample, 0.0), 1.0);
  EXPECT_EQ(sample_quantile(sample, 1.0), 9.0);
}

TEST(BySections, LeavesOutWhatHasFailedAndNeedsFiveSections) {
  VectorXd y = VectorXd::LinSpaced(40, 0.0, 39.0);
  const auto mean = [](const VectorXd& of) { return of.mean(); };
  EXPECT_NEAR(by_sections(y, 2, mean).value, 19.5, 1e-12);
  EXPECT_LT(by_sections(y, 2, mean).lower, 19.5);
  y(3) = NAN;
  EXPECT_NEAR(by_sections(y, 2, mean).value, (780.0 - 3.0) / 39.0, 1e-12);
  for (Index i = 3; i < 40; i += propagation_sections) y(i) = NAN;
  EXPECT_LT(by_sections(y, 2, mean).lower, by_sections(y, 2, mean).value);  // of the nine others
  for (Index i = 0; i < 40; ++i)
    if (i % propagation_sections > 3) y(i) = NAN;
  EXPECT_TRUE(std::isnan(by_sections(y, 2, mean).lower));  // three are left
  EXPECT_TRUE(std::isnan(by_sections(VectorXd::Constant(5, NAN), 2, mean).value));
}

TEST(Exceedance, IsAShareWithAnIntervalThatIsNeverEmpty) {
  const VectorXd y = VectorXd::LinSpaced(100, 1.0, 100.0);
  const Estimate half = exceedance(y, false, 50.0);
  EXPECT_DOUBLE_EQ(half.value, 0.5);
  EXPECT_LT(half.lower, 0.5);
  EXPECT_GT(half.upper, 0.5);
  const Estimate never = exceedance(y, false, 100.0);  // equal is not above
  EXPECT_EQ(never.value, 0.0);
  EXPECT_EQ(never.lower, 0.0);
  EXPECT_NEAR(never.upper, 1.0 - std::pow(0.025, 0.01), 1e-9);  // (1 - p)^100 = 0.025
  const Estimate always = exceedance(y, false, 0.0);
  EXPECT_EQ(always.value, 1.0);
  EXPECT_NEAR(always.lower, std::pow(0.025, 0.01), 1e-9);
  EXPECT_TRUE(std::isnan(exceedance(VectorXd::Constant(3, NAN), false, 1.0).value));
}

// A normal sample with a relative error: mean 100, deviation 10 and 5 % of about 100.
TEST(NumericalError, WidensASampleAsTheSumOfTwoNormals) {
  const boost::math::normal soil(100.0, 10.0);
  constexpr Index n = 4000;
  VectorXd y(n);
  for (Index i = 0; i < n; ++i) y(i) = quantile(soil, (static_cast<double>(i) + 0.5) / n);
  const double both = std::sqrt(100.0 + 0.0025 * (100.0 * 100.0 + 100.0));
  EXPECT_NEAR(sample_deviation(y, 0.05), both, 0.005 * both);
  for (const double p : {0.05, 0.5, 0.95}) {  // of the mixture, which is a little skewed
    const double found = sample_quantile(y, p, 0.05);
    double below = 0.0;
    for (const double value : y) below += cdf(boost::math::normal(value, 0.05 * value), found) / n;
    EXPECT_NEAR(below, p, 0.002);
  }
  EXPECT_NEAR(exceedance(y, false, 115.0, 0.05).value,
              cdf(complement(boost::math::normal(100.0, both), 115.0)), 0.004);
  EXPECT_EQ(sample_quantile(y, 0.95, 0.0), sample_quantile(y, 0.95));
  EXPECT_EQ(exceedance(y, false, 115.0, 0.0).upper, exceedance(y, false, 115.0).upper);
  EXPECT_FALSE(suffices({0.95, 0.001}, y, 50, false, 0.05));
}

TEST(Suffices, LooksAtTheFirstRunsAndTheirNumberAlone) {
  VectorXd y = propagation_places(1, 100, 1).col(0).array() + 9.5;  // a mean of 10
  const StopRule mean{NAN, 0.01}, quantile{0.9, 0.01}, hopeless{NAN, 1e-9};
  EXPECT_TRUE(suffices(mean, y, 60, false));
  EXPECT_TRUE(suffices(quantile, y, 60, false));
  EXPECT_FALSE(suffices(hopeless, y, 60, false));
  for (Index i = 60; i < 100; i += propagation_sections) y(i) = 1e6;  // the first section's later runs
  EXPECT_TRUE(suffices(mean, y, 60, false));
  EXPECT_FALSE(suffices(mean, y, 100, false));
  EXPECT_FALSE(suffices(mean, VectorXd::Constant(100, NAN), 60, false));
}

// How often intervals hold the truth, of sums of four normal inputs, one of them squared for the mean; 95 %
// of 200 repetitions scatter by +- 3 % at two deviations.
TEST(BySections, IntervalsHoldTheTruthAsOftenAsTheySay) {
  const boost::math::normal normal;
  constexpr int repetitions = 200;
  for (const bool latin : {false, true}) {
    int mean = 0, deviation = 0, median = 0, exceeded = 0;
    for (std::uint64_t seed = 1; seed <= repetitions; ++seed) {
      const MatrixXd places = (latin ? latin_places : propagation_places)(4, 200, seed);
      VectorXd y(places.rows()), sum(places.rows());
      for (Index i = 0; i < places.rows(); ++i) {
        const auto z = [&](Index j) { return quantile(normal, places(i, j)); };
        y(i) = z(0) + 0.5 * z(1) + z(2) * z(2) + 0.3 * z(3);
        sum(i) = z(0) + z(1) + z(2) + z(3);
      }
      const auto holds = [](const Estimate& e, double truth) { return e.lower <= truth && truth <= e.upper; };
      const auto of = [&](const VectorXd& sample, int least, auto number) {
        return by_sections(sample, least, number, latin);
      };
      mean += holds(of(y, 1, [](const VectorXd& s) { return s.mean(); }), 1.0);
      deviation += holds(of(sum, 2, [](const VectorXd& s) { return sample_deviation(s); }), 2.0);
      median += holds(of(sum, 2, [](const VectorXd& s) { return sample_quantile(s, 0.5); }), 0.0);
      exceeded += holds(exceedance(sum, latin, 2.0), cdf(complement(normal, 1.0)));
    }
    for (const int count : {mean, deviation, median, exceeded}) {
      EXPECT_GE(count, 0.91 * repetitions) << latin;
      EXPECT_LE(count, repetitions) << latin;
    }
    for (const int count : {mean, median}) EXPECT_LE(count, 0.99 * repetitions) << latin;
  }
}

}  // namespace
}  // namespace cpt::parameters

#include "parameters/designs/sobol.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/parameters/designs/functions.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;

void expect_held(const std::vector<Estimate>& estimates, const Eigen::VectorXd& exact, double widest,
                 const char* what, double accuracy = 0.0) {
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const double truth = exact(static_cast<Index>(i));
    EXPECT_LE(estimates[i].lower, truth + accuracy) << what << ' ' << i;
    EXPECT_GE(estimates[i].upper, truth - accuracy) << what << ' ' << i;
    EXPECT_LE(estimates[i].upper - estimates[i].lower, widest) << what << ' ' << i;
  }
}

SobolIndices indices_of(const Function& function, int parameters, int rows, std::uint64_t seed = 1) {
  return sobol_indices(parameters, results_of(function, sobol_places(parameters, rows, seed)), seed);
}

TEST(Sobol, RowsAreABAndAWithOneColumnOfB) {
  const Eigen::MatrixXd places = sobol_places(3, 8, 1);
  ASSERT_EQ(places.rows(), 40);
  EXPECT_GE(places.minCoeff(), 0.0);
  EXPECT_LT(places.maxCoeff(), 1.0);
  for (Index row = 0; row < 8; ++row)
    for (Index i = 0; i < 3; ++i)
      for (Index j = 0; j < 3; ++j)
        EXPECT_EQ(places(5 * row + 2 + i, j), places(5 * row + (i == j ? 1 : 0), j));
}

// Of 2^m points of the sequence every interval of length 2^-m holds one, in each dimension, shifted or not.
TEST(Sobol, PointsAreBalanced) {
  const Eigen::MatrixXd places = sobol_places(4, 16, 7);
  for (Index half = 0; half < 2; ++half)
    for (Index j = 0; j < 4; ++j) {
      Eigen::VectorXi hits = Eigen::VectorXi::Zero(16);
      for (Index row = 0; row < 16; ++row) ++hits(static_cast<Index>(16.0 * places(6 * row + half, j)));
      EXPECT_TRUE((hits.array() == 1).all());
    }
}

TEST(Sobol, SeedFixesThePoints) {
  EXPECT_EQ(sobol_places(3, 8, 4), sobol_places(3, 8, 4));
  EXPECT_NE(sobol_places(3, 8, 4), sobol_places(3, 8, 5));
  EXPECT_EQ(sobol_places(3, 16, 4).topRows(8 * 5), sobol_places(3, 8, 4)) << "more keep what there is";
}

TEST(Sobol, ResultsThatDoNotVaryHaveNoIndices) {
  const auto indices = indices_of([](const auto& u) { return 4.0 + 1e-13 * u.sum(); }, 3, 16);
  for (const auto& estimates : {indices.first, indices.total})
    for (const Estimate& e : estimates)
      EXPECT_TRUE(std::isnan(e.value) && std::isnan(e.lower) && std::isnan(e.upper));
  EXPECT_EQ(indices.used, 16);
}

// One row of sixteen varies: samples without it are no samples of roundings over each other.
TEST(Sobol, SamplesThatDoNotVaryDoNotCount) {
  Eigen::VectorXd y = Eigen::VectorXd::Constant(16 * 5, 4.0);
  for (Index run = 0; run < y.size(); ++run) y(run) += 1e-14 * static_cast<double>(run % 7);
  y(0) = 5.0;
  const auto indices = sobol_indices(3, y, 1);
  EXPECT_FALSE(std::isnan(indices.total[0].value));
  EXPECT_TRUE(std::isnan(indices.total[0].lower)) << "a third of the samples has no index";
}

TEST(Sobol, IshigamiMeetsItsExactIndices) {
  const auto exact = ishigami_indices();
  const auto indices = indices_of(ishigami, 3, 2048);
  expect_held(indices.first, exact.first, 0.15, "first");
  expect_held(indices.total, exact.total, 0.15, "total");
  EXPECT_EQ(indices.used, 2048);
}

TEST(Sobol, GFunctionMeetsItsExactIndices) {
  const auto indices = indices_of(g_function, 4, 2048);
  expect_held(indices.first, g_first(), 0.2, "first");
  expect_held(indices.total, g_total(), 0.2, "total");
}

TEST(Sobol, BoreholeMeetsItsQuadrature) {
  const auto exact = borehole_indices();
  const auto indices = indices_of(borehole, 8, 1024);
  expect_held(indices.first, exact.first, 0.2, "first", borehole_accuracy);
  expect_held(indices.total, exact.total, 0.2, "total", borehole_accuracy);
}

// A cheap case many times: a sum, whose shares are the squares of its weights.
TEST(Sobol, IntervalsCover) {
  constexpr int trials = 100;
  int held = 0;
  for (int seed = 0; seed < trials; ++seed) {
    const auto indices =
        indices_of([](const auto& u) { return u(0) + 2.0 * u(1); }, 2, 64, static_cast<std::uint64_t>(seed));
    held += indices.first[1].lower <= 0.8 && 0.8 <= indices.first[1].upper ? 1 : 0;
    held += indices.total[0].lower <= 0.2 && 0.2 <= indices.total[0].upper ? 1 : 0;
  }
  EXPECT_GE(held / (2.0 * trials), 0.93);  // more than 0.95: Sobol' points scatter less than random ones
}

// By hand: f(B) with f(A_B^i), and f(A) with it.
TEST(Sobol, MartinezIsTheCorrelation) {
  Eigen::VectorXd y(12);
  y << 1, 5, 4, /**/ 2, 3, 3, /**/ 4, 8, 6, /**/ 7, 1, 2;
  // B: 5 3 8 1, A: 1 2 4 7, A_B: 4 3 6 2, about their means 4.25, 3.5, 3.75.
  const double with_b = (0.75 * 0.25 + 1.25 * 0.75 + 3.75 * 2.25 + 3.25 * 1.75),
               with_a = (-2.5 * 0.25 + 1.5 * 0.75 + 0.5 * 2.25 - 3.5 * 1.75);
  const double b = 0.5625 + 1.5625 + 14.0625 + 10.5625, a = 6.25 + 2.25 + 0.25 + 12.25,
               both = 0.0625 + 0.5625 + 5.0625 + 3.0625;
  const auto indices = sobol_indices(1, y, 1, SobolEstimator::martinez);
  EXPECT_NEAR(indices.first[0].value, with_b / std::sqrt(b * both), 1e-14);
  EXPECT_NEAR(indices.total[0].value, 1.0 - with_a / std::sqrt(a * both), 1e-14);
}

TEST(Sobol, MartinezMeetsExactIndices) {
  for (const auto& [function, inputs, exact] :
       {std::tuple<Function, int, Indices>{ishigami, 3, ishigami_indices()},
        std::tuple<Function, int, Indices>{g_function, 4, {g_first(), g_total()}}}) {
    const Eigen::VectorXd y = results_of(function, sobol_places(inputs, 2048, 1));
    const auto indices = sobol_indices(inputs, y, 1, SobolEstimator::martinez);
    expect_held(indices.first, exact.first, 0.2, "first");
    expect_held(indices.total, exact.total, 0.2, "total");
    // Another unit and another zero: the same.
    const auto moved = sobol_indices(inputs, 1e3 - 20.0 * y.array(), 1, SobolEstimator::martinez);
    for (std::size_t i = 0; i < moved.total.size(); ++i)
      EXPECT_NEAR(moved.total[i].value, indices.total[i].value, 1e-10);
  }
}

TEST(Sobol, SectionsAreBalancedSamplesOfTheirOwn) {
  const Eigen::MatrixXd places = sobol_places(3, 40, 2, 5), one = sobol_places(3, 8, 2);
  for (Index row = 0; row < 8; ++row)  // the first section is the sample that there is without them
    EXPECT_EQ(places.middleRows(25 * row, 5), one.middleRows(5 * row, 5));
  EXPECT_EQ(sobol_places(3, 60, 2, 5).topRows(200), places) << "more keep what there is";
  for (Index section = 0; section < 5; ++section)
    for (Index j = 0; j < 3; ++j) {
      Eigen::VectorXi hits = Eigen::VectorXi::Zero(8);
      for (Index row = section; row < 40; row += 5) ++hits(static_cast<Index>(8.0 * places(5 * row, j)));
      EXPECT_TRUE((hits.array() == 1).all());
    }
}

// 400 repetitions of an interval that holds 95 % scatter by 1.1 %: four deviations below, and at 1.5 times
// its width it would hold in more than 99 %.
TEST(Sobol, IntervalsOfSectionsHoldTheTruthAsOftenAsTheySay) {
  constexpr int trials = 400;
  const auto exact = ishigami_indices();
  for (const SobolEstimator estimator : {SobolEstimator::saltelli, SobolEstimator::martinez}) {
    int first = 0, total = 0;
    for (int seed = 1; seed <= trials; ++seed) {
      const auto s = static_cast<std::uint64_t>(seed);
      const auto indices =
          sobol_indices(3, results_of(ishigami, sobol_places(3, 160, s, 10)), s, estimator, 10);
      first += indices.first[0].lower <= exact.first(0) && exact.first(0) <= indices.first[0].upper ? 1 : 0;
      total += indices.total[2].lower <= exact.total(2) && exact.total(2) <= indices.total[2].upper ? 1 : 0;
    }
    for (const int held : {first, total}) {
      EXPECT_GE(held, 0.905 * trials);
      EXPECT_LE(held, 0.99 * trials);
    }
  }
}

TEST(Sobol, AnIntervalWantsFiveSections) {
  Eigen::VectorXd y = results_of(ishigami, sobol_places(3, 40, 1, 5));
  EXPECT_FALSE(std::isnan(sobol_indices(3, y, 1, SobolEstimator::saltelli, 5).total[0].lower));
  for (Index row = 2; row < 40; row += 5)
    if (row > 10) y(5 * row) = std::nan("");  // two rows are left of the third section
  const auto indices = sobol_indices(3, y, 1, SobolEstimator::saltelli, 5);
  EXPECT_FALSE(std::isnan(indices.total[0].value));
  EXPECT_TRUE(std::isnan(indices.total[0].lower));
  EXPECT_EQ(indices.dropped, 6);
}

TEST(Sobol, AFailedRunTakesItsRow) {
  Eigen::VectorXd y = results_of(ishigami, sobol_places(3, 64, 1));
  const auto whole = sobol_indices(3, y.tail(63 * 5), 1);
  y(3) = std::nan("");  // of the first row
  const auto indices = sobol_indices(3, y, 1);
  EXPECT_EQ(indices.used, 63);
  EXPECT_EQ(indices.dropped, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(indices.first[i].value, whole.first[i].value);
    EXPECT_DOUBLE_EQ(indices.total[i].upper, whole.total[i].upper);
  }
}

TEST(Sobol, WithoutVarianceOrRowsNothingIsDefined) {
  EXPECT_TRUE(std::isnan(sobol_indices(3, Eigen::VectorXd::Constant(40, 5.0), 1).total[0].value));
  const auto none = sobol_indices(3, Eigen::VectorXd::Constant(40, std::nan("")), 1);
  EXPECT_TRUE(std::isnan(none.first[0].value));
  EXPECT_EQ(none.used, 0);
  EXPECT_EQ(none.dropped, 8);
}

}  // namespace
}  // namespace cpt::parameters

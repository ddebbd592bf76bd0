#include "parameters/designs/morris.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/parameters/designs/functions.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;

TEST(Morris, TrajectoriesStepOnceInEveryParameterAndStayOnTheGrid) {
  for (const int levels : {2, 4, 6}) {
    const double step = levels / (2.0 * (levels - 1));
    const Eigen::MatrixXd places = morris_places(5, 7, levels, 3);
    ASSERT_EQ(places.rows(), 42);
    EXPECT_GE(places.minCoeff(), 0.0);
    EXPECT_LE(places.maxCoeff(), 1.0);
    for (const double place : places.reshaped())
      EXPECT_NEAR(place * (levels - 1), std::round(place * (levels - 1)), 1e-12);
    for (Index t = 0; t < 7; ++t) {
      Eigen::VectorXi moved = Eigen::VectorXi::Zero(5);
      for (Index k = 0; k < 5; ++k) {
        const Eigen::VectorXd change = (places.row(6 * t + k + 1) - places.row(6 * t + k)).cwiseAbs();
        EXPECT_NEAR(change.sum(), step, 1e-12);
        moved += (change.array() > 0.5 * step).cast<int>().matrix();
      }
      EXPECT_TRUE((moved.array() == 1).all());
    }
  }
}

TEST(Morris, SeedFixesThePoints) {
  EXPECT_EQ(morris_places(4, 6, 4, 9), morris_places(4, 6, 4, 9));
  EXPECT_NE(morris_places(4, 6, 4, 9), morris_places(4, 6, 4, 10));
  EXPECT_EQ(morris_places(4, 8, 4, 9).topRows(6 * 5), morris_places(4, 6, 4, 9)) << "more keep what there is";
}

// Every level is as likely as any other, whichever way the step goes.
TEST(Morris, LevelsComeEquallyOften) {
  const Eigen::MatrixXd places = morris_places(3, 2000, 4, 1);
  for (int level = 0; level < 4; ++level)
    EXPECT_NEAR(((places.array() * 3 - level).abs() < 0.1).cast<double>().mean(), 0.25, 0.02);
}

TEST(Morris, LinearFunctionIsExact) {
  const Eigen::Vector3d slope{4.0, -2.5, 0.0};
  const Eigen::MatrixXd places = morris_places(3, 8, 4, 1);
  const auto effects =
      elementary_effects(places, results_of([&](const auto& u) { return slope.dot(u); }, places), 1);
  for (std::size_t j = 0; j < 3; ++j) {
    const double expected = slope(static_cast<Index>(j));
    for (const Estimate& e : {effects[j].mu, effects[j].mu_star, effects[j].sigma}) {
      EXPECT_NEAR(e.lower, e.value, 1e-12);
      EXPECT_NEAR(e.upper, e.value, 1e-12);
    }
    EXPECT_NEAR(effects[j].mu.value, expected, 1e-12);
    EXPECT_NEAR(effects[j].mu_star.value, std::abs(expected), 1e-12);
    EXPECT_NEAR(effects[j].sigma.value, 0.0, 1e-12);
    EXPECT_EQ(effects[j].used, 8);
  }
}

// An implementation of its own, from the paper's matrices and definitions: B* = (1 x* + D/2 ((2 B - 1) D* +
// 1)) P* (Morris 1991, eq. 3), B strictly lower triangular of ones, D* random signs, P* a random permutation;
// an elementary effect is (y(x + D e_i) - y(x)) / D at the lower end of a step.
double bent(const Eigen::VectorXd& u) {
  return 3.0 * u(0) + u(1) * u(1) - 4.0 * u(0) * u(2) + std::sin(5.0 * u(3));
}
TEST(Morris, AgreesWithThePapersMatrices) {
  constexpr Index k = 4, trajectories = 12;
  constexpr int levels = 6;
  const double step = levels / (2.0 * (levels - 1));
  std::mt19937 random(11);
  Eigen::MatrixXd places(trajectories * (k + 1), k);
  std::vector<std::vector<double>> effects(k);
  for (Index t = 0; t < trajectories; ++t) {
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(k + 1, k), d = Eigen::MatrixXd::Zero(k, k), p = d;
    Eigen::RowVectorXd x(k);
    std::vector<Index> order(k);
    std::iota(order.begin(), order.end(), Index{0});
    std::shuffle(order.begin(), order.end(), random);
    for (Index j = 0; j < k; ++j) {
      b.col(j).tail(k - j).setOnes();
      d(j, j) = random() % 2 == 0 ? 1.0 : -1.0;
      p(j, order[static_cast<std::size_t>(j)]) = 1.0;
      x(j) = static_cast<double>(random() % (levels / 2)) / (levels - 1);
    }
    const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(k + 1, k);
    places.middleRows(t * (k + 1), k + 1) =
        (Eigen::VectorXd::Ones(k + 1) * x + 0.5 * step * ((2.0 * b - ones) * d + ones)) * p;
    for (Index i = 0; i < k; ++i)
      for (Index run = t * (k + 1); run < t * (k + 1) + k; ++run)
        if (places(run, i) != places(run + 1, i)) {
          Eigen::VectorXd low = places.row(run).transpose();
          low(i) = std::min(places(run, i), places(run + 1, i));
          Eigen::VectorXd high = low;
          high(i) += step;
          effects[static_cast<std::size_t>(i)].push_back((bent(high) - bent(low)) / step);
        }
  }
  const auto found = elementary_effects(places, results_of(bent, places), 1);
  for (std::size_t i = 0; i < effects.size(); ++i) {
    ASSERT_EQ(effects[i].size(), static_cast<std::size_t>(trajectories));
    double mean = 0.0, size = 0.0, squares = 0.0;
    for (const double effect : effects[i])
      mean += effect / trajectories, size += std::abs(effect) / trajectories;
    for (const double effect : effects[i]) squares += (effect - mean) * (effect - mean);
    EXPECT_NEAR(found[i].mu.value, mean, 1e-12);
    EXPECT_NEAR(found[i].mu_star.value, size, 1e-12);
    EXPECT_NEAR(found[i].sigma.value, std::sqrt(squares / (trajectories - 1.0)), 1e-12);
  }
}

// All elementary effects that the grid has, one by one: many trajectories of the project's own meet their
// mean, mean size and deviation.
TEST(Morris, TrajectoriesMeetTheMomentsOfTheWholeGrid) {
  constexpr int levels = 4, half = levels / 2, trajectories = 4000;
  const double step = levels / (2.0 * (levels - 1));
  const Eigen::MatrixXd places = morris_places(4, trajectories, levels, 5);
  const Eigen::VectorXd y = results_of(bent, places);
  const auto found = elementary_effects(places, y, 1);
  for (Index i = 0; i < 4; ++i) {
    std::vector<double> effects;
    for (int point = 0; point < levels * levels * levels * levels; ++point) {
      Eigen::VectorXd low(4);
      for (Index j = 0, left = point; j < 4; ++j, left /= levels)
        low(j) = static_cast<double>(left % levels) / (levels - 1);
      if (low(i) * (levels - 1) > half - 0.5) continue;
      Eigen::VectorXd high = low;
      high(i) += step;
      effects.push_back((bent(high) - bent(low)) / step);
    }
    const auto count = static_cast<double>(effects.size());
    double mean = 0.0, size = 0.0, squares = 0.0;
    for (const double effect : effects) mean += effect / count, size += std::abs(effect) / count;
    for (const double effect : effects) squares += (effect - mean) * (effect - mean) / count;
    const double scatter = 5.0 * std::sqrt(squares / trajectories) + 1e-12;  // five deviations of a mean
    const ElementaryEffects& of = found[static_cast<std::size_t>(i)];
    EXPECT_NEAR(of.mu.value, mean, scatter) << i;
    EXPECT_NEAR(of.mu_star.value, size, scatter) << i;
    EXPECT_NEAR(of.sigma.value, std::sqrt(squares), 2.0 * scatter) << i;
  }
}

// The g-function's factors are independent: of four levels, |4 u - 2| is 2 or 2/3 and a step goes from one to
// the other, so that an effect is 2 / (1 + a_i) up or down (u from 0 to 2/3 or from 1/3 to 1) times the
// product of the other factors, each (2 + a) / (1 + a) or (2/3 + a) / (1 + a), equally likely.
struct Moments {
  double mu_star, sigma;
};
Moments g_effects(Index i) {
  double mean = 2.0 / (1.0 + g_weights(i)), square = mean * mean;
  for (Index j = 0; j < 4; ++j) {
    if (j == i) continue;
    const double a = g_weights(j), high = (2.0 + a) / (1.0 + a), low = (2.0 / 3.0 + a) / (1.0 + a);
    mean *= 0.5 * (high + low);
    square *= 0.5 * (high * high + low * low);
  }
  return {mean, std::sqrt(square)};  // up as often as down: mu is 0
}

// Ten trajectories, as is usual, and forty: how often the intervals of four parameters hold the truth.
TEST(Morris, IntervalsHoldTheExactEffectsOfTheGFunction) {
  constexpr int trials = 50;
  struct Case {
    int trajectories;
    double least, least_of_sigma;
  };
  for (const Case& expected : {Case{10, 0.88, 0.91}, Case{40, 0.91, 0.90}}) {
    double mu = 0.0, mu_star = 0.0, sigma = 0.0;
    const auto held = [](const Estimate& e, double exact) {
      return e.lower <= exact && exact <= e.upper ? 1.0 / (4.0 * trials) : 0.0;
    };
    for (std::uint64_t seed = 0; seed < trials; ++seed) {
      const Eigen::MatrixXd places = morris_places(4, expected.trajectories, 4, seed);
      const auto effects = elementary_effects(places, results_of(g_function, places), seed);
      for (std::size_t i = 0; i < 4; ++i) {
        const Moments exact = g_effects(static_cast<Index>(i));
        mu += held(effects[i].mu, 0.0);
        mu_star += held(effects[i].mu_star, exact.mu_star);
        sigma += held(effects[i].sigma, exact.sigma);
      }
    }
    EXPECT_GE(mu, expected.least) << expected.trajectories;
    EXPECT_GE(mu_star, expected.least) << expected.trajectories;
    EXPECT_GE(sigma, expected.least_of_sigma) << expected.trajectories;
  }
}

TEST(Morris, AFailedRunTakesItsEffectsAlone) {
  const Eigen::MatrixXd places = morris_places(3, 6, 4, 2);
  Eigen::VectorXd y = results_of([](const auto& u) { return u.sum(); }, places);
  y(4 * 2 + 1) = std::nan("");  // within the third trajectory: the steps to it and from it
  const auto effects = elementary_effects(places, y, 1);
  int dropped = 0;
  for (const ElementaryEffects& of : effects) {
    EXPECT_EQ(of.used + of.dropped, 6);
    EXPECT_NEAR(of.mu_star.value, 1.0, 1e-12);
    EXPECT_NEAR(of.mu_star.upper, 1.0, 1e-12);
    dropped += of.dropped;
  }
  EXPECT_EQ(dropped, 2);
}

TEST(Morris, WithoutAnyResultNothingIsDefined) {
  const Eigen::MatrixXd places = morris_places(2, 4, 4, 2);
  const auto effects = elementary_effects(places, Eigen::VectorXd::Constant(12, std::nan("")), 1);
  EXPECT_TRUE(std::isnan(effects[0].mu_star.value));
  EXPECT_TRUE(std::isnan(effects[0].mu_star.lower));
  EXPECT_EQ(effects[0].used, 0);
  EXPECT_EQ(effects[0].dropped, 4);
}

TEST(Morris, ResultsThatDoNotVaryHaveNoEffects) {
  const Eigen::MatrixXd places = morris_places(3, 6, 4, 2);
  Eigen::VectorXd y = results_of([](const auto& u) { return 815.15 + 1e-10 * u.sum(); }, places);
  y(5) = std::nan("");
  const auto effects = elementary_effects(places, y, 1);
  int dropped = 0;
  for (const ElementaryEffects& of : effects) {
    for (const Estimate& e : {of.mu, of.mu_star, of.sigma})
      EXPECT_TRUE(std::isnan(e.value) && std::isnan(e.lower) && std::isnan(e.upper));
    dropped += of.dropped;
  }
  EXPECT_EQ(dropped, 2);
}

// An input that matters to rounding alone has no effect, while others have one.
TEST(Morris, AStepWithinRoundingHasNoEffect) {
  const Eigen::MatrixXd places = morris_places(2, 6, 4, 2);
  const auto effects = elementary_effects(
      places, results_of([](const auto& u) { return 815.15 + 1e-10 * u(0) + u(1); }, places), 1);
  EXPECT_EQ(effects[0].mu_star.value, 0.0);
  EXPECT_EQ(effects[0].sigma.upper, 0.0);
  EXPECT_NEAR(effects[1].mu_star.value, 1.0, 1e-9);
}

}  // namespace
}  // namespace cpt::parameters

// The latin hypercube and the polynomial chaos that reads it.
#include "parameters/designs/latin_hypercube.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "parameters/designs/orthonormal.hpp"
#include "parameters/designs/polynomial_chaos.hpp"
#include "parameters/designs/variation.hpp"
#include "tests/parameters/designs/functions.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;

std::vector<int> numbers(int parameters) { return std::vector<int>(static_cast<std::size_t>(parameters)); }

ChaosIndices indices_of(const Function& function, int parameters, int runs, std::uint64_t seed = 1) {
  const Eigen::MatrixXd places = latin_hypercube_places(parameters, runs, seed);
  return polynomial_chaos(places, numbers(parameters), results_of(function, places));
}

// Within the interval, or within what the expansion says it misses; a millionth where it misses less.
void expect_held(const ChaosIndices& fit, const std::vector<Estimate>& estimates,
                 const Eigen::VectorXd& exact, const char* what) {
  const double missed = std::max(1.0 - fit.q2, 1e-6);
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const double truth = exact(static_cast<Index>(i));
    EXPECT_LE(estimates[i].lower - missed, truth) << what << ' ' << i;
    EXPECT_GE(estimates[i].upper + missed, truth) << what << ' ' << i;
  }
}

TEST(LatinHypercube, HasOnePlaceInEveryIntervalOfEveryParameter) {
  const Eigen::MatrixXd places = latin_hypercube_places(3, 20, 5);
  for (Index j = 0; j < 3; ++j) {
    Eigen::VectorXi hits = Eigen::VectorXi::Zero(20);
    for (Index run = 0; run < 20; ++run) ++hits(static_cast<Index>(20.0 * places(run, j)));
    EXPECT_TRUE((hits.array() == 1).all());
  }
  EXPECT_EQ(places, latin_hypercube_places(3, 20, 5));
  EXPECT_NE(places, latin_hypercube_places(3, 20, 6));
}

// A polynomial within the basis: exact, and it says so.
TEST(PolynomialChaos, PolynomialIsExact) {
  const auto fit = indices_of([](const auto& u) { return 5.0 + 3.0 * u(0) + 4.0 * u(1); }, 3, 30);
  EXPECT_EQ(fit.problem, "");
  EXPECT_NEAR(fit.q2, 1.0, 1e-12);
  EXPECT_NEAR(fit.first[0].value, 9.0 / 25.0, 1e-12);
  EXPECT_NEAR(fit.total[1].lower, 16.0 / 25.0, 1e-9);
  EXPECT_NEAR(fit.total[1].upper, 16.0 / 25.0, 1e-9);
  EXPECT_NEAR(fit.total[2].value, 0.0, 1e-12);
  EXPECT_EQ(fit.used, 30);
}

TEST(PolynomialChaos, IshigamiMeetsItsExactIndices) {
  const auto exact = ishigami_indices();
  const auto fit = indices_of(ishigami, 3, 300);
  EXPECT_GT(fit.q2, 0.95);
  expect_held(fit, fit.first, exact.first, "first");
  expect_held(fit, fit.total, exact.total, "total");
}

TEST(PolynomialChaos, GFunctionMeetsItsExactIndices) {
  const auto fit = indices_of(g_function, 4, 400);
  EXPECT_GT(fit.q2, least_q2);
  expect_held(fit, fit.first, g_first(), "first");
  expect_held(fit, fit.total, g_total(), "total");
}

TEST(PolynomialChaos, BoreholeMeetsItsQuadrature) {
  const auto exact = borehole_indices();
  const auto fit = indices_of(borehole, 8, 120);
  EXPECT_GT(fit.q2, 0.97);
  expect_held(fit, fit.first, exact.first, "first");
  expect_held(fit, fit.total, exact.total, "total");
}

// Noise that no polynomial explains: the intervals of the coefficients hold the shares of what is explained.
TEST(PolynomialChaos, IntervalsCover) {
  constexpr int trials = 100;
  int held = 0;
  for (int seed = 0; seed < trials; ++seed) {
    const auto fit =
        indices_of([](const auto& u) { return u(0) + 2.0 * u(1) + 0.05 * std::sin(1e4 * (u(0) + u(1))); }, 2,
                   40, static_cast<std::uint64_t>(seed));
    held += fit.first[1].lower <= 0.8 && 0.8 <= fit.first[1].upper ? 1 : 0;
  }
  EXPECT_GE(held / static_cast<double>(trials), 0.88);
  EXPECT_LE(held / static_cast<double>(trials), 1.0);
}

// A choice has two values and one term beside the constant: its prediction is the mean of the runs at the
// same value that are not left out, every tenth from the first on, the second and so on.
TEST(PolynomialChaos, Q2IsThatOfRunsLeftOut) {
  constexpr Index runs = 23;
  Eigen::MatrixXd places(runs, 1);
  Eigen::VectorXd y(runs);
  for (Index run = 0; run < runs; ++run) {
    places(run, 0) = run % 3 == 0 ? 0.0 : 1.0;
    y(run) = 2.0 * places(run, 0) + std::sin(12.0 * static_cast<double>(run));
  }
  double squares = 0.0;
  for (Index out = 0; out < runs; ++out) {
    double sum = 0.0, count = 0.0;
    for (Index run = 0; run < runs; ++run)
      if (run % 10 != out % 10 && places(run, 0) == places(out, 0)) sum += y(run), count += 1.0;
    squares += std::pow(y(out) - sum / count, 2);
  }
  const auto fit = polynomial_chaos(places, {2}, y);
  EXPECT_EQ(fit.terms, 2);
  EXPECT_NEAR(fit.q2, 1.0 - squares / (y.array() - y.mean()).square().sum(), 1e-10);
}

// Few runs find few terms of high degree: a full polynomial of 60 runs tells nothing of Ishigami's function.
TEST(PolynomialChaos, FewRunsFindFewTermsOfHighDegree) {
  const auto exact = ishigami_indices();
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const auto fit = indices_of(ishigami, 3, 80, seed);
    EXPECT_GT(fit.q2, 0.95) << seed;
    EXPECT_LE(fit.terms, 40) << seed;
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(fit.first[j].value, exact.first(static_cast<Index>(j)), 0.02) << seed << ' ' << j;
      EXPECT_NEAR(fit.total[j].value, exact.total(static_cast<Index>(j)), 0.02) << seed << ' ' << j;
    }
  }
}

// Candidates that noise alone chooses do not vouch for themselves.
TEST(PolynomialChaos, NoiseHasNoQ2) {
  const Eigen::MatrixXd places = latin_hypercube_places(4, 40, 3);
  double most = -1.0;
  for (const double of : {1.1e5, 2.3e5, 3.7e5, 5.9e5, 8.3e5})
    most = std::max(
        most,
        polynomial_chaos(
            places, numbers(4),
            results_of([&](const auto& u) { return std::sin(of * (u(0) + u(1) + u(2) + u(3))); }, places))
            .q2);
  EXPECT_LT(most, 0.3);
}

// A choice has two values: it is no polynomial of higher degree and needs no half-way runs.
TEST(PolynomialChaos, ChoiceHasItsShare) {
  Eigen::MatrixXd places = latin_hypercube_places(2, 40, 2);
  for (double& place : places.col(1)) place = place < 0.5 ? 0.0 : 1.0;
  const auto fit = polynomial_chaos(
      places, {0, 2}, results_of([](const auto& u) { return u(0) + 0.5 * u(1) + u(0) * u(1); }, places));
  // With the choice c and x = 2 u - 1: variance of (1 + c) u + c / 2 = 1/12 (1.5^2 + 0.5^2) + 1/4.
  const double first = 1.5 * 1.5 / 12.0, both = 0.5 * 0.5 / 12.0, choice = 0.25;
  EXPECT_NEAR(fit.q2, 1.0, 1e-10);
  EXPECT_NEAR(fit.first[0].value, first / (first + both + choice), 1e-10);
  EXPECT_NEAR(fit.first[1].value, choice / (first + both + choice), 1e-10);
  EXPECT_NEAR(fit.total[1].value, (choice + both) / (first + both + choice), 1e-10);
}

TEST(PolynomialChaos, SaysThatItIsNotToBeBelieved) {
  const auto fit =
      indices_of([](const auto& u) { return std::sin(60.0 * u(0)) * std::sin(70.0 * u(1)); }, 2, 30);
  EXPECT_LT(fit.q2, least_q2);
  EXPECT_NE(fit.problem.find("not to be believed"), std::string::npos) << fit.problem;
}

TEST(PolynomialChaos, LeavesFailedRunsOut) {
  const Eigen::MatrixXd places = latin_hypercube_places(3, 40, 1);
  Eigen::VectorXd y = results_of([](const auto& u) { return 3.0 * u(0) + 4.0 * u(1); }, places);
  y(0) = y(7) = std::nan("");
  const auto fit = polynomial_chaos(places, numbers(3), y);
  EXPECT_EQ(fit.used, 38);
  EXPECT_EQ(fit.dropped, 2);
  EXPECT_NEAR(fit.first[0].value, 0.36, 1e-10);
}

TEST(PolynomialChaos, TooFewRunsAndConstantResultsAreUndefined) {
  const auto few = indices_of([](const auto& u) { return u(0); }, 3, 7);
  EXPECT_TRUE(std::isnan(few.first[0].value));
  EXPECT_NE(few.problem.find("7 completed runs, 3 parameters need 8"), std::string::npos) << few.problem;
  const auto constant = indices_of([](const auto&) { return 4.0; }, 3, 30);
  EXPECT_TRUE(std::isnan(constant.total[0].value));
  EXPECT_EQ(constant.problem, does_not_vary);
}

TEST(PolynomialChaos, RoundingIsNoVariation) {
  const auto fit = indices_of([](const auto& u) { return 2000.0 + 1e-9 * u(0); }, 3, 30);
  EXPECT_EQ(fit.problem, does_not_vary);
  EXPECT_TRUE(std::isnan(fit.first[0].value));
  EXPECT_TRUE(std::isnan(fit.q2));
  const auto little = indices_of([](const auto& u) { return 2000.0 + 1e-4 * u(0); }, 3, 30);
  EXPECT_EQ(little.problem, "");
  EXPECT_NEAR(little.first[0].value, 1.0, 1e-9);
}

// A whole number from 1 to 4 is 1 and 4 half as often as 2 and 3; its polynomials know that.
TEST(PolynomialChaos, WholeNumberHasItsShare) {
  Eigen::MatrixXd places = latin_hypercube_places(2, 60, 2);
  for (double& place : places.col(1)) place = std::round(3.0 * place) / 3.0;
  const auto linear = [](const auto& u) { return u(0) + 0.8 * u(1); };
  const auto fit = polynomial_chaos(places, {0, 4}, results_of(linear, places));
  const double number = 1.0 / 12.0, whole = 0.64 * (11.0 / 12.0) / 9.0;
  EXPECT_NEAR(fit.q2, 1.0, 1e-10);
  EXPECT_NEAR(fit.first[1].value, whole / (number + whole), 1e-10);
  EXPECT_NEAR(fit.total[0].value, number / (number + whole), 1e-10);
}

// Whatever the values: 1 on average of the square, nothing between two degrees.
TEST(OrthonormalPolynomials, AreOrthonormalOverTheirValues) {
  for (const int values : {2, 3, 4, 11, 300}) {
    const OrthonormalPolynomials p(values, 8);
    EXPECT_EQ(p.most_degree(), std::min(8, values - 1));
    for (int a = 1; a <= p.most_degree(); ++a)
      for (int b = 1; b <= a; ++b) {
        double product = 0.0;
        for (int i = 0; i < values; ++i) {
          const double place = i / (values - 1.0),
                       weight = (i == 0 || i == values - 1 ? 0.5 : 1.0) / (values - 1);
          product += weight * p(a, place) * p(b, place);
        }
        EXPECT_NEAR(product, a == b ? 1.0 : 0.0, 1e-12) << values << ' ' << a << ' ' << b;
      }
  }
  const OrthonormalPolynomials legendre(0, 20), choice(2, 20), many(5000, 4);
  EXPECT_NEAR(legendre(2, 0.75), std::sqrt(5.0) * (3.0 * 0.25 - 1.0) / 2.0, 1e-14);
  EXPECT_NEAR(choice(1, 0.0), -1.0, 1e-15);
  EXPECT_NEAR(many(3, 1.0), std::sqrt(7.0), 1e-3);
}

}  // namespace
}  // namespace cpt::parameters

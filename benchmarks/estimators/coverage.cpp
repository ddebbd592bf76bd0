// How often the 95 % intervals of the designs' estimators hold known truths: repetitions with seeds 1, 2, ...
// on analytic functions, as a table in Markdown (docs/estimators.md).
#include "benchmarks/estimators/coverage.hpp"

#include <fmt/format.h>

#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <vector>

#include "parameters/designs/latin_hypercube.hpp"
#include "parameters/designs/morris.hpp"
#include "parameters/designs/multifidelity.hpp"
#include "parameters/designs/pairs.hpp"
#include "parameters/designs/polynomial_chaos.hpp"
#include "parameters/designs/propagation.hpp"
#include "parameters/designs/shapley.hpp"
#include "parameters/designs/sobol.hpp"
#include "parameters/designs/value_of_score.hpp"
#include "results/statistics/repeat_noise.hpp"
#include "tests/parameters/designs/functions.hpp"

namespace cpt::benchmarks {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using parameters::Estimate;

/// A number whose truth is known.
struct Known {
  std::string name;
  double truth;
};

/// What is repeated: the estimates of one seed, in the order of `numbers`.
struct Case {
  std::string estimator, function;
  std::vector<Known> numbers;
  std::function<std::vector<Estimate>(std::uint64_t seed)> estimates;
};

std::vector<Known> shares(const VectorXd& first, const VectorXd& total) {
  std::vector<Known> numbers;
  for (Index i = 0; i < first.size(); ++i) numbers.push_back({fmt::format("S{}", i + 1), first(i)});
  for (Index i = 0; i < total.size(); ++i) numbers.push_back({fmt::format("T{}", i + 1), total(i)});
  return numbers;
}

std::vector<Estimate> joined(std::vector<Estimate> first, const std::vector<Estimate>& total) {
  first.insert(first.end(), total.begin(), total.end());
  return first;
}

struct TestFunction {
  std::string name;
  parameters::Function of;
  parameters::Indices exact;
};
std::vector<TestFunction> test_functions() {
  return {{"Ishigami", parameters::ishigami, parameters::ishigami_indices()},
          {"g-function", parameters::g_function, {parameters::g_first(), parameters::g_total()}}};
}

void add_sobol(std::vector<Case>& cases, int rows, int sections) {
  using parameters::SobolEstimator;
  for (const auto estimator : {SobolEstimator::saltelli, SobolEstimator::martinez})
    for (const TestFunction& function : test_functions()) {
      const auto inputs = static_cast<int>(function.exact.first.size());
      cases.push_back(
          {fmt::format("sobol {}, {} rows{}", estimator == SobolEstimator::martinez ? "martinez" : "saltelli",
                       rows, sections > 1 ? fmt::format(" in {} sections", sections) : ""),
           function.name, shares(function.exact.first, function.exact.total), [=](std::uint64_t seed) {
             const MatrixXd places = parameters::sobol_places(inputs, rows, seed, sections);
             const auto indices = parameters::sobol_indices(
                 inputs, parameters::results_of(function.of, places), seed, estimator, sections);
             return joined(indices.first, indices.total);
           }});
    }
}

// A sum with noise that no polynomial explains.
double noisy_sum(const VectorXd& u) { return u(0) + 2.0 * u(1) + 0.05 * std::sin(1e4 * (u(0) + u(1))); }

void add_chaos(std::vector<Case>& cases, const std::string& name, const parameters::Function& function,
               const VectorXd& first, const VectorXd& total, int runs) {
  const auto inputs = static_cast<int>(first.size());
  cases.push_back(
      {fmt::format("latin_hypercube, {} runs", runs), name, shares(first, total), [=](std::uint64_t seed) {
         const MatrixXd places = parameters::latin_hypercube_places(inputs, runs, seed);
         const auto fit =
             parameters::polynomial_chaos(places, std::vector<int>(static_cast<std::size_t>(inputs)),
                                          parameters::results_of(function, places));
         return joined(fit.first, fit.total);
       }});
}

// tests/parameters/designs/morris_test.cpp has the derivation: of four levels the effect of an input of the
// g-function is +-2 / (1 + a_i) times the other factors, (2 + a) / (1 + a) or (2/3 + a) / (1 + a).
void add_morris(std::vector<Case>& cases, int trajectories) {
  std::vector<Known> numbers;
  for (Index i = 0; i < 4; ++i) {
    double mean = 2.0 / (1.0 + parameters::g_weights(i)), square = mean * mean;
    for (Index j = 0; j < 4; ++j) {
      if (j == i) continue;
      const double a = parameters::g_weights(j), high = (2.0 + a) / (1.0 + a),
                   low = (2.0 / 3.0 + a) / (1.0 + a);
      mean *= 0.5 * (high + low);
      square *= 0.5 * (high * high + low * low);
    }
    numbers.push_back({fmt::format("mu{}", i + 1), 0.0});
    numbers.push_back({fmt::format("mu_star{}", i + 1), mean});
    numbers.push_back({fmt::format("sigma{}", i + 1), std::sqrt(square)});
  }
  cases.push_back(
      {fmt::format("morris, {} trajectories", trajectories), "g-function", numbers, [=](std::uint64_t seed) {
         const MatrixXd places = parameters::morris_places(4, trajectories, 4, seed);
         std::vector<Estimate> all;
         for (const auto& of : parameters::elementary_effects(
                  places, parameters::results_of(parameters::g_function, places), seed))
           for (const Estimate& estimate : {of.mu, of.mu_star, of.sigma}) all.push_back(estimate);
         return all;
       }});
}

// 100 + 20 a + 30 b + 8 a b of two inputs between 0 and 1: the interaction is 4. Runs scatter by 1 %.
void add_pairs(std::vector<Case>& cases, int repeats) {
  cases.push_back(
      {fmt::format("pairs, {} repeats", repeats),
       "100 + 20 a + 30 b + 8 a b, 1 % noise",
       {{"interaction", 4.0}},
       [=](std::uint64_t seed) {
         boost::random::mt19937_64 bits(seed);
         boost::random::normal_distribution<double> factor(1.0, 0.01);
         std::vector<double> baseline{100.0 * factor(bits)};
         for (int k = 0; k < repeats; ++k) baseline.push_back(100.0 * factor(bits));
         const auto noise = results::repeat_noise(baseline).value();
         return std::vector{parameters::interaction_estimate(
             {100.0 * factor(bits), 120.0 * factor(bits), 130.0 * factor(bits), 158.0 * factor(bits)},
             results::index_half_width(noise) / std::sqrt(2.0))};
       }});
}

// A sum of four standard normal inputs, and its exponential of a quarter of it, which is lognormal.
void add_propagation(std::vector<Case>& cases, int runs, bool lognormal, bool latin) {
  const boost::math::normal normal;
  const auto result = [=](double sum) { return lognormal ? std::exp(0.25 * sum) : sum; };
  const double s = 0.5;  // deviation of a quarter of the sum
  std::vector<Known> numbers = {
      {"mean", lognormal ? std::exp(0.5 * s * s) : 0.0},
      {"standard_deviation", lognormal ? std::sqrt(std::expm1(s * s) * std::exp(s * s)) : 2.0}};
  for (const int percent : {5, 25, 50, 75, 95})
    numbers.push_back(
        {fmt::format("quantile_{:02}", percent), result(2.0 * quantile(normal, percent / 100.0))});
  const double threshold = result(2.0);  // one deviation of the sum above its mean
  numbers.push_back({"exceedance", cdf(complement(normal, 1.0))});
  cases.push_back(
      {fmt::format("propagation{}, {} runs", latin ? " of Latin hypercubes" : "", runs),
       lognormal ? "exp(sum / 4) of four normal" : "sum of four normal", numbers, [=](std::uint64_t seed) {
         const MatrixXd places =
             (latin ? parameters::latin_places : parameters::propagation_places)(4, runs, seed);
         VectorXd y(runs);
         for (Index i = 0; i < runs; ++i) {
           double sum = 0.0;
           for (Index j = 0; j < 4; ++j) sum += quantile(normal, places(i, j));
           y(i) = result(sum);
         }
         std::vector<Estimate> all = {
             parameters::by_sections(
                 y, 1, [](const VectorXd& of) { return of.mean(); }, latin),
             parameters::by_sections(
                 y, 2, [](const VectorXd& of) { return parameters::sample_deviation(of); }, latin)};
         for (const int percent : {5, 25, 50, 75, 95})
           all.push_back(parameters::by_sections(
               y, 2, [=](const VectorXd& of) { return parameters::sample_quantile(of, percent / 100.0); },
               latin));
         all.push_back(parameters::exceedance(y, latin, threshold));
         return all;
       }});
}

// Three correlated normal inputs, 0.4 z1 + 0.4 z2 + 0.2 z3 or its exponential, with noise of a tenth of the
// deviation that no polynomial explains and that is not part of the truth.
void add_shapley(std::vector<Case>& cases, int runs, bool exponential) {
  const VectorXd shares = parameters::correlated_shares(exponential),
                 effects = parameters::shapley_effects(3, shares);
  std::vector<Known> numbers;
  for (Index i = 0; i < 3; ++i) numbers.push_back({fmt::format("Sh{}", i + 1), effects(i)});
  for (Index i = 0; i < 3; ++i) numbers.push_back({fmt::format("S{}", i + 1), shares(Index{1} << i)});
  for (Index i = 0; i < 3; ++i)
    numbers.push_back({fmt::format("T{}", i + 1), 1.0 - shares(7 - (Index{1} << i))});
  cases.push_back(
      {fmt::format("propagation Shapley, {} runs", runs),
       exponential ? "exp of correlated normal inputs, noise" : "sum of correlated normal inputs, noise",
       numbers, [=](std::uint64_t seed) {
         constexpr double most_score = 4.0;
         const MatrixXd correlation = parameters::correlated_inputs();
         const MatrixXd independent =
             parameters::propagation_places(4, runs, seed).unaryExpr(&parameters::score_of_probability);
         const MatrixXd scores = independent.leftCols(3) * MatrixXd(correlation.llt().matrixL()).transpose();
         VectorXd y = scores * parameters::correlated_slope;
         if (exponential) y = y.array().exp();
         y += 0.1 * parameters::sample_deviation(y) * independent.col(3);
         const std::vector<parameters::ScoredInput> inputs(
             3, {0, [](double score) { return 0.5 + 0.5 * score / most_score; }});
         const auto found = parameters::shapley_indices((0.5 + 0.5 * scores.array() / most_score).matrix(), y,
                                                        inputs, correlation, seed);
         return joined(joined(found.shapley, found.first), found.total);
       }});
}

// A dear model of three standard normal inputs, 10 + a + 0.6 b + 0.2 c, and a cheap one that knows two of
// them; where `emulated` is above 0 a third level that nearly knows these two.
void add_multifidelity(std::vector<Case>& cases, int dear, int cheap, int emulated) {
  const boost::math::normal normal;
  const double deviation = std::sqrt(1.0 + 0.36 + 0.04);
  cases.push_back(
      {fmt::format("combine, {} and {} runs{}", dear, cheap,
                   emulated > 0 ? fmt::format(", {} emulated", emulated) : ""),
       emulated > 0 ? "normal sums, correlations 0.986 and 0.983" : "normal sums, correlation 0.986",
       {{"mean", 10.0},
        {"standard_deviation", deviation},
        {"quantile_50", 10.0},
        {"quantile_95", 10.0 + quantile(normal, 0.95) * deviation}},
       [=](std::uint64_t seed) {
         const MatrixXd places = parameters::propagation_places(3, std::max(cheap, emulated), seed);
         VectorXd few(dear), many(cheap), most(emulated);
         for (Index i = 0; i < places.rows(); ++i) {
           const auto z = [&](Index j) { return quantile(normal, places(i, j)); };
           if (i < cheap) many(i) = 5.0 + 2.0 * (z(0) + 0.6 * z(1));
           if (i < dear) few(i) = 10.0 + z(0) + 0.6 * z(1) + 0.2 * z(2);
           if (i < emulated) most(i) = 5.0 + 2.0 * (z(0) + 0.5 * z(1));
         }
         parameters::Levels levels = {few, many};
         if (emulated > 0) levels.push_back(most);
         return std::vector{parameters::combined_mean(levels), parameters::combined_deviation(levels),
                            parameters::combined_quantile(levels, 0.5),
                            parameters::combined_quantile(levels, 0.95)};
       }});
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  add_sobol(cases, 64, 1);
  add_sobol(cases, 80, 10);
  add_sobol(cases, 160, 10);
  add_chaos(cases, "sum with noise", noisy_sum, Eigen::Vector2d(0.2, 0.8), Eigen::Vector2d(0.2, 0.8), 40);
  add_chaos(cases, "g-function", parameters::g_function, parameters::g_first(), parameters::g_total(), 60);
  const auto borehole = parameters::borehole_indices();
  add_chaos(cases, "borehole", parameters::borehole, borehole.first, borehole.total, 60);
  for (const int trajectories : {10, 20, 40}) add_morris(cases, trajectories);
  for (const int repeats : {4, 6}) add_pairs(cases, repeats);
  for (const bool latin : {false, true})
    for (const bool lognormal : {false, true})
      for (const int runs : {100, 200}) add_propagation(cases, runs, lognormal, latin);
  for (const bool exponential : {false, true})
    for (const int runs : {60, 200}) add_shapley(cases, runs, exponential);
  for (const int dear : {20, 40, 100}) add_multifidelity(cases, dear, 800, 0);
  add_multifidelity(cases, 40, 200, 4000);
  return cases;
}

}  // namespace

void print_coverage(int repetitions) {
  fmt::print("| estimator | function | number | truth | held (%) | its 95 % interval | 93 to 97 % |\n");
  fmt::print("|---|---|---|---|---|---|---|\n");
  for (const Case& tried : all_cases()) {
    std::vector<int> held(tried.numbers.size()), none(tried.numbers.size());
    for (int seed = 1; seed <= repetitions; ++seed) {
      const auto estimates = tried.estimates(static_cast<std::uint64_t>(seed));
      for (std::size_t k = 0; k < held.size(); ++k) {
        const Estimate& e = estimates.at(k);
        held[k] += e.lower <= tried.numbers[k].truth && tried.numbers[k].truth <= e.upper ? 1 : 0;
        none[k] += std::isfinite(e.lower) ? 0 : 1;
      }
    }
    using Binomial = boost::math::binomial_distribution<double>;
    for (std::size_t k = 0; k < held.size(); ++k) {
      const auto n = static_cast<double>(repetitions), share = held[k] / n;
      fmt::print("| {} | {} | {} | {:.4f} | {:.1f} | {:.1f} to {:.1f} | {}{} |\n", tried.estimator,
                 tried.function, tried.numbers[k].name, tried.numbers[k].truth, 100.0 * share,
                 100.0 * Binomial::find_lower_bound_on_p(n, held[k], 0.025),
                 100.0 * Binomial::find_upper_bound_on_p(n, held[k], 0.025),
                 share < 0.93   ? "below"
                 : share > 0.97 ? "above"
                                : "yes",
                 none[k] > 0 ? fmt::format(", none in {}", none[k]) : "");
    }
    std::fflush(stdout);
  }
}

}  // namespace cpt::benchmarks

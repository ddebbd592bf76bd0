#include "diagnosis/calibration/convergence.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace cpt::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr Index fewest_steps = 8;

// First and second half of each chain, as chains; the middle step of an odd number is left out.
MatrixXd halves(const MatrixXd& draws) {
  const Index half = draws.rows() / 2;
  MatrixXd split(half, 2 * draws.cols());
  split << draws.topRows(half), draws.bottomRows(half);
  return split;
}

// Ranks of all draws together, equal ones sharing their mean rank, as normal scores (Blom 1958).
MatrixXd normal_scores(const MatrixXd& draws) {
  const Index n = draws.size();
  std::vector<Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, {}, [&](Index i) { return draws.data()[i]; });
  MatrixXd scores(draws.rows(), draws.cols());
  for (Index first = 0, last = 0; first < n; first = last) {
    const double value = draws.data()[order[static_cast<std::size_t>(first)]];
    while (last < n && draws.data()[order[static_cast<std::size_t>(last)]] == value) ++last;
    const double rank = 0.5 * static_cast<double>(first + 1 + last);
    const double p = (rank - 0.375) / (static_cast<double>(n) + 0.25);
    const double score = -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * p);
    for (Index i = first; i < last; ++i) scores.data()[order[static_cast<std::size_t>(i)]] = score;
  }
  return scores;
}

// Linear between order statistics.
double quantile_of(const MatrixXd& draws, double probability) {
  std::vector<double> sorted(draws.data(), draws.data() + draws.size());
  std::ranges::sort(sorted);
  const double place = probability * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

struct Variances {
  double within, total;
};
Variances variances(const MatrixXd& draws) {
  const auto n = static_cast<double>(draws.rows());
  const Eigen::RowVectorXd means = draws.colwise().mean();
  const double within =
      (draws.rowwise() - means).squaredNorm() / ((n - 1.0) * static_cast<double>(draws.cols()));
  double total = within * (n - 1.0) / n;
  if (draws.cols() > 1)
    total += (means.array() - means.mean()).square().sum() / static_cast<double>(draws.cols() - 1);
  return {within, total};
}

double size_of_indicator(const MatrixXd& split, double limit) {
  return effective_size((split.array() <= limit).cast<double>());
}

}  // namespace

double potential_scale_reduction(const MatrixXd& draws) {
  const Variances v = variances(draws);
  return v.within > 0.0 ? std::sqrt(v.total / v.within) : undefined;
}

double effective_size(const MatrixXd& draws) {
  const Index n = draws.rows();
  const Variances v = variances(draws);
  if (n < 4 || !(v.total > 0.0)) return undefined;
  const MatrixXd centred = draws.rowwise() - draws.colwise().mean();
  const auto correlation = [&](Index lag) {
    const double covariance = (centred.topRows(n - lag).array() * centred.bottomRows(n - lag).array()).sum() /
                              static_cast<double>(n * draws.cols());
    return 1.0 - (v.within - covariance) / v.total;
  };
  // Sums of neighbouring pairs are positive and fall in a reversible chain.
  double sum = -1.0, pair = 1.0 + correlation(1);
  double before = pair;
  Index lag = 0;
  while (pair > 0.0) {
    before = std::min(before, pair);
    sum += 2.0 * before;
    lag += 2;
    if (lag + 1 >= n - 3) break;
    const double even = correlation(lag);
    pair = even + correlation(lag + 1);
    if (!(pair > 0.0)) sum += std::max(even, 0.0);  // less biased where draws alternate
  }
  const auto count = static_cast<double>(draws.size());
  // No more than log10 of them times as many as there are: antithetic chains.
  return count / std::max(sum, 1.0 / std::log10(count));
}

Convergence convergence(const MatrixXd& draws) {
  if (draws.rows() < fewest_steps || draws.minCoeff() == draws.maxCoeff())
    return {undefined, undefined, undefined};
  const MatrixXd split = halves(draws);
  const MatrixXd scores = normal_scores(split);
  const MatrixXd folded = normal_scores((split.array() - quantile_of(split, 0.5)).abs());
  Convergence found;
  found.r_hat = std::max(potential_scale_reduction(scores), potential_scale_reduction(folded));
  found.bulk_size = effective_size(scores);
  found.tail_size = std::min(size_of_indicator(split, quantile_of(split, 0.05)),
                             size_of_indicator(split, quantile_of(split, 0.95)));
  return found;
}

}  // namespace cpt::diagnosis

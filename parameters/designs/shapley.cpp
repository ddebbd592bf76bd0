#include "parameters/designs/shapley.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "parameters/designs/polynomial_chaos.hpp"
#include "parameters/designs/propagation.hpp"
#include "parameters/designs/sectioning.hpp"
#include "parameters/designs/sparse_expansion.hpp"
#include "parameters/designs/value_of_score.hpp"
#include "parameters/designs/variation.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index folds = 10;
constexpr double most_score = 3.3;
constexpr Index least_points = 1000, most_points = 8000, most_evaluations = 1'000'000;

using Subset = unsigned;

/// The expansion of all runs, then those without each of the folds, as coefficients of terms that they have
/// together.
struct Expansions {
  std::vector<Term> terms;
  MatrixXd coefficients;  // terms x expansions
  double q2 = undefined;
  int degree = 0, own_terms = 0;  // of the first
};

void put(const Expansion& expansion, Index at, Expansions& all) {
  for (std::size_t k = 0; k < expansion.terms.size(); ++k) {
    auto found = std::ranges::find(all.terms, expansion.terms[k]);
    const Index row = found - all.terms.begin();
    if (found == all.terms.end()) {
      all.terms.push_back(expansion.terms[k]);
      all.coefficients.conservativeResize(row + 1, Eigen::NoChange);
      all.coefficients.row(row).setZero();
    }
    all.coefficients(row, at) = expansion.coefficients(static_cast<Index>(k));
  }
}

Expansions expansions_of(const ExpansionTerms& candidates, const MatrixXd& at_runs, const VectorXd& y) {
  Expansions all;
  all.coefficients.resize(0, folds + 1);
  const Expansion whole = candidates.expand(at_runs, y);
  if (whole.columns.empty()) return all;
  put(whole, 0, all);
  all.degree = whole.degree;
  all.own_terms = static_cast<int>(whole.terms.size());
  double squares = 0.0;
  for (Index fold = 0; fold < folds; ++fold) {
    std::vector<Index> in, out;
    for (Index run = 0; run < y.size(); ++run) (run % folds == fold ? out : in).push_back(run);
    const VectorXd known = y(in);
    const Expansion expansion = candidates.expand(at_runs(in, Eigen::all), known);
    VectorXd error = y(out).array() - known.mean();
    if (!expansion.columns.empty()) error = y(out) - at_runs(out, expansion.columns) * expansion.coefficients;
    squares += error.squaredNorm();
    put(expansion, fold + 1, all);
  }
  all.q2 = 1.0 - squares / (y.array() - y.mean()).square().sum();
  return all;
}

/// Normal scores of points, and how others are drawn that have some of them in common.
class Points {
 public:
  Points(const MatrixXd& correlation, Index count, std::uint64_t seed) : correlation_(correlation) {
    const Index inputs = correlation.rows();
    const MatrixXd all = propagation_places(static_cast<int>(2 * inputs), static_cast<int>(count), seed)
                             .unaryExpr([](double p) { return score_of_probability(p); });
    scores_ = all.leftCols(inputs) * MatrixXd(correlation.llt().matrixL()).transpose();
    anew_ = all.rightCols(inputs);
  }

  [[nodiscard]] const MatrixXd& scores() const { return scores_; }

  [[nodiscard]] MatrixXd with_in_common(Subset subset) const {
    std::vector<Index> kept, drawn;
    for (Index j = 0; j < scores_.cols(); ++j) ((subset >> j & 1U) != 0U ? kept : drawn).push_back(j);
    MatrixXd others = scores_;
    const MatrixXd across = correlation_(drawn, kept);
    const MatrixXd by_kept =
        MatrixXd(correlation_(kept, kept)).llt().solve(across.transpose()).transpose();  // drawn x kept
    const MatrixXd left = correlation_(drawn, drawn) - by_kept * across.transpose();
    others(Eigen::all, drawn) = scores_(Eigen::all, kept) * by_kept.transpose() +
                                anew_(Eigen::all, drawn) * MatrixXd(left.llt().matrixL()).transpose();
    return others;
  }

 private:
  MatrixXd correlation_, scores_, anew_;
};

// Of points that are not of the section; all for a section of -1.
double correlation_without(const VectorXd& a, const VectorXd& b, Index section) {
  std::vector<Index> in;
  for (Index i = 0; i < a.size(); ++i)
    if (section < 0 || i % folds != section) in.push_back(i);
  const VectorXd x = a(in).array() - a(in).mean(), y = b(in).array() - b(in).mean();
  return x.dot(y) / (x.norm() * y.norm());
}

// Subsets x expansions: the share of the variance that each subset accounts for.
MatrixXd shares_of_subsets(const Expansions& expansions, const ExpansionTerms& candidates,
                           const std::vector<ScoredInput>& inputs, const Points& points) {
  const auto d = static_cast<Index>(inputs.size());
  const auto results = [&](const MatrixXd& scores) -> MatrixXd {
    MatrixXd places(scores.rows(), d);
    for (Index j = 0; j < d; ++j)
      places.col(j) = scores.col(j).unaryExpr([&](double score) {
        return inputs[static_cast<std::size_t>(j)].place(std::clamp(score, -most_score, most_score));
      });
    return candidates.at(places, expansions.terms) * expansions.coefficients;
  };
  const MatrixXd base = results(points.scores());
  const Subset all = (1U << d) - 1U;
  MatrixXd shares(static_cast<Index>(all) + 1, folds + 1);
  shares.row(0).setZero();
  shares.row(static_cast<Index>(all)).setOnes();
  for (Subset subset = 1; subset < all; ++subset) {
    const MatrixXd others = results(points.with_in_common(subset));
    for (Index k = 0; k <= folds; ++k)
      shares(static_cast<Index>(subset), k) = correlation_without(base.col(k), others.col(k), k - 1);
  }
  return shares;
}

// The first is that of all runs.
Estimate estimated(const Eigen::RowVectorXd& values) {
  return parameters::jackknifed(values(0), values.tail(folds));
}

}  // namespace

VectorXd shapley_effects(int inputs, const VectorXd& value) {
  // Weight of a subset of so many others: size! (inputs - size - 1)! / inputs!
  VectorXd weight(inputs);
  for (int size = 0; size < inputs; ++size)
    weight(size) = std::exp(std::lgamma(size + 1.0) + std::lgamma(inputs - size) - std::lgamma(inputs + 1.0));
  VectorXd effects = VectorXd::Zero(inputs);
  const Subset all = (1U << inputs) - 1U;
  for (int j = 0; j < inputs; ++j)
    for (Subset subset = 0; subset <= all; ++subset)
      if ((subset >> j & 1U) == 0U)
        effects(j) += weight(std::popcount(subset)) *
                      (value(static_cast<Index>(subset | 1U << j)) - value(static_cast<Index>(subset)));
  return effects;
}

ShapleyIndices shapley_indices(const MatrixXd& all_places, const VectorXd& all_y,
                               const std::vector<ScoredInput>& inputs, const MatrixXd& correlation,
                               std::uint64_t seed) {
  std::vector<Index> completed;
  for (Index run = 0; run < all_y.size(); ++run)
    if (std::isfinite(all_y(run))) completed.push_back(run);
  const std::size_t count = inputs.size();
  const auto d = static_cast<Index>(count);
  ShapleyIndices found;
  found.shapley.resize(count);
  found.first.resize(count);
  found.total.resize(count);
  found.q2 = undefined;
  found.used = static_cast<int>(completed.size());
  found.dropped = static_cast<int>(all_y.size()) - found.used;
  const std::size_t least = std::max<std::size_t>(runs_per_term * (count + 1), 2 * folds);
  if (count < 2) {
    found.problem = "undefined: there is one input";
  } else if (count > most_shapley_inputs) {
    found.problem = fmt::format("undefined: of more than {} inputs", most_shapley_inputs);
  } else if (completed.size() < least) {
    found.problem =
        fmt::format("undefined: {} completed runs, {} inputs need {}", completed.size(), count, least);
  }
  if (!found.problem.empty()) return found;
  VectorXd y = all_y(completed);
  if (!varies(y)) {
    found.problem = does_not_vary;
    return found;
  }
  y.array() -= y.mean();
  std::vector<int> values;
  for (const ScoredInput& input : inputs) values.push_back(input.values);
  const ExpansionTerms candidates(values, completed.size());
  const MatrixXd at_runs = candidates.at(all_places(completed, Eigen::all));
  if (!candidates.told_apart(at_runs)) {
    found.problem = "undefined: the runs do not tell the inputs apart";
    return found;
  }
  const Expansions expansions = expansions_of(candidates, at_runs, y);
  if (expansions.terms.empty()) {
    found.problem = "undefined: no expansion fits the runs";
    return found;
  }
  found.q2 = expansions.q2;
  found.degree = expansions.degree;
  found.terms = expansions.own_terms;
  const Index points = std::clamp(most_evaluations >> d, least_points, most_points) / folds * folds;
  const MatrixXd shares =
      shares_of_subsets(expansions, candidates, inputs, Points(correlation, points, seed));
  MatrixXd shapley(d, folds + 1);
  for (Index k = 0; k <= folds; ++k) shapley.col(k) = shapley_effects(static_cast<int>(count), shares.col(k));
  const Index all = shares.rows() - 1;
  for (std::size_t j = 0; j < count; ++j) {
    const Index alone = Index{1} << j;
    found.shapley[j] = estimated(shapley.row(static_cast<Index>(j)));
    found.first[j] = estimated(shares.row(alone));
    found.total[j] = estimated((1.0 - shares.row(all - alone).array()).matrix());
  }
  if (found.q2 < least_q2)
    found.problem = fmt::format("not to be believed: Q2 = {:.2f} is below {}", found.q2, least_q2);
  return found;
}

}  // namespace cpt::parameters

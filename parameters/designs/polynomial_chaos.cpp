#include "parameters/designs/polynomial_chaos.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "parameters/designs/sectioning.hpp"
#include "parameters/designs/sparse_expansion.hpp"
#include "parameters/designs/variation.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index most_folds = 10;

// First-order indices, then total ones, from the coefficients of an expansion without its mean. `rounding`:
// what y must vary by.
VectorXd chaos_indices_of(const std::vector<Term>& terms, const VectorXd& coefficients, double rounding) {
  const auto parameters = static_cast<Index>(terms.front().size());
  VectorXd indices = VectorXd::Zero(2 * parameters);
  double variance = 0.0;
  for (std::size_t k = 1; k < terms.size(); ++k) {
    const double share = std::pow(coefficients(static_cast<Index>(k)), 2);
    variance += share;
    Index involved = 0, last = 0;
    for (Index j = 0; j < parameters; ++j)
      if (terms[k][static_cast<std::size_t>(j)] > 0) {
        ++involved;
        last = j;
        indices(parameters + j) += share;
      }
    if (involved == 1) indices(last) += share;
  }
  if (!(variance > rounding * rounding)) return VectorXd::Constant(2 * parameters, undefined);
  return indices / variance;
}

/// What expansions say that are made anew without one fold of the runs each: run i is in fold i mod 10.
struct LeftOut {
  double q2;         // 1 - squared errors at the runs left out over the variance of y
  MatrixXd indices;  // of each fold's expansion, a column each
};

LeftOut leave_out(const MatrixXd& at_all, const ExpansionTerms& candidates, const VectorXd& y,
                  double rounding) {
  const Index folds = std::min(most_folds, y.size());
  const auto parameters = static_cast<Index>(candidates.terms().front().size());
  LeftOut all{0.0, MatrixXd::Constant(2 * parameters, folds, undefined)};
  double squares = 0.0;
  for (Index fold = 0; fold < folds; ++fold) {
    std::vector<Index> in, out;
    for (Index run = 0; run < y.size(); ++run) (run % folds == fold ? out : in).push_back(run);
    const VectorXd known = y(in), unknown = y(out);
    const MatrixXd at_known = at_all(in, Eigen::all);
    const Expansion expansion = candidates.expand(at_known, known);
    VectorXd error = unknown.array() - known.mean();
    if (!expansion.columns.empty()) {
      const MatrixXd at_unknown = at_all(out, expansion.columns);
      error = unknown - at_unknown * expansion.coefficients;
      all.indices.col(fold) = chaos_indices_of(expansion.terms, expansion.coefficients, rounding);
    }
    squares += error.squaredNorm();
  }
  all.q2 = 1.0 - squares / (y.array() - y.mean()).square().sum();
  return all;
}

}  // namespace

ChaosIndices polynomial_chaos(const MatrixXd& all_places, const std::vector<int>& values,
                              const VectorXd& all_y) {
  const auto parameters = static_cast<std::size_t>(all_places.cols());
  std::vector<Index> completed;
  for (Index run = 0; run < all_y.size(); ++run)
    if (std::isfinite(all_y(run))) completed.push_back(run);
  const MatrixXd places = all_places(completed, Eigen::all);
  VectorXd y = all_y(completed);

  ChaosIndices fit;
  fit.first.resize(parameters);
  fit.total.resize(parameters);
  fit.q2 = undefined;
  fit.used = static_cast<int>(completed.size());
  fit.dropped = static_cast<int>(all_y.size()) - fit.used;
  if (completed.size() < runs_per_term * (parameters + 1)) {
    fit.problem = fmt::format("undefined: {} completed runs, {} parameters need {}", completed.size(),
                              parameters, runs_per_term * (parameters + 1));
    return fit;
  }
  if (!varies(y)) {
    fit.problem = does_not_vary;
    return fit;
  }
  const double rounding = rounding_share * y.cwiseAbs().maxCoeff();
  y.array() -= y.mean();  // leaves the indices and spares digits
  const ExpansionTerms candidates(values, completed.size());
  const MatrixXd at_all = candidates.at(places);
  if (!candidates.told_apart(at_all)) {
    fit.problem = "undefined: the runs do not tell the parameters apart";
    return fit;
  }
  const Expansion expansion = candidates.expand(at_all, y);
  if (expansion.columns.empty()) {
    fit.problem = "undefined: no expansion fits the runs";
    return fit;
  }
  fit.degree = expansion.degree;
  fit.terms = static_cast<int>(expansion.terms.size());
  const LeftOut left_out = leave_out(at_all, candidates, y, rounding);
  fit.q2 = left_out.q2;
  const VectorXd indices = chaos_indices_of(expansion.terms, expansion.coefficients, rounding);
  for (std::size_t j = 0; j < parameters; ++j) {
    const auto first = static_cast<Index>(j), total = static_cast<Index>(parameters + j);
    fit.first[j] = jackknifed(indices(first), left_out.indices.row(first));
    fit.total[j] = jackknifed(indices(total), left_out.indices.row(total));
  }
  if (fit.q2 < least_q2)
    fit.problem = fmt::format("not to be believed: Q2 = {:.2f} is below {}", fit.q2, least_q2);
  return fit;
}

}  // namespace cpt::parameters

#include "parameters/designs/polynomial_chaos.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "parameters/designs/orthonormal.hpp"
#include "parameters/designs/sectioning.hpp"
#include "parameters/designs/variation.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double norm = 0.75;       // of the hyperbolic truncation
constexpr int largest_degree = 20;  // [-]
constexpr std::size_t runs_per_term = 2, most_terms = 100;
constexpr std::size_t candidates_per_run = 2, most_candidates = 2000;
constexpr Index most_folds = 10;
constexpr double dependent = 1e-5;  // [-] of a column that lies in the others' span

/// Degrees of one term, one a parameter.
using Term = std::vector<int>;
/// Polynomials of each parameter.
using Families = std::vector<OrthonormalPolynomials>;

// Adds all terms whose first degrees are those of `term`; false where there would be more than `most`.
bool add_terms(Term& term, std::size_t next, double room, const Families& families, std::size_t most,
               std::vector<Term>& terms) {
  if (next == term.size()) {
    terms.push_back(term);
    return terms.size() <= most;
  }
  for (int degree = 0;; ++degree) {
    const double taken = std::pow(degree, norm);
    if (taken > room * (1.0 + 1e-12) || degree > families[next].most_degree()) break;
    term[next] = degree;
    if (!add_terms(term, next + 1, room - taken, families, most, terms)) return false;
  }
  term[next] = 0;
  return true;
}

// Of hyperbolic degree p at most, the constant first; nothing where there are more than `most`.
std::vector<Term> hyperbolic_terms(int p, const Families& families, std::size_t most) {
  std::vector<Term> terms;
  Term term(families.size(), 0);
  if (!add_terms(term, 0, std::pow(p, norm), families, most, terms)) return {};
  return terms;
}

/// Terms in the order of their hyperbolic degree; of degree p at most are the first `up_to[p]`.
struct Candidates {
  std::vector<Term> terms;
  std::vector<Index> up_to = {1};  // degree 0: the constant
};

Candidates candidates_of(const Families& families, std::size_t most) {
  Candidates candidates;
  candidates.terms = {Term(families.size(), 0)};
  for (int p = 1; p <= largest_degree; ++p) {
    const std::vector<Term> all = hyperbolic_terms(p, families, most);
    if (all.empty()) break;
    const std::vector<Term> known = candidates.terms;
    for (const Term& term : all)
      if (std::ranges::find(known, term) == known.end()) candidates.terms.push_back(term);
    candidates.up_to.push_back(static_cast<Index>(candidates.terms.size()));
  }
  return candidates;
}

// Runs x terms.
MatrixXd basis(const MatrixXd& places, const Families& families, const std::vector<Term>& terms) {
  std::vector<MatrixXd> powers;  // of each parameter: runs x degrees
  for (std::size_t j = 0; j < families.size(); ++j) {
    MatrixXd& of = powers.emplace_back(MatrixXd::Ones(places.rows(), families[j].most_degree() + 1));
    for (int degree = 1; degree < of.cols(); ++degree)
      for (Index run = 0; run < places.rows(); ++run)
        of(run, degree) = families[j](degree, places(run, static_cast<Index>(j)));
  }
  MatrixXd values = MatrixXd::Ones(places.rows(), static_cast<Index>(terms.size()));
  for (std::size_t k = 0; k < terms.size(); ++k)
    for (std::size_t j = 0; j < families.size(); ++j)
      if (terms[k][j] > 0) values.col(static_cast<Index>(k)).array() *= powers[j].col(terms[k][j]).array();
  return values;
}

/// Columns of a basis, the constant first, and their relative error.
struct Subset {
  std::vector<Index> columns;
  double error = std::numeric_limits<double>::infinity();
};

// Orthogonal matching pursuit: from the constant on, the column that is most correlated with what the ones
// chosen leave of y, `most` of them; of all these fits the one with the least leave-one-out error, from
// residuals and leverages, with the correction n / (n - terms) (1 + trace of the inverse information) of
// Blatman & Sudret (2011), over the variance of y.
Subset pursue(const MatrixXd& basis, const VectorXd& y, Index most) {
  const Index n = basis.rows(), steps = std::min(most, basis.cols());
  const double variance = (y.array() - y.mean()).square().mean(), size = y.norm();
  const VectorXd norms = basis.colwise().norm();
  VectorXd open = VectorXd::Ones(basis.cols());  // 0: chosen, or in the span of the chosen ones
  MatrixXd orthogonal(n, steps), inverse = MatrixXd::Zero(steps, steps);  // Q, R^-1 of the chosen columns
  VectorXd residual = y, leverage = VectorXd::Zero(n);
  double trace = 0.0;
  std::vector<Index> chosen;
  Subset best;
  for (Index next = 0; static_cast<Index>(chosen.size()) < steps;) {
    const auto m = static_cast<Index>(chosen.size());
    open(next) = 0.0;
    VectorXd column = basis.col(next), within = VectorXd::Zero(m);
    for (int twice = 0; twice < 2; ++twice) {  // keeps the columns orthogonal to the last digit
      const VectorXd part = orthogonal.leftCols(m).transpose() * column;
      column -= orthogonal.leftCols(m) * part;
      within += part;
    }
    const double rest = column.norm();
    if (rest > dependent * norms(next)) {
      orthogonal.col(m) = column / rest;
      inverse.col(m).head(m) = -(inverse.topLeftCorner(m, m) * within) / rest;
      inverse(m, m) = 1.0 / rest;
      trace += inverse.col(m).head(m + 1).squaredNorm();
      residual -= orthogonal.col(m) * orthogonal.col(m).dot(residual);
      leverage += orthogonal.col(m).cwiseAbs2();
      chosen.push_back(next);
      const auto terms = static_cast<double>(chosen.size()), runs = static_cast<double>(n);
      const double error = (residual.array() / (1.0 - leverage.array())).square().mean() / variance * runs /
                           (runs - terms) * (1.0 + trace);
      if (terms > 1.0 && error < best.error) best = {chosen, error};
    }
    const VectorXd correlation =
        (basis.transpose() * residual).cwiseAbs().cwiseQuotient(norms).cwiseProduct(open);
    if (!(correlation.maxCoeff(&next) > 1e-13 * size)) break;  // nothing is left but rounding
  }
  return best;
}

/// An expansion: terms among the candidates, and the degree of these.
struct Selection {
  Subset subset;
  int degree = 0;
};

Selection select(const MatrixXd& at_runs, const std::vector<Index>& up_to, const VectorXd& y) {
  Selection best;
  const Index most = std::min(static_cast<Index>(most_terms), y.size() / static_cast<Index>(runs_per_term));
  for (std::size_t p = 1; p < up_to.size(); ++p) {
    Subset found = pursue(at_runs.leftCols(up_to[p]), y, most);
    if (found.error < best.subset.error) best = {std::move(found), static_cast<int>(p)};
  }
  return best;
}

// Whether the runs tell all linear terms apart.
bool tell_apart(const MatrixXd& linear) {
  const Eigen::LDLT<MatrixXd> information(linear.transpose() * linear);
  return information.info() == Eigen::Success && information.rcond() >= 1e-10;
}

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

/// All that a sample of runs decides.
struct Expansion {
  int degree = 0;
  std::vector<Index> columns;  // none: no term tells anything
  std::vector<Term> terms;
  VectorXd coefficients;
};

Expansion expand(const MatrixXd& at_runs, const Candidates& candidates, const VectorXd& y) {
  const Selection selection = select(at_runs, candidates.up_to, y);
  Expansion found{selection.degree, selection.subset.columns, {}, {}};
  for (const Index column : found.columns)
    found.terms.push_back(candidates.terms[static_cast<std::size_t>(column)]);
  const MatrixXd chosen = at_runs(Eigen::all, found.columns);
  if (!found.columns.empty()) found.coefficients = chosen.householderQr().solve(y);
  return found;
}

/// What expansions say that are made anew without one fold of the runs each: run i is in fold i mod 10.
struct LeftOut {
  double q2;         // 1 - squared errors at the runs left out over the variance of y
  MatrixXd indices;  // of each fold's expansion, a column each
};

LeftOut leave_out(const MatrixXd& at_all, const Candidates& candidates, const VectorXd& y, double rounding) {
  const Index folds = std::min(most_folds, y.size());
  const auto parameters = static_cast<Index>(candidates.terms.front().size());
  LeftOut all{0.0, MatrixXd::Constant(2 * parameters, folds, undefined)};
  double squares = 0.0;
  for (Index fold = 0; fold < folds; ++fold) {
    std::vector<Index> in, out;
    for (Index run = 0; run < y.size(); ++run) (run % folds == fold ? out : in).push_back(run);
    const VectorXd known = y(in), unknown = y(out);
    const MatrixXd at_known = at_all(in, Eigen::all);
    const Expansion expansion = expand(at_known, candidates, known);
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

Estimate jackknifed(double value, const VectorXd& left_out) {
  const double half = jackknife_half_width({left_out.data(), static_cast<std::size_t>(left_out.size())});
  if (!std::isfinite(half)) return {value, undefined, undefined};
  return {value, value - half, value + half};
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
  Families families;
  for (const int of : values) families.emplace_back(of, largest_degree);

  const Candidates candidates =
      candidates_of(families, std::min(most_candidates, candidates_per_run * completed.size()));
  const MatrixXd at_all = basis(places, families, candidates.terms);
  if (candidates.up_to.size() < 2 || !tell_apart(at_all.leftCols(candidates.up_to[1]))) {
    fit.problem = "undefined: the runs do not tell the parameters apart";
    return fit;
  }
  const Expansion expansion = expand(at_all, candidates, y);
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
    fit.first[j] = jackknifed(indices(first), left_out.indices.row(first).transpose());
    fit.total[j] = jackknifed(indices(total), left_out.indices.row(total).transpose());
  }
  if (fit.q2 < least_q2)
    fit.problem = fmt::format("not to be believed: Q2 = {:.2f} is below {}", fit.q2, least_q2);
  return fit;
}

}  // namespace cpt::parameters

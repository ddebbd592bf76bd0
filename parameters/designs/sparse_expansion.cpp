#include "parameters/designs/sparse_expansion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double norm = 0.75;       // of the hyperbolic truncation
constexpr int largest_degree = 20;  // [-]
constexpr std::size_t most_terms = 100;
constexpr std::size_t candidates_per_run = 2, most_candidates = 2000;
constexpr double dependent = 1e-5;  // [-] of a column that lies in the others' span

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

}  // namespace

ExpansionTerms::ExpansionTerms(const std::vector<int>& values, std::size_t runs) {
  for (const int of : values) families_.emplace_back(of, largest_degree);
  const std::size_t most = std::min(most_candidates, candidates_per_run * runs);
  terms_ = {Term(families_.size(), 0)};
  for (int p = 1; p <= largest_degree; ++p) {
    const std::vector<Term> all = hyperbolic_terms(p, families_, most);
    if (all.empty()) break;
    const std::vector<Term> known = terms_;
    for (const Term& term : all)
      if (std::ranges::find(known, term) == known.end()) terms_.push_back(term);
    up_to_.push_back(static_cast<Index>(terms_.size()));
  }
}

bool ExpansionTerms::told_apart(const MatrixXd& at_runs) const {
  if (up_to_.size() < 2) return false;
  const MatrixXd linear = at_runs.leftCols(up_to_[1]);
  const Eigen::LDLT<MatrixXd> information(linear.transpose() * linear);
  return information.info() == Eigen::Success && information.rcond() >= 1e-10;
}

MatrixXd ExpansionTerms::at(const MatrixXd& places, const std::vector<Term>& terms) const {
  MatrixXd values = MatrixXd::Ones(places.rows(), static_cast<Index>(terms.size()));
  for (std::size_t j = 0; j < families_.size(); ++j) {
    int most = 0;
    for (const Term& term : terms) most = std::max(most, term[j]);
    for (int degree = 1; degree <= most; ++degree) {
      VectorXd power(places.rows());
      for (Index i = 0; i < places.rows(); ++i)
        power(i) = families_[j](degree, places(i, static_cast<Index>(j)));
      for (std::size_t k = 0; k < terms.size(); ++k)
        if (terms[k][j] == degree) values.col(static_cast<Index>(k)).array() *= power.array();
    }
  }
  return values;
}

Expansion ExpansionTerms::expand(const MatrixXd& at_runs, const VectorXd& y) const {
  const Index most = std::min(static_cast<Index>(most_terms), y.size() / static_cast<Index>(runs_per_term));
  Subset best;
  Expansion found;
  for (std::size_t p = 1; p < up_to_.size(); ++p) {
    Subset subset = pursue(at_runs.leftCols(up_to_[p]), y, most);
    if (!(subset.error < best.error)) continue;
    best = std::move(subset);
    found.degree = static_cast<int>(p);
  }
  found.columns = best.columns;
  for (const Index column : found.columns) found.terms.push_back(terms_[static_cast<std::size_t>(column)]);
  const MatrixXd chosen = at_runs(Eigen::all, found.columns);
  if (!found.columns.empty()) found.coefficients = chosen.householderQr().solve(y);
  return found;
}

}  // namespace cpt::parameters

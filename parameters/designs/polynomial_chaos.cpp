#include "parameters/designs/polynomial_chaos.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "parameters/designs/orthonormal.hpp"
#include "parameters/designs/variation.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double norm = 0.75;                               // of the hyperbolic truncation
constexpr int largest_degree = 20;                          // [-]
constexpr std::size_t runs_per_term = 2, most_terms = 200;  // the bootstrap's cost grows with their square
constexpr int chaos_draws = 400;

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

// Runs x terms.
MatrixXd basis(const MatrixXd& places, const Families& families, const std::vector<Term>& terms) {
  MatrixXd values = MatrixXd::Ones(places.rows(), static_cast<Index>(terms.size()));
  for (Index run = 0; run < places.rows(); ++run)
    for (std::size_t k = 0; k < terms.size(); ++k)
      for (std::size_t j = 0; j < terms[k].size(); ++j) {
        const int degree = terms[k][j];
        if (degree > 0)
          values(run, static_cast<Index>(k)) *= families[j](degree, places(run, static_cast<Index>(j)));
      }
  return values;
}

// Leave-one-out error from the residuals and leverages of one fit, with the correction n / (n - terms)
// (1 + trace of the inverse information) of Blatman & Sudret (2011), over the variance of y; nothing for a
// basis whose terms the runs do not tell apart.
std::optional<double> relative_error(const MatrixXd& basis, const VectorXd& y) {
  const auto n = static_cast<double>(basis.rows()), terms = static_cast<double>(basis.cols());
  const Eigen::LDLT<MatrixXd> information(basis.transpose() * basis);
  if (information.info() != Eigen::Success || information.rcond() < 1e-10) return std::nullopt;
  const MatrixXd inverse = information.solve(MatrixXd::Identity(basis.cols(), basis.cols()));
  const VectorXd residual = y - basis * (inverse * (basis.transpose() * y));
  const VectorXd leverage = (basis * inverse).cwiseProduct(basis).rowwise().sum();
  const double error = (residual.array() / (1.0 - leverage.array())).square().mean();
  const double variance = (y.array() - y.mean()).square().mean();
  return error / variance * n / (n - terms) * (1.0 + inverse.trace());
}

// First-order indices, then total ones, of the expansion fitted to a sample of the runs. `rounding`: what y
// must vary by.
VectorXd chaos_indices_of(const MatrixXd& basis, const std::vector<Term>& terms, const VectorXd& y,
                          double rounding, const Resample& sample) {
  VectorXd weight = VectorXd::Zero(y.size());
  for (const Index run : sample) weight(run) += 1.0;
  const MatrixXd weighted = basis.transpose() * weight.asDiagonal();
  const Eigen::LDLT<MatrixXd> information(weighted * basis);
  const auto parameters = static_cast<Index>(terms.front().size());
  VectorXd indices = VectorXd::Zero(2 * parameters);
  if (information.info() != Eigen::Success || information.rcond() < 1e-12)
    return VectorXd::Constant(2 * parameters, undefined);
  const VectorXd coefficients = information.solve(weighted * y);
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

}  // namespace

ChaosIndices polynomial_chaos(const MatrixXd& all_places, const std::vector<int>& values,
                              const VectorXd& all_y, std::uint64_t seed) {
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

  double least_error = std::numeric_limits<double>::infinity();
  std::vector<Term> terms;
  const std::size_t affordable = std::min(most_terms, completed.size() / runs_per_term);
  for (int p = 1; p <= largest_degree; ++p) {
    const auto candidate = hyperbolic_terms(p, families, affordable);
    if (candidate.empty()) break;
    const auto error = relative_error(basis(places, families, candidate), y);
    if (!error || *error >= least_error) continue;
    least_error = *error;
    fit.degree = p;
    terms = candidate;
  }
  if (terms.empty()) {
    fit.problem = "undefined: the runs do not tell the parameters apart";
    return fit;
  }
  fit.terms = static_cast<int>(terms.size());
  fit.q2 = 1.0 - least_error;
  const MatrixXd at_runs = basis(places, families, terms);
  const auto estimates = bootstrap(y.size(), chaos_draws, seed, [&](const Resample& sample) {
    return chaos_indices_of(at_runs, terms, y, rounding, sample);
  });
  const auto middle = estimates.begin() + static_cast<std::ptrdiff_t>(parameters);
  fit.first.assign(estimates.begin(), middle);
  fit.total.assign(middle, estimates.end());
  if (fit.q2 < least_q2)
    fit.problem = fmt::format("not to be believed: Q2 = {:.2f} is below {}", fit.q2, least_q2);
  return fit;
}

}  // namespace cpt::parameters

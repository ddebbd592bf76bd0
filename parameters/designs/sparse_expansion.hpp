// A sparse polynomial of the places of runs, fitted by least squares.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "parameters/designs/orthonormal.hpp"

namespace cpt::parameters {

/// Degrees of one term, one a parameter.
using Term = std::vector<int>;

/// All that a sample of runs decides.
struct Expansion {
  int degree = 0;  ///< of the hyperbolic truncation of its candidates
  std::vector<Eigen::Index>
      columns;  ///< its terms among the candidates, the constant first; none: no term tells anything
  std::vector<Term> terms;
  Eigen::VectorXd coefficients;
};

/// Which terms an expansion may have: products of polynomials that are orthonormal over [0, 1] (Legendre's)
/// or over the values that a parameter takes (orthonormal.hpp), with hyperbolic truncation (sum of
/// degree^0.75)^(1/0.75) <= p; p from 1 to 20 as long as there are no more than two candidates a run.
class ExpansionTerms {
 public:
  /// `values`: of each parameter how many it takes, 0 for all of [0, 1].
  ExpansionTerms(const std::vector<int>& values, std::size_t runs);

  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }  ///< in the order of their degree
  /// Whether the runs tell all linear terms apart; there are any.
  [[nodiscard]] bool told_apart(const Eigen::MatrixXd& at_runs) const;
  /// Values of all candidates, places x terms.
  [[nodiscard]] Eigen::MatrixXd at(const Eigen::MatrixXd& places) const { return at(places, terms_); }
  [[nodiscard]] Eigen::MatrixXd at(const Eigen::MatrixXd& places, const std::vector<Term>& terms) const;

  /// The best expansion of y, whose candidates take the values `at_runs`: of each p the terms that orthogonal
  /// matching pursuit takes one after the other (Pati, Rezaiifar & Krishnaprasad 1993, 27th Asilomar
  /// Conference, 40-44; Luethen, Marelli & Sudret 2021, SIAM/ASA J. Uncertainty Quantification 9, 593-649),
  /// as long as there are two runs a term and 100 terms at most; of all these the best by the analytic
  /// leave-one-out error with its correction for small samples (Blatman & Sudret 2011, Journal of
  /// Computational Physics 230, 2345-2367; the correction is that of Chapelle, Vapnik & Bengio 2002).
  [[nodiscard]] Expansion expand(const Eigen::MatrixXd& at_runs, const Eigen::VectorXd& y) const;

 private:
  std::vector<OrthonormalPolynomials> families_;
  std::vector<Term> terms_;
  std::vector<Eigen::Index> up_to_ = {
      1};  // of degree p at most are the first up_to_[p]; degree 0: the constant
};

inline constexpr std::size_t runs_per_term = 2;

}  // namespace cpt::parameters

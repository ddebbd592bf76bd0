// What the study's parameters within their bounds do to the curve, as a polynomial of the second degree.
//
//   y(t) = y_0 + sum_j a_j s_j + sum_{i<=j} b_ij s_i s_j,   s = t - t_0,
//
// t_j in [0, 1] the place of parameter j between its bounds, t_0 the baseline's. One-at-a-time runs give the
// parabola of each parameter (a straight line where there are two), and the polynomial passes through them.
// Joint runs, with several parameters changed, give what these runs cannot tell: the products s_i s_j, and
// the curvature of a parameter whose baseline is at a bound. Both vanish at the one-at-a-time runs; their
// coefficients are those of a ridge regression whose penalty predicts the joint runs best when each is left
// out in turn (Allen 1974); where no product helps, there is none.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/depth_grid.hpp"

namespace cpt::diagnosis {

/// One parameter's runs, with all others at the baseline.
struct ParameterEffect {
  std::string name;
  double baseline = 0.5;    // [-] t_0, in [0, 1]
  VectorXd lower, upper;    // [ln q_c] y at the bounds; empty where there is no such run
  bool two_valued = false;  ///< a choice: one of the ends is the baseline
  /// t of a standard normal, ascending: how the parameter is distributed, where that is not evenly between
  /// its bounds. It may lie beyond these.
  std::function<double(double)> place_of_score = nullptr;
};

/// Runs with several parameters changed.
struct JointRuns {
  MatrixXd places;  // runs x p [-] t, in [0, 1]
  MatrixXd curves;  // n x runs [ln q_c]
};

/// What one parameter may be, by quadrature: its places t, their weights, which sum to 1, and a coordinate of
/// mean 0 and variance 1 that the curves are to be linear in.
struct PlaceRule {
  VectorXd places, weights, coordinates;
};

/// y ~ mean + slopes x + remainder z, x the parameters' coordinates, z independent standard normals.
struct Linearized {
  VectorXd mean;       // n [ln]
  MatrixXd slopes;     // n x p
  MatrixXd remainder;  // n x k: what is not linear, of the right covariance
};

/// n cells, p parameters.
class ResponseSurface {
 public:
  /// From one-at-a-time runs alone; `baseline` is y_0 (n). Throws std::invalid_argument for a parameter with
  /// neither run, with t_0 outside [0, 1], with runs of another length, or two-valued with its baseline
  /// inside.
  ResponseSurface(VectorXd baseline, const std::vector<ParameterEffect>& effects);
  /// With joint runs too. Cells that lack a value in any of them have no say in the penalty. Throws also for
  /// joint runs of another shape.
  ResponseSurface(VectorXd baseline, const std::vector<ParameterEffect>& effects, const JointRuns& joint);

  [[nodiscard]] Index parameters() const { return place_.size(); }
  [[nodiscard]] const VectorXd& baseline() const { return baseline_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const VectorXd& baseline_place() const { return place_; }
  [[nodiscard]] bool two_valued(Index j) const { return two_valued_[static_cast<std::size_t>(j)]; }
  /// What each joint run lies off the surface that the others make (n x runs).
  [[nodiscard]] const MatrixXd& left_out() const { return left_out_; }

  /// y(t), for t (p) in [0, 1].
  [[nodiscard]] VectorXd predict(const VectorXd& t) const;
  /// dy/dt (n x p).
  [[nodiscard]] MatrixXd jacobian(const VectorXd& t) const;
  /// E y over the prior: t_j uniform on [0, 1], a choice at either end with probability 1/2.
  [[nodiscard]] VectorXd prior_mean() const;
  /// F with Cov y = F F^T over the prior, exact; a column for each s_j and each s_i s_j.
  [[nodiscard]] MatrixXd prior_factors() const;
  /// The best linear curves over independent parameters, by least squares (statistical linearization: Gelb
  /// 1974, Applied optimal estimation, section 6.2), exact to the quadrature. `rules`: one for each
  /// parameter.
  [[nodiscard]] Linearized linearized(const std::vector<PlaceRule>& rules) const;
  /// The surface with every range `width` times as wide about its baseline; choices stay.
  [[nodiscard]] ResponseSurface widened(double width) const;

 private:
  [[nodiscard]] Index column_of(Index i, Index j) const;  ///< of s_i s_j, i <= j
  [[nodiscard]] VectorXd monomials(const VectorXd& s) const;
  using Moments = std::vector<std::array<double, 5>>;  ///< E s_j^k of each parameter
  /// Exponents of the monomials in each parameter, that of the constant 1 last.
  [[nodiscard]] Eigen::MatrixXi exponents() const;
  /// E f_a f_b, f the monomials and, last, the constant 1.
  [[nodiscard]] MatrixXd second_moments(const Moments& moments) const;
  [[nodiscard]] MatrixXd prior_moments() const;
  /// F with F F^T the covariance of curves whose monomials have this one.
  [[nodiscard]] MatrixXd factors_of(const MatrixXd& covariance) const;
  void learn(const JointRuns& joint, const std::vector<ParameterEffect>& effects);

  VectorXd baseline_;
  std::vector<std::string> names_;
  VectorXd place_;                              // t_0
  std::vector<std::pair<Index, Index>> pairs_;  ///< i <= j of the products, in the order of their columns
  MatrixXd coefficients_;                       // n x (p + pairs): a, b
  std::vector<bool> two_valued_;
  MatrixXd left_out_;
};

}  // namespace cpt::diagnosis

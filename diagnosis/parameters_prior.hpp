// What the study's parameters within their bounds can do to the curve: the nuisance of the diagnosis.
//
// From one-at-a-time runs, y(t) = y_0 + sum_j f_j(t_j), t_j in [0, 1] the place of parameter j between its
// bounds, f_j = a_j s + b_j s^2 with s = t_j - t_0j, the parabola through the runs at lower bound, baseline
// and upper bound (a straight line where there are two). t_j is uniform on [0, 1]; a two-valued choice is
// either end with probability 1/2.
#pragma once

#include <string>

#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {

/// One parameter's runs, with all others at the baseline.
struct ParameterEffect {
  std::string name;
  double baseline = 0.5;    // [-] t_0, in [0, 1]
  VectorXd lower, upper;    // [ln q_c] y at the bounds; empty where there is no such run
  bool two_valued = false;  ///< a choice: one of the ends is the baseline
};

/// The additive model; n cells, p parameters.
class AdditiveModel {
 public:
  /// `baseline` is y_0 (n). Throws std::invalid_argument for a parameter with neither run, with t_0 outside
  /// [0, 1], with runs of another length, or two-valued with its baseline inside.
  AdditiveModel(VectorXd baseline, const std::vector<ParameterEffect>& effects);

  [[nodiscard]] Index parameters() const { return linear_.cols(); }
  [[nodiscard]] const VectorXd& baseline() const { return baseline_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const VectorXd& baseline_place() const { return place_; }
  [[nodiscard]] bool two_valued(Index j) const { return two_valued_[static_cast<std::size_t>(j)]; }

  /// y(t), for t (p) in [0, 1].
  [[nodiscard]] VectorXd predict(const VectorXd& t) const;
  /// dy/dt (n x p).
  [[nodiscard]] MatrixXd jacobian(const VectorXd& t) const;
  /// E y over the prior.
  [[nodiscard]] VectorXd prior_mean() const;
  /// F (n x up to 2 p) with Cov y = F F^T over the prior, exact.
  [[nodiscard]] MatrixXd prior_factors() const;
  /// The model on some of its cells.
  [[nodiscard]] AdditiveModel rows(const std::vector<Index>& kept) const;
  /// The model with every range `width` times as wide about its baseline; choices stay.
  [[nodiscard]] AdditiveModel widened(double width) const;

 private:
  VectorXd baseline_;
  std::vector<std::string> names_;
  VectorXd place_;               // t_0
  MatrixXd linear_, quadratic_;  // a, b
  std::vector<bool> two_valued_;
};

/// The null hypothesis "nothing is missing": y ~ (additive model over its prior) + N(0, sigma).
struct NullModel {
  AdditiveModel parameters;
  MatrixXd sigma;       // n x n [ln^2] noise and error of the additive model
  VectorXd mean;        // n [ln q_c] E y
  MatrixXd covariance;  // n x n [ln^2] M = sigma + F F^T
};

[[nodiscard]] NullModel null_model(AdditiveModel parameters, MatrixXd sigma);

/// Draws of y - mean (n x count) with the parameters from their true, bounded prior through the parabolas:
/// the null model itself, not its normal approximation N(0, M).
[[nodiscard]] MatrixXd draw_null(const NullModel& null, int count, std::uint64_t seed);

/// The parameters that fit a curve best within their bounds.
struct Recalibration {
  VectorXd place;      // p, t in [0, 1]
  VectorXd deviation;  // p, posterior standard deviation of t in the normal approximation
  VectorXd curve;      // n [ln q_c]
  double rmse;         // [ln q_c] of y - curve
};

/// Minimizes |L^-1 (y - y(t))|^2 in [0, 1]^p by Gauss-Newton steps, each an exact box-constrained quadratic
/// problem; `sigma` whitens noise. Choices are relaxed first, then set to the nearer end and the others
/// refitted. The deviation takes the prior as normal with the uniform's variance 1/12.
[[nodiscard]] Recalibration recalibrate(const AdditiveModel& model, const VectorXd& y, const Whitener& sigma);

}  // namespace cpt::diagnosis

// What the study's parameters within their bounds can do to the curve: the nuisance of the diagnosis.
#pragma once

#include <cstdint>

#include "diagnosis/response_surface.hpp"
#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {

/// The null hypothesis "nothing is missing": y ~ (response surface over the prior) + N(0, sigma).
struct NullModel {
  ResponseSurface parameters;
  MatrixXd sigma;       // n x n [ln^2] noise and error of the surface
  VectorXd mean;        // n [ln q_c] E y
  MatrixXd covariance;  // n x n [ln^2] M = sigma + F F^T
};

[[nodiscard]] NullModel null_model(ResponseSurface parameters, MatrixXd sigma);

/// Draws of y - mean (n x count) with the parameters from their true, bounded prior through the surface:
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
[[nodiscard]] Recalibration recalibrate(const ResponseSurface& model, const VectorXd& y,
                                        const Whitener& sigma);

}  // namespace cpt::diagnosis

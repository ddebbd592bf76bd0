// The study's parameters as the standard normals behind them, and what they do to the curve near the soil
// that the recording speaks of, which need not be the middle of the prior.
#pragma once

#include <cstdint>

#include "diagnosis/response_surface.hpp"

namespace cpt::diagnosis {

/// z = L u, u independent standard normals; t_j, the place of parameter j, a function of z_j (a Gaussian
/// copula). p parameters.
struct SoilPrior {
  std::vector<std::function<double(double)>> place_of_score;
  MatrixXd lower;  // p x p: L, L L^T the scores' correlation
};

/// Parameters without a distribution are even between their bounds, choices at either end. `correlation` (p x
/// p) is the scores'; empty: independent. Throws std::invalid_argument where it is no correlation.
[[nodiscard]] SoilPrior soil_prior(const std::vector<ParameterEffect>& parameters,
                                   const MatrixXd& correlation);

/// What is thought of the scores: the middle and the standard deviation of each.
struct SoilBelief {
  VectorXd mean, deviation;  // p
};
[[nodiscard]] SoilBelief before_recording(const SoilPrior& prior);

/// The prior's curves as they are where the belief holds: y ~ mean + slopes u + remainder v, u and v
/// independent standard normals. A belief of one soil makes the surface's tangent there, with the prior's
/// normals about it; the belief before the recording the surface's mean and covariance over the prior.
struct LocalSoil {
  VectorXd mean;       // n [ln]
  MatrixXd slopes;     // n x p: of u
  MatrixXd remainder;  // n x k: what is not linear over the belief
  VectorXd places;     // p: E t over the belief
};
[[nodiscard]] LocalSoil local_soil(const ResponseSurface& surface, const SoilPrior& prior,
                                   const SoilBelief& belief);

/// Curves of the surface (n x count) with parameters drawn from the prior, and noise of this covariance.
[[nodiscard]] MatrixXd draw_soil(const ResponseSurface& surface, const SoilPrior& prior,
                                 const MatrixXd& scatter, Index count, std::uint64_t seed);

}  // namespace cpt::diagnosis

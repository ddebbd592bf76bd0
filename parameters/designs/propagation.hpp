// What q_c is worth where its inputs are distributed: a sample of them, and mean, standard deviation and
// quantiles of the result with intervals.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "parameters/designs/bootstrap.hpp"
#include "parameters/designs/kind.hpp"

namespace cpt::parameters {

/// Run i belongs to section i mod 10.
inline constexpr int propagation_sections = 10;

/// Runs x parameters. Each section is Sobol' points, from the zero point on, moved by a random digital shift
/// of its own: the sections are independent, and each fills the cube evenly (L'Ecuyer & Lemieux 2002, Recent
/// advances in randomized quasi-Monte Carlo methods, section 5). More runs of the same seed begin with the
/// same. No place is 0 or 1.
[[nodiscard]] Eigen::MatrixXd propagation_places(int parameters, int runs, std::uint64_t seed);

/// A number of the sample `y` and its 95 % interval by sectioning: the number of all entries +- t s /
/// sqrt(k), s the deviation of the k sections' own numbers from it and t Student's 97.5 % point with k - 1
/// degrees of freedom (Nakayama 2014, Winter Simulation Conference, section 4: it holds for quantiles of such
/// samples, where formulas for independent runs do not). NaN among `y`, runs without a result, do not count,
/// nor do sections with fewer than `least` entries; no interval from fewer than five sections, no value
/// without entries.
[[nodiscard]] Estimate by_sections(const Eigen::VectorXd& y, int least,
                                   const std::function<double(const Eigen::VectorXd&)>& number);

// Numbers of a sample without NaN.
/// n - 1 in the denominator; NaN of fewer than two.
[[nodiscard]] double sample_deviation(const Eigen::VectorXd& sample);
/// Median-unbiased whatever the distribution (Hyndman & Fan 1996, The American Statistician 50, 361, type 8).
[[nodiscard]] double sample_quantile(const Eigen::VectorXd& sample, double probability);

[[nodiscard]] DesignKind propagation_design();

}  // namespace cpt::parameters

// What q_c is worth where its inputs are distributed: a sample of them, and mean, standard deviation and
// quantiles of the result with intervals.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "parameters/designs/bootstrap.hpp"
#include "parameters/designs/kind.hpp"

namespace cpt::parameters {

inline constexpr int propagation_sections = 10;
inline constexpr int latin_runs = 10;  ///< of one Latin hypercube

/// Which section a run belongs to: run mod 10; of Latin hypercubes that of its hypercube, run / 10 mod 10.
[[nodiscard]] int section_of(Eigen::Index run, bool latin);

/// Runs x parameters. Each section is Sobol' points, from the zero point on, moved by a random digital shift
/// of its own: the sections are independent, and each fills the cube evenly (L'Ecuyer & Lemieux 2002, Recent
/// advances in randomized quasi-Monte Carlo methods, section 5). More runs of the same seed begin with the
/// same. No place is 0 or 1.
[[nodiscard]] Eigen::MatrixXd propagation_places(int parameters, int runs, std::uint64_t seed);

/// The same of Latin hypercubes of ten runs, one behind the other and independent of each other: replicated
/// Latin hypercube sampling (Iman & Conover 1980, Communications in Statistics A 9, 1749).
[[nodiscard]] Eigen::MatrixXd latin_places(int parameters, int runs, std::uint64_t seed);

/// A number of the sample `y` and its 95 % interval by sectioning: the number of all entries +- t s /
/// sqrt(k), s the deviation of the k sections' own numbers from it and t Student's 97.5 % point with k - 1
/// degrees of freedom (Nakayama 2014, Winter Simulation Conference, section 4: it holds for quantiles of such
/// samples, where formulas for independent runs do not). NaN among `y`, runs without a result, do not count,
/// nor do sections with fewer than `least` entries; no interval from fewer than five sections, no value
/// without entries. `latin`: how runs belong to sections.
[[nodiscard]] Estimate by_sections(const Eigen::VectorXd& y, int least,
                                   const std::function<double(const Eigen::VectorXd&)>& number,
                                   bool latin = false);

/// The probability that y exceeds a threshold, with its 95 % interval: by sections, cut off at 0 and 1; where
/// fewer than five runs lie on either side, or all sections have the same share, that of Clopper & Pearson
/// (1934, Biometrika 26, 404) for independent runs, which is wider. With a relative error of that standard
/// deviation each run counts by its own probability.
[[nodiscard]] Estimate exceedance(const Eigen::VectorXd& y, bool latin, double threshold, double error = 0.0);

/// Whether the rule holds for the first `runs` entries of y.
[[nodiscard]] bool suffices(const StopRule& rule, const Eigen::VectorXd& y, Eigen::Index runs, bool latin,
                            double error = 0.0);
/// Numbers of runs after which the rule is looked at: 50, 60, 70 ... A rule that is looked at too early stops
/// where the interval happens to be short (Glynn & Whitt 1992, Annals of Applied Probability 2, 180).
inline constexpr int first_look = 50, look_interval = 10;

// Numbers of a sample without NaN; of one whose every value y is normal with mean y and standard deviation
// `error` |y| about it, where an error is given.
/// n - 1 in the denominator; NaN of fewer than two. sqrt(s^2 + error^2 mean(y^2)).
[[nodiscard]] double sample_deviation(const Eigen::VectorXd& sample, double error = 0.0);
/// Median-unbiased whatever the distribution (Hyndman & Fan 1996, The American Statistician 50, 361, type 8).
/// With an error that of the sample with every value in place of 21, at the middles of as many equally likely
/// parts of its normal distribution.
[[nodiscard]] double sample_quantile(const Eigen::VectorXd& sample, double probability, double error = 0.0);

[[nodiscard]] DesignKind propagation_design();

}  // namespace cpt::parameters

// An emulator of a study's runs as a level of its own: the same propagation with as many runs as one likes.
#pragma once

#include <Eigen/Core>

#include "parameters/study.hpp"

namespace cpt::results {

struct EmulatedLevel {
  Eigen::VectorXd y;  ///< of the design's first runs, as many as asked for
  double q2 = 0.0;    ///< 1 - squared errors at runs held out over the variance of the results
};

/// Below this it is not to be used.
inline constexpr double least_emulated_q2 = 0.9;

/// Of `y`, results of the design's runs, NaN where there is none, a sparse polynomial
/// (designs/sparse_expansion.hpp) for each section of the design (designs/propagation.hpp), made without the
/// section's own runs and asked at the section's places: so that what it says of a run does not know the run,
/// and differences between levels are those of new runs. Q2 is undefined and y empty where runs do not tell
/// the inputs apart.
[[nodiscard]] EmulatedLevel emulated_level(const parameters::Study& study, const Eigen::VectorXd& y,
                                           Eigen::Index runs);

}  // namespace cpt::results

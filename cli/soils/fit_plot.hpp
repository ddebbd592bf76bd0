// The figure of a joint fit: measured and fitted curves.
#pragma once

#include <string>

#include "parameters/calibration/simulated_tests.hpp"

namespace cpt::cli {

/// An SVG document: q and eps_v over eps_a of the triaxial tests, e over sigma_v of the oedometer tests;
/// marks are readings, lines the single element of this sand.
[[nodiscard]] std::string fit_plot(const calibration::LaboratoryTests& tests,
                                   const solver::NorSandParameters& sand);

}  // namespace cpt::cli

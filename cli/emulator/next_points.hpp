// Points that a study should run next, where its emulator knows least.
#pragma once

#include <string>

#include "parameters/study.hpp"
#include "results/emulator/emulator.hpp"

namespace cpt::cli {

/// `count` points as [[points]] to append to the study: the worst of 2048 of Sobol's points in its box, drawn
/// from its distributions and correlations where it has them, that can be run (results::worst_places).
/// Numbers have four digits. The same study and emulator give the same points.
[[nodiscard]] std::string next_points(const parameters::Study& study, const results::Emulator& emulator,
                                      int count);

}  // namespace cpt::cli

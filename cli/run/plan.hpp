// What a study would run, and whether it could.
#pragma once

#include "parameters/study.hpp"

namespace cpt::cli {

/// Prints the realizations with their values and, if the study has been run before, their status; then what a
/// start would keep, leave unused and run. Writes nothing.
void print_plan(const parameters::Study& study);

/// Builds the model of every realization and lets it make its first steps; prints what is wrong. Returns the
/// program's exit code.
[[nodiscard]] int validate(const parameters::Study& study);

}  // namespace cpt::cli

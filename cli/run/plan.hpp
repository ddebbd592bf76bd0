// What a study would run, and whether it could.
#pragma once

#include "parameters/study.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::cli {

/// Prints the realizations with their values and, if the study has been run before, their status; then what a
/// start would keep, leave unused and run. Writes nothing.
void print_plan(const parameters::Study& study);
/// Prints every realization with its name and all inputs that the study varies anywhere, a row each,
/// for another program to run them; `import` reads the table with the results as further columns.
void print_points(const parameters::Study& study, results::Format format);

/// Builds the model of every realization and lets it make its first steps; prints what is wrong. Returns the
/// program's exit code.
[[nodiscard]] int validate(const parameters::Study& study);

}  // namespace cpt::cli

// The section [solver] of a study: another program in place of the embedded solver, its inputs and outputs.
//
//   [solver]
//   command = ["python3", "ishigami.py"]  # words that name a file beside the study become its path
//   version = ["python3", "--version"]    # optional: a text, or a command that prints it
//   template = "deck.in"                  # optional: {{x1}} in it is replaced by the input's value
//   results = "deck.csv"                  # optional: file in the work folder; default: standard output
//
//   [solver.inputs]
//   x1 = { default = 0.0, unit = "m", min = -3.2, max = 3.2 }   # or x1 = 0.0
//
//   [solver.outputs]
//   f = { unit = "kPa" }                                        # a scalar
//   settlement = { unit = "mm", over = "time", over_unit = "d" }
//
//   [[windows]]                           # where a curve is averaged; a scalar needs none
//   name = "late"
//   output = "settlement"
//   from = 10.0                           # in the unit of the abscissa
//   to = 20.0
#pragma once

#include <vector>

#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "parameters/read_study.hpp"
#include "parameters/study.hpp"

namespace cpt::parameters {

/// Puts the program of the section, and its inputs at their usual values, into the baseline of a study that
/// has one; what is wrong goes on the list. Paths start at the folder of the study's file.
void read_program(const Value& root, FilesBeside files, Study& study, ErrorList& errors);

/// Every scalar as a window of its own name, and the [[windows]], each of a curve.
[[nodiscard]] std::vector<Window> read_program_windows(const Value& root,
                                                       const solver::ExternalProgram& program,
                                                       ErrorList& errors);

/// An error for each limit that another program alone has.
void refuse_program_limits(const Value& limits, ErrorList& errors);

/// An error for each key and section that the embedded solver alone has.
void refuse_embedded(const Value& root, ErrorList& errors);

}  // namespace cpt::parameters

// What the user should know of a study that is valid.
#pragma once

#include "parameters/study.hpp"

namespace cpt::cli {

/// Prints "note: ..." lines: layers of its baseline that are made otherwise than asked.
void print_remarks(const parameters::Study& study);

}  // namespace cpt::cli

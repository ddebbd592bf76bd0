// The section [design] of a study: which runs it adds to those that change one input at a time.
#pragma once

#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "parameters/study.hpp"

namespace cpt::parameters {

/// Adds the row of `shift_points` to those of the study: the material points' shift, which every run of the
/// design draws. None without the key, and after an error.
void add_drawn_shift(const Value& root, const solver::Setup& setup, std::vector<Row>& rows,
                     ErrorList& errors);

/// Reads the section; one_at_a_time without it and after an error. Its points are not made yet.
/// `setup` has the soils of the study.
[[nodiscard]] Design read_design(const Value& root, const std::vector<Row>& rows, const solver::Setup& setup,
                                 ErrorList& errors);

}  // namespace cpt::parameters

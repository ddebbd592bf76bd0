// Ranges over which a diagnosis looks: between a row's bounds, and over the prior of a mechanism's parameter.
// A place is 0 at the lower end and 1 at the upper one; values are in study units.
#pragma once

#include <cstddef>
#include <vector>

#include "parameters/study.hpp"
#include "solver/mechanisms/mechanism.hpp"

namespace cpt::diagnosis {

/// Indices of the mechanism's parameters that are varied: those whose prior is a range.
[[nodiscard]] std::vector<std::size_t> varied_parameters(const solver::Mechanism& mechanism);

/// Value of a mechanism's parameter at a place.
[[nodiscard]] double prior_value(const solver::MechanismParameter& parameter, double place);
/// A standard deviation of its place as one of its value: half of how far values lie apart that are one
/// deviation below and above the place.
[[nodiscard]] double prior_deviation(const solver::MechanismParameter& parameter, double place,
                                     double deviation);

/// Value of a row at a place: the nearest whole number where it must be one; of a choice the lower one below
/// 0.5.
[[nodiscard]] double row_value(const parameters::Row& row, double place);

}  // namespace cpt::diagnosis

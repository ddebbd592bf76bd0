// One input set of a study: what differs from the baseline, and the setup it makes.
#pragma once

#include <string>
#include <string_view>

#include "parameters/study.hpp"

namespace cpt::parameters {

enum class Side { baseline, lower, upper, point, repeat };
[[nodiscard]] std::string_view to_string(Side side);

struct Realization {
  int id = 0;    ///< from 1: the baseline is 1, then rows in file order, lower first, then Study::points
  int row = -1;  ///< index into Study::rows; -1 for the baseline and points
  Side side = Side::baseline;
  int point = -1;  ///< index into Study::points; -1 but for points and repeats
};

/// Dotted name of the changed quantity, a point's own name; "" for the baseline.
[[nodiscard]] std::string_view parameter_name(const Study& study, const Realization& realization);
/// Value of the changed quantity in its study unit; NaN for the baseline and points.
[[nodiscard]] double parameter_value(const Study& study, const Realization& realization);
/// What differs from the baseline as text: "27.9", "rigid", for a point "sand.H = 50, sand.nu = 0.3"; "" for
/// the baseline.
[[nodiscard]] std::string value_text(const Study& study, const Realization& realization);
/// Pure map from a realization to the solver's input.
[[nodiscard]] solver::Setup make_setup(const Study& study, const Realization& realization);
/// Every input of the realization (solver::canonical_text of its setup): equal texts mean equal runs.
[[nodiscard]] std::string settings_text(const Study& study, const Realization& realization);

}  // namespace cpt::parameters

// What is told about a material point: the one list that fields and histories read.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "solver/point_states.hpp"

namespace cpt::results {

/// A scalar (no components) or the components of a vector or tensor in the r-z plane. All SI.
struct PointQuantity {
  std::string_view name;                     ///< "void_ratio"
  std::string_view unit;                     ///< "Pa", "m/s", "-"
  std::vector<std::string_view> components;  ///< "r", "z"; none for a scalar
  /// Value of a component now, given the point's state at the start of the push.
  double (*value)(const solver::PointState& now, const solver::PointState& start, std::size_t component);
};

[[nodiscard]] std::span<const PointQuantity> point_quantities();

/// "sand", "clay", "surcharge".
[[nodiscard]] std::string_view to_string(solver::Material material);

}  // namespace cpt::results

// What is told about a material point: the one list that fields and histories read.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/point_states.hpp"
#include "solver/setup.hpp"

namespace cpt::results {

/// A scalar (no components) or the components of a vector or tensor in the r-z plane. All SI.
struct PointQuantity {
  std::string_view name;                     ///< "void_ratio"
  std::string_view unit;                     ///< "Pa", "m/s", "-"
  std::vector<std::string_view> components;  ///< "r", "z"; none for a scalar
  /// Value of a component now, given the point's state at the start of the push.
  std::function<double(const solver::PointState& now, const solver::PointState& start, std::size_t component)>
      value;
};

/// Those of a push: of its soils also the state variables that their laws keep, NaN in other soils.
[[nodiscard]] std::vector<PointQuantity> point_quantities(const solver::Setup& setup);

/// "sand", "clay", "surcharge".
[[nodiscard]] std::string material_name(const solver::Setup& setup, std::int32_t material);

}  // namespace cpt::results

// A row's `field = { standard_deviation = ..., correlation_length_m = ... }`: it varies over depth, and every
// realization draws another field (solver/soils/random_field.hpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "parameters/read_quantities.hpp"

namespace cpt::parameters {

/// What a field sets, and the row that draws it, which has no bounds.
struct ReadField {
  std::vector<Setting> settings;
  Row seed;
};

/// Of `quantity` with that mean, in its study unit. `member` is the row's entry `field`, `key` what errors
/// name. Nothing after an error.
[[nodiscard]] std::optional<ReadField> read_field(const Member& member, const solver::Quantity& quantity,
                                                  double mean, const solver::Setup& setup,
                                                  const std::string& key, ErrorList& errors);

/// "sand.D_r_percent, clay.s_u_kPa": those of a setup that may be fields.
[[nodiscard]] std::vector<std::string> field_quantities(const solver::Setup& setup);

}  // namespace cpt::parameters

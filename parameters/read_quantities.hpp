// The sections [fixed] and [parameters] of a study: quantities of the one list and their values.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "parameters/read_soils.hpp"
#include "parameters/study.hpp"

namespace cpt::parameters {

/// A quantity set in the file, with the key to name in errors.
struct Setting {
  const solver::Quantity* quantity;
  double value;  ///< in the quantity's study unit
  std::string key;
  Place place;
};

/// A row and where its numbers stand.
struct PlacedRow {
  Row row;
  Place lower, upper;
};

struct QuantitySections {
  std::vector<Setting> settings;  ///< fixed inputs, then the rows' baselines
  std::vector<PlacedRow> rows;    ///< those without errors, in file order
  std::set<std::string>
      doubtful;  ///< names of quantities with an error: their values are not to be judged further
};

/// Reads both sections. `setup` is the preset's, with the study's layers, for omitted baselines and for the
/// soils that the profile contains; quantities of other soils are errors.
[[nodiscard]] QuantitySections read_quantities(const Value& root, const solver::Setup& setup,
                                               const SoilDoubts& doubts, ErrorList& errors);

/// Whether [parameters] has an entry of that name, sound or not.
[[nodiscard]] bool is_row_given(const Value& root, std::string_view name);

/// The quantities of one table but for the members `except`, such as a point of the design; errors name the
/// section.
[[nodiscard]] std::vector<Setting> read_settings(const Value& table, std::string_view section,
                                                 std::span<const std::string_view> except,
                                                 const solver::Setup& setup, const SoilDoubts& doubts,
                                                 ErrorList& errors);

}  // namespace cpt::parameters

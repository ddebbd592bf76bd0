// The one list of settable inputs. The study reader, `campaign list quantities`, `--set`, the reports and the
// settings hash all read it; a new input is one more line in quantities.cpp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/setup.hpp"

namespace cpt::solver {

/// One scalar or choice input of Setup.
struct Quantity {
  std::string_view name;                  ///< dotted name with its unit, as in study files: "clay.s_u_kPa"
  std::string_view symbol;                ///< UTF-8 symbol for plots: "σ'ₕ₀"
  std::string_view unit;                  ///< unit in study files: "kPa", "deg", "%", "-" ...
  double scale;                           ///< SI value = scale * study value
  double min, max;                        ///< valid range in study units, both ends included
  std::vector<std::string_view> choices;  ///< names of the alternatives in rising order; empty for a number
  bool integer;                           ///< number that must be whole
  std::optional<Soil> soil;     ///< set if the quantity matters only for profiles that contain this soil
  std::string_view meaning;     ///< one line
  std::string_view source;      ///< where the default or range comes from
  double (*get)(const Setup&);  ///< value in SI (index into `choices` for a choice)
  void (*set)(Setup&, double);  ///< value in SI (index into `choices` for a choice)
  /// Left out of canonical_text at its default, so that results stored before it was listed stay valid.
  bool silent_default = false;

  /// Value in study units, the index for a choice: the shortest number that set_value turns into the same SI
  /// value.
  [[nodiscard]] double value(const Setup& setup) const;
  void set_value(Setup& setup, double study_value) const { set(setup, study_value * scale); }
  /// "27.9", or the name of the choice; shortest text that reads back to the same double.
  [[nodiscard]] std::string format(double study_value) const;
};

[[nodiscard]] std::span<const Quantity> all_quantities();
[[nodiscard]] const Quantity* find_quantity(std::string_view name);  ///< nullptr if there is none
/// The name nearest to a misspelt one, for hints: a name without its group or unit, or with another unit,
/// counts as near. "" if none is near.
[[nodiscard]] std::string_view nearest_quantity(std::string_view name);
/// The same among any names, by edit distance; part of a name counts as near.
[[nodiscard]] std::string_view nearest_name(std::string_view name, std::span<const std::string_view> names);

/// What is wrong with a setup as a whole: single values out of range and impossible combinations.
struct Problem {
  std::string quantity;  ///< dotted name of the quantity to change, or "layers" / "numerics.zones"
  std::string message;   ///< value, violated constraint and a hint
};
[[nodiscard]] std::vector<Problem> problems(const Setup& setup);

/// All inputs, layers and zones of material points, one "name = value" line each in study units. Values read
/// back to the same double, so that equal texts mean equal runs. Quantities with a silent default are left
/// out where they have it.
[[nodiscard]] std::string canonical_text(const Setup& setup);

}  // namespace cpt::solver

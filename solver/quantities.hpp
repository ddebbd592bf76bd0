// The one list of settable inputs: of each soil the parameters of its law, then all others. The study reader,
// `campaign list quantities`, `--set`, the reports and the settings hash all read it; a new input is one more
// line in quantities.cpp, or in its law.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/problem.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

/// Whether a quantity or a mechanism acts on soils of a law; nullptr where it acts whatever the soil.
using ActsOn = bool (*)(const Law&);

/// One scalar or choice input of Setup.
struct Quantity {
  std::string name;                         ///< dotted name with its unit, as in study files: "clay.s_u_kPa"
  std::string symbol;                       ///< UTF-8 symbol for plots: "σ'ₕ₀"
  std::string_view unit;                    ///< unit in study files: "kPa", "deg", "%", "-" ...
  double scale;                             ///< SI value = scale * study value
  double min, max;                          ///< valid range in study units, both ends included
  std::vector<std::string_view> choices;    ///< names of the alternatives in rising order; empty for a number
  bool integer;                             ///< number that must be whole
  std::string soil;                         ///< the soil whose parameter it is; empty for all others
  ActsOn acts_on;                           ///< on soils of which laws, if not on all
  std::string_view meaning;                 ///< one line
  std::string_view source;                  ///< where the default or range comes from
  std::function<double(const Setup&)> get;  ///< value in SI (index into `choices` for a choice)
  std::function<void(Setup&, double)> set;  ///< value in SI (index into `choices` for a choice)
  /// [SI] Left out of canonical_text at this value, its default, so that results stored before it was listed
  /// stay valid.
  std::optional<double> silent_default = {};

  /// Value in study units, the index for a choice: the shortest number that set_value turns into the same SI
  /// value.
  [[nodiscard]] double value(const Setup& setup) const;
  void set_value(Setup& setup, double study_value) const { set(setup, study_value * scale); }
  /// "27.9", or the name of the choice; shortest text that reads back to the same double.
  [[nodiscard]] std::string format(double study_value) const;
};

/// Those of a setup that names no soils of its own.
[[nodiscard]] std::span<const Quantity> all_quantities();
/// Those of any setup, in the order of canonical_text; of one with an external program its inputs and no
/// others. They live as long as the program: one and the same object for the same soil and law, or the same
/// declaration of an input.
[[nodiscard]] std::vector<const Quantity*> quantities_of(const Setup& setup);
/// nullptr if there is none. Without a setup: among all_quantities().
[[nodiscard]] const Quantity* find_quantity(std::string_view name);
[[nodiscard]] const Quantity* find_quantity(std::string_view name, const Setup& setup);
/// True unless it acts only on soils or laws that no layer has.
[[nodiscard]] bool matters(const Quantity& quantity, const Setup& setup);
/// "clay", "NorSand, Mohr-Coulomb", "" where it acts whatever the soil.
[[nodiscard]] std::string acts_on_text(const Quantity& quantity);

/// "sand.e_min = 0.552"
[[nodiscard]] std::string given(const Setup& setup, std::string_view name);

/// What is wrong with a setup as a whole: single values out of range and impossible combinations.
[[nodiscard]] std::vector<Problem> problems(const Setup& setup);

/// All inputs, layers and zones of material points, one "name = value" line each in study units. Values read
/// back to the same double, so that equal texts mean equal runs. Quantities with a silent default are left
/// out where they have it, and so are the soils where a setup names none of its own. With an external program
/// its command, version, template and outputs, and its inputs.
[[nodiscard]] std::string canonical_text(const Setup& setup);

}  // namespace cpt::solver

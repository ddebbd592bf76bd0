// The section [soils] of a study: soils by name, each of a law, in place of those that every study has.
#pragma once

#include <set>
#include <string>

#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "solver/setup.hpp"

namespace cpt::parameters {

/// What is not known after errors elsewhere, so that nothing is judged by it.
struct SoilDoubts {
  bool any = false;                   ///< which soils there are: any name may be one
  std::set<std::string> named = {};   ///< soils of these names: whether there is one, or of which law it is
  std::set<std::string> unused = {};  ///< soils that are told to be in no layer; their quantities are not
  bool layers = false;                ///< of which soils the layers are
  bool depths = false;                ///< from where to where the layers reach

  /// Whether a quantity "NAME.x" may be one of a soil of which nothing is known.
  [[nodiscard]] bool about(std::string_view name, const solver::Setup& setup) const;
};

/// Puts the named soils, with the defaults of their laws, in place of the setup's. One whose law has an error
/// is there, too, and in doubt. The setup stays as it was where no soil is named rightly.
void read_soils(const Value& root, solver::Setup& setup, SoilDoubts& doubts, ErrorList& errors);

/// Whether there are quantities "NAME.x" that are no soil's, such as those of the chamber.
[[nodiscard]] bool is_group_beside_soils(std::string_view name);

}  // namespace cpt::parameters

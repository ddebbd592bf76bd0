// A soil: a name, a constitutive law and its parameters. A law is one of the alternatives here and two files
// of its own; all else asks it (law.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <variant>

#include "solver/soils/modified_cam_clay.hpp"
#include "solver/soils/mohr_coulomb.hpp"
#include "solver/soils/norsand.hpp"
#include "solver/soils/tresca.hpp"

namespace cpt::solver {

/// The one list of laws: their parameters, in the order in which they are listed.
using LawParameters =
    std::variant<NorSandParameters, TrescaParameters, ModifiedCamClayParameters, MohrCoulombParameters>;

struct Soil {
  std::string name;  ///< unique in a setup; its quantities are NAME.parameter
  LawParameters parameters;
};

/// The parameters of a soil of that law. Throws std::bad_variant_access for one of another.
template <class Parameters>
[[nodiscard]] Parameters& as(Soil& soil) {
  return std::get<Parameters>(soil.parameters);
}
template <class Parameters>
[[nodiscard]] const Parameters& as(const Soil& soil) {
  return std::get<Parameters>(soil.parameters);
}

/// Soils of a setup that names none of its own: NorSand's sand and Tresca's clay.
inline constexpr std::size_t default_sand = 0, default_clay = 1;

}  // namespace cpt::solver

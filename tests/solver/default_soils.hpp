// The soils of a setup that names none of its own.
#pragma once

#include "solver/soils/law.hpp"

namespace cpt::solver {

inline NorSandParameters& sand_of(Setup& setup) { return as<NorSandParameters>(setup.soils[default_sand]); }
inline const NorSandParameters& sand_of(const Setup& setup) {
  return as<NorSandParameters>(setup.soils[default_sand]);
}
inline TrescaParameters& clay_of(Setup& setup) { return as<TrescaParameters>(setup.soils[default_clay]); }
inline const TrescaParameters& clay_of(const Setup& setup) {
  return as<TrescaParameters>(setup.soils[default_clay]);
}

/// What each soil of a setup does, for tests that make points without a push; the surcharge is not among
/// them.
inline std::vector<std::unique_ptr<const SoilModel>> models_of(const Setup& setup) {
  std::vector<std::unique_ptr<const SoilModel>> models;
  for (const Soil& soil : setup.soils)
    models.push_back(law_of(soil).model(soil.parameters, setup.mechanisms));
  return models;
}

}  // namespace cpt::solver

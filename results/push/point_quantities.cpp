#include "results/push/point_quantities.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "solver/soils/law.hpp"

namespace cpt::results {
namespace {

using solver::PointState;

// Of each soil the place of a state variable among its law's; none where the law does not keep it.
std::vector<std::optional<std::size_t>> places_of(std::string_view variable, const solver::Setup& setup) {
  std::vector<std::optional<std::size_t>> places;
  for (const solver::Soil& soil : setup.soils) {
    const auto state = solver::law_of(soil).state(soil.parameters, setup.mechanisms);
    const auto found = std::ranges::find(state, variable, &solver::StateVariable::name);
    places.push_back(found == state.end() ? std::nullopt
                                          : std::optional(static_cast<std::size_t>(found - state.begin())));
  }
  return places;
}

void add_state_variables(std::vector<PointQuantity>& list, const solver::Setup& setup) {
  for (const solver::Soil& soil : setup.soils)
    for (const solver::StateVariable& variable :
         solver::law_of(soil).state(soil.parameters, setup.mechanisms)) {
      if (std::ranges::find(list, variable.name, &PointQuantity::name) != list.end()) continue;
      const auto value = [places = places_of(variable.name, setup)](const PointState& s, const PointState&,
                                                                    std::size_t) {
        const auto material = static_cast<std::size_t>(s.material);
        if (material >= places.size() || !places[material]) return std::numeric_limits<double>::quiet_NaN();
        return *places[material] == 0 ? s.h_0 : s.h_1;
      };
      list.push_back({variable.name, variable.unit, {}, value});
    }
}

}  // namespace

std::vector<PointQuantity> point_quantities(const solver::Setup& setup) {
  using Now = const PointState&;
  using Start = const PointState&;
  std::vector<PointQuantity> list = {
      {"position", "m", {"r", "z"}, [](Now s, Start, std::size_t c) { return c == 0 ? s.r : s.z; }},
      {"displacement",
       "m",
       {"r", "z"},
       [](Now s, Start s0, std::size_t c) { return c == 0 ? s.r - s0.r : s.z - s0.z; }},
      {"velocity", "m/s", {"r", "z"}, [](Now s, Start, std::size_t c) { return c == 0 ? s.v_r : s.v_z; }},
      // Tension-positive, as tensors are.
      {"stress",
       "Pa",
       {"rr", "zz", "tt", "rz"},
       [](Now s, Start, std::size_t c) {
         const double components[] = {s.s_rr, s.s_zz, s.s_tt, s.s_rz};
         return components[c];
       }},
      {"p", "Pa", {}, [](Now s, Start, std::size_t) { return s.p(); }},
      {"q", "Pa", {}, [](Now s, Start, std::size_t) { return s.q(); }},
      {"void_ratio", "-", {}, [](Now s, Start, std::size_t) { return s.e; }},
      {"void_ratio_change", "-", {}, [](Now s, Start s0, std::size_t) { return s.e - s0.e; }},
  };
  add_state_variables(list, setup);
  list.push_back({"volume", "m3", {}, [](Now s, Start, std::size_t) { return s.volume; }});
  return list;
}

std::string material_name(const solver::Setup& setup, std::int32_t material) {
  const auto soil = static_cast<std::size_t>(material);
  return soil < setup.soils.size() ? setup.soils[soil].name : "surcharge";
}

}  // namespace cpt::results

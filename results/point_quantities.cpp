#include "results/point_quantities.hpp"

namespace cpt::results {

using solver::PointState;

std::span<const PointQuantity> point_quantities() {
  using Now = const PointState&;
  using Start = const PointState&;
  static const std::vector<PointQuantity> list = {
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
      {"p_i", "Pa", {}, [](Now s, Start, std::size_t) { return s.p_i; }},
      {"volume", "m3", {}, [](Now s, Start, std::size_t) { return s.volume; }},
  };
  return list;
}

std::string_view to_string(solver::Material material) {
  constexpr std::string_view names[solver::material_count] = {"sand", "clay", "surcharge"};
  return names[static_cast<std::size_t>(material)];
}

}  // namespace cpt::results

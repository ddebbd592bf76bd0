#include "parameters/run_order.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <string_view>

namespace cpt::parameters {
namespace {

constexpr std::size_t leading_rows = 4;
constexpr double usual_strength = 0.4;  // of an input that the list does not have: in its middle

// |SI| over the relative distance of the bounds, (upper - lower) / the larger of them: the studies of Yost et
// al. (2023) in homogeneous sand and clay as docs/paper.md has them, and their sections 6.3.1 (sigma'_v0).
struct Strength {
  std::string_view quantity;
  double value;
};
constexpr Strength strengths[] = {
    {"sand.phi_cs_deg", 1.2},
    {"initial.sigma_v0_kPa", 0.9},
    {"sand.H", 0.78},
    {"sand.D_r_percent", 0.75},
    {"clay.s_u_kPa", 0.68},
    {"sand.chi_tc", 0.67},
    {"initial.sigma_h0_kPa", 0.44},
    {"contact.friction_ratio", 0.40},
    {"clay.G_kPa", 0.36},
    {"chamber.wall", 0.21},
    {"contact.adhesion_ratio", 0.14},
    {"chamber.radius_m", 0.13},
    {"sand.lambda", 0.11},
    {"sand.G_ref", 0.06},
    {"sand.nu", 0.02},
    {"sand.N", 0.02},
    {"clay.n_0", 0.01},
};

double strength_of(std::string_view quantity) {
  const auto* known = std::ranges::find(strengths, quantity, &Strength::quantity);
  return known == std::end(strengths) ? usual_strength : known->value;
}

}  // namespace

double expected_effect(const Row& row) {
  const double strength = strength_of(row.quantity->name);
  if (!row.quantity->choices.empty()) return strength;
  const double larger = std::max(std::abs(row.lower), std::abs(row.upper));
  return larger > 0.0 ? strength * std::abs(row.upper - row.lower) / larger : 0.0;
}

RunOrder run_order(const Study& study, std::span<const Realization> realizations) {
  std::vector<int> rows(study.rows.size());
  std::iota(rows.begin(), rows.end(), 0);
  const auto effect = [&](int row) { return expected_effect(study.rows[static_cast<std::size_t>(row)]); };
  std::ranges::stable_sort(rows, std::greater<>{}, effect);

  RunOrder order;
  const auto add = [&](auto belongs) {
    for (const Realization& realization : realizations)
      if (belongs(realization)) order.ids.push_back(realization.id);
  };
  add([](const Realization& r) { return r.side == Side::baseline; });
  order.leading = static_cast<int>(order.ids.size());
  for (std::size_t place = 0; place < rows.size(); ++place) {
    add([&](const Realization& r) { return r.row == rows[place]; });
    if (place < leading_rows) order.leading = static_cast<int>(order.ids.size());
  }
  add([](const Realization& r) { return r.side != Side::baseline && r.row < 0; });
  return order;
}

}  // namespace cpt::parameters

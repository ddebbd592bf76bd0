#include "recordings/soil_behaviour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cpt::recordings {
namespace {

/// Normalized with a given exponent; NaN outside of the chart.
Behaviour normalized(double q_t, double f_s, const Ground& ground, double n) {
  const double net = q_t - ground.sigma_v0;
  if (!(net > 0.0) || !(f_s > 0.0) || !(ground.effective_sigma_v0 > 0.0)) return {};
  Behaviour b;
  b.n = n;
  b.Q_tn = net / atmosphere * std::pow(atmosphere / ground.effective_sigma_v0, n);
  b.F_r = 100.0 * f_s / net;
  b.I_c = behaviour_index(b.Q_tn, b.F_r);
  return b;
}

}  // namespace

double corrected_resistance(double q_c, double u_2, double area_quotient) {
  return q_c + (1.0 - area_quotient) * u_2;
}

Ground ground_at(double depth, const GroundModel& model) {
  const double sigma_v0 = model.surcharge + model.unit_weight * depth;
  const double u_0 = unit_weight_of_water * std::max(0.0, depth - model.water_table);
  return {sigma_v0, sigma_v0 - u_0};
}

double behaviour_index(double Q, double F_r) {
  return std::hypot(3.47 - std::log10(Q), 1.22 + std::log10(F_r));
}

int behaviour_zone(double Q, double F_r) {
  if (Q < 12.0 * std::exp(-1.4 * F_r)) return 1;
  const double f = F_r - 1.0;
  const double inverse = 0.005 * f - 0.0003 * f * f - 0.002;
  if (F_r > 1.5 && inverse > 0.0 && Q * inverse > 1.0) return F_r < 4.5 ? 8 : 9;
  const double I_c = behaviour_index(Q, F_r);
  return I_c < 1.31 ? 7 : I_c < 2.05 ? 6 : I_c < 2.60 ? 5 : I_c < 2.95 ? 4 : I_c <= 3.60 ? 3 : 2;
}

std::string_view name_of_zone(int zone) {
  static constexpr std::array<std::string_view, 10> names = {"",
                                                             "sensitive, fine grained",
                                                             "organic soils: peats",
                                                             "clays: silty clay to clay",
                                                             "silt mixtures: clayey silt to silty clay",
                                                             "sand mixtures: silty sand to sandy silt",
                                                             "sands: clean sand to silty sand",
                                                             "gravelly sand to dense sand",
                                                             "very stiff sand to clayey sand",
                                                             "very stiff, fine grained"};
  return names[static_cast<std::size_t>(std::clamp(zone, 0, 9))];
}

Behaviour behaviour_2009(double q_t, double f_s, const Ground& ground) {
  const auto wanted = [&](double I_c) {
    return std::min(1.0, 0.381 * I_c + 0.05 * ground.effective_sigma_v0 / atmosphere - 0.15);
  };
  // The paper puts I_c and n into each other in turn, which swings for ever where sigma'_v0 is tiny. Their
  // common value lies between n of I_c = 0 and 1.
  double low = -0.15, high = 1.0;
  Behaviour b = normalized(q_t, f_s, ground, high);
  if (!std::isfinite(b.I_c)) return {};
  if (wanted(b.I_c) < high) {
    for (int i = 0; i < 50; ++i) {
      const double n = 0.5 * (low + high);
      b = normalized(q_t, f_s, ground, n);
      (wanted(b.I_c) > n ? low : high) = n;
    }
  }
  if (!std::isfinite(b.I_c)) return {};
  b.zone = behaviour_zone(b.Q_tn, b.F_r);
  return b;
}

Behaviour behaviour_1990(double q_t, double f_s, const Ground& ground) {
  Behaviour b = normalized(q_t, f_s, ground, 1.0);
  if (std::isfinite(b.I_c)) b.zone = behaviour_zone(b.Q_tn, b.F_r);
  return b;
}

}  // namespace cpt::recordings

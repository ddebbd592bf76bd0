#include "solver/first_push.hpp"

#include <cmath>
#include <limits>

#include "solver/initial_state.hpp"
#include "solver/point_states.hpp"

namespace cpt::solver {

FirstPush::FirstPush(const Setup& setup, Observer& observer)
    : setup_(setup), asked_(setup.mechanisms.previous_push), observer_(observer) {
  setup_.mechanisms.previous_push = {};
  if (asked_.depth > 0.0) setup_.penetrometer.final_depth = asked_.depth;
}

double FirstPush::next_look() const {
  return looked_ ? std::numeric_limits<double>::infinity() : setup_.penetrometer.final_depth;
}

void FirstPush::look(double depth, const MaterialPoints& points) {
  looked_ = true;
  struct Bin {
    double volume = 0.0, sand_volume = 0.0, sigma_h = 0.0, sigma_v = 0.0, e = 0.0;
  };
  const auto count = static_cast<std::size_t>(std::max(1.0, std::floor(depth / left_.bin)));
  std::vector<Bin> bins(count);
  const double reach = 2.0 * setup_.penetrometer.diameter;
  for (const PointState& point : point_states(points)) {
    if (point.material == Material::surcharge || point.z >= 0.0) continue;
    if (std::abs(point.r - asked_.spacing) > reach) continue;
    const auto k = static_cast<std::size_t>(-point.z / left_.bin);
    if (k >= count) continue;
    Bin& bin = bins[k];
    bin.volume += point.volume;
    bin.sigma_h -= 0.5 * (point.s_rr + point.s_tt) * point.volume;
    bin.sigma_v -= point.s_zz * point.volume;
    if (point.material != Material::sand) continue;
    bin.sand_volume += point.volume;
    bin.e += point.e * point.volume;
  }

  double ratio_v = 0.0;
  std::size_t filled = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (bins[k].volume <= 0.0) continue;
    const double middle = (static_cast<double>(k) + 0.5) * left_.bin;
    ratio_v += bins[k].sigma_v / bins[k].volume / vertical_stress(setup_, -middle);
    ++filled;
  }
  if (filled == 0) return;
  const double stress_share = asked_.share * asked_.stress_share;
  const double void_ratio_share = asked_.share * asked_.void_ratio_share;
  left_.sigma_v_ratio = 1.0 + stress_share * (ratio_v / static_cast<double>(filled) - 1.0);
  left_.sigma_h_ratio.assign(count, 1.0);
  left_.void_ratio_change.assign(count, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const Bin& bin = bins[k];
    const double middle = (static_cast<double>(k) + 0.5) * left_.bin;
    if (bin.volume > 0.0) {
      const double ratio = bin.sigma_h / bin.volume / horizontal_stress(setup_, {}, -middle);
      // The second push's K_0 stress grows with sigma_v0 already.
      left_.sigma_h_ratio[k] = (1.0 + stress_share * (ratio - 1.0)) / left_.sigma_v_ratio;
    }
    if (bin.sand_volume > 0.0)
      left_.void_ratio_change[k] =
          void_ratio_share * (bin.e / bin.sand_volume - sand_void_ratio(setup_, {}, middle));
  }
}

}  // namespace cpt::solver

#include "solver/first_push.hpp"

#include <cmath>
#include <limits>

#include "solver/initial_state.hpp"
#include "solver/point_states.hpp"
#include "solver/soils/law.hpp"

namespace cpt::solver {
namespace {

// Of the points of one soil in a bin.
struct SoilSum {
  double volume = 0.0;  // [m3]
  double e = 0.0;       // [m3] void ratio times volume
};

// Mean over the soils by their volume [-].
double change_of_void_ratio(const Setup& setup, const std::vector<SoilSum>& sums, double depth) {
  double volume = 0.0, change = 0.0;
  for (const SoilSum& sum : sums) volume += sum.volume;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    if (sums[k].volume <= 0.0) continue;
    const Soil& soil = setup.soils[k];
    const double before = law_of(soil).void_ratio_at(setup, soil.parameters, {}, depth);
    change += sums[k].volume / volume * (sums[k].e / sums[k].volume - before);
  }
  return change;
}

}  // namespace

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
    double volume = 0.0, sigma_h = 0.0, sigma_v = 0.0;
    std::vector<SoilSum> of_soil;
  };
  const auto count = static_cast<std::size_t>(std::max(1.0, std::floor(depth / left_.bin)));
  const std::size_t soils = setup_.soils.size();
  std::vector<Bin> bins(count, {0.0, 0.0, 0.0, std::vector<SoilSum>(soils)});
  const double reach = 2.0 * setup_.penetrometer.diameter;
  for (const PointState& point : point_states(points)) {
    const auto soil = static_cast<std::size_t>(point.material);
    if (soil >= soils || point.z >= 0.0) continue;
    if (std::abs(point.r - asked_.spacing) > reach) continue;
    const auto k = static_cast<std::size_t>(-point.z / left_.bin);
    if (k >= count) continue;
    Bin& bin = bins[k];
    bin.volume += point.volume;
    bin.sigma_h -= 0.5 * (point.s_rr + point.s_tt) * point.volume;
    bin.sigma_v -= point.s_zz * point.volume;
    if (!law_of(setup_.soils[soil]).density_varies()) continue;
    bin.of_soil[soil].volume += point.volume;
    bin.of_soil[soil].e += point.e * point.volume;
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
    left_.void_ratio_change[k] = void_ratio_share * change_of_void_ratio(setup_, bin.of_soil, middle);
  }
}

}  // namespace cpt::solver

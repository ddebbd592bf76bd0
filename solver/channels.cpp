#include "solver/channels.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace cpt::solver {
namespace {

constexpr double untold = std::numeric_limits<double>::quiet_NaN();

constexpr auto all = std::to_array<Channel>({
    {"q_c", "q_c", "cone tip resistance",
     "force on the cone's face and shoulder over its projected area, averaged over the time in a depth bin; "
     "compression-positive",
     &DepthProfile::q_c, [](const StepLoads& step) { return step.penetrometer.cone_force; }, true, true, 1.0},
    {"f_s", "f_s", "sleeve friction",
     "upward force on the friction sleeve over its area, averaged over the time in a depth bin; positive "
     "when the soil "
     "pushes the sleeve upward",
     &DepthProfile::f_s,
     [](const StepLoads& step) {
       const PenetrometerLoad& load = step.penetrometer;
       return load.sleeve_area > 0.0 ? load.sleeve_force / load.sleeve_area : 0.0;
     },
     false, true, 3.0},
    {"wall_stress", "σ_w", "wall stress",
     "radial stress on the chamber's wall from one cone diameter above the tip to one below it, averaged "
     "over the time in "
     "a depth bin; compression-positive",
     &DepthProfile::wall_stress, [](const StepLoads& step) { return step.wall_stress; }, false, false,
     untold},
});
static_assert(all.size() == channel_count);

}  // namespace

std::span<const Channel> channels() { return all; }

const Channel& channel(std::string_view name) {
  const auto found = std::ranges::find(all, name, &Channel::name);
  if (found == all.end()) throw std::out_of_range("no channel " + std::string(name));
  return *found;
}

std::string in_unit(const Channel& channel, std::string_view unit) {
  return std::string(channel.name) + '_' + std::string(unit);
}

bool is_even(const DepthProfile& profile) {
  return std::ranges::all_of(all,
                             [&](const Channel& channel) {
                               const std::vector<double>& values = profile.*channel.values;
                               return values.size() == profile.depth.size() ||
                                      (values.empty() && !channel.required);
                             }) &&
         std::ranges::all_of(profile.declared, [](const ProgramResult& result) {
           return result.y.size() == (result.x.empty() ? 1 : result.x.size());
         });
}

}  // namespace cpt::solver

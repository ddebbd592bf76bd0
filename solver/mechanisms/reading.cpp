#include "solver/mechanisms/reading.hpp"

namespace cpt::solver {

DepthProfile as_recorded(DepthProfile profile, const Setup& setup) {
  const double offset = setup.mechanisms.zero_offset.offset, drift = setup.mechanisms.zero_drift.at_end;
  const double gain = setup.mechanisms.gain_drift.at_end, shift = setup.mechanisms.depth_datum.shift;
  setup.mechanisms.sleeve_load.apply(profile, setup.penetrometer);
  if (offset != 0.0 || drift != 0.0 || gain != 0.0)
    for (std::size_t i = 0; i < profile.q_c.size(); ++i) {
      const double way = profile.depth[i] / setup.penetrometer.final_depth;
      profile.q_c[i] = profile.q_c[i] * (1.0 + gain * way) + (offset + drift * way);
    }
  if (const Inclination& inclination = setup.mechanisms.inclination; inclination.on())
    for (double& depth : profile.depth) depth = inclination.length(depth, setup.penetrometer.final_depth);
  if (shift != 0.0)
    for (double& depth : profile.depth) depth += shift;
  return profile;
}

}  // namespace cpt::solver

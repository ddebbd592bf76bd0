// A push of a few millimetres through sand, to record.
#pragma once

#include "solver/point_states.hpp"
#include "solver/presets.hpp"

namespace cpt::results {

/// From the start at 21.9 mm to 23.9 mm depth of the tip.
inline solver::Setup short_push() {
  solver::Setup setup = solver::make_setup(solver::Profile::homogeneous_sand, solver::Preset::quick);
  setup.penetrometer.final_depth = 0.0239;
  return setup;
}

/// A material point at rest with a stress of its own.
inline solver::PointState point(std::int64_t id, double r, double depth, double e = 0.7) {
  solver::PointState state;
  state.id = id;
  state.r = r;
  state.z = -depth;
  state.s_rr = -1e3 * static_cast<double>(id);
  state.s_zz = -2e3 * static_cast<double>(id);
  state.s_tt = state.s_rr;
  state.volume = r;
  state.e = e;
  state.h_0 = 5e3;
  return state;
}

}  // namespace cpt::results

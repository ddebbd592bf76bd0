// A quick push of a few centimetres, and the initial state by depth.
#pragma once

#include <functional>

#include "solver/initial_state.hpp"
#include "solver/presets.hpp"
#include "solver/simulate.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::solver {

inline Setup quick(Profile profile, double final_depth) {
  Setup setup = make_setup(profile, Preset::quick);
  setup.penetrometer.final_depth = final_depth;
  return setup;
}

inline Outcome run(const Setup& setup) {
  Observer observer;
  return simulate(setup, observer, {1});
}

/// Mean q_c [Pa] between two depths [m].
inline double mean_q_c(const Outcome& outcome, double from, double to) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < outcome.profile.depth.size(); ++k)
    if (outcome.profile.depth[k] >= from && outcome.profile.depth[k] < to)
      sum += outcome.profile.q_c[k], ++count;
  return sum / count;
}

/// Calls `look` with every material point of soil before the push.
inline void for_initial_soil(const Setup& setup,
                             const std::function<void(const Point&, std::int32_t)>& look) {
  const InitialState state = initial_state(setup, models_of(setup));
  for (std::size_t k = 0; k < state.points.size(); ++k)
    if (state.points[k].z < 0.0) look(state.points[k], state.material[k]);
}

}  // namespace cpt::solver

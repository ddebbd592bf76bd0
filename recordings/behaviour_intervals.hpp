// A sounding's soil behaviour in few words: depth intervals of one zone.
#pragma once

#include <vector>

#include "recordings/soil_behaviour.hpp"

namespace cpt::recordings {

struct BehaviourInterval {
  double from = 0.0, to = 0.0;  // [m]
  int zone = 0;                 ///< that most of its readings have
  int readings = 0;             ///< with a zone
  int of_zone = 0;              ///< of these, with the interval's
  double q_t = not_given;       // [Pa] medians
  double R_f = not_given;       // [%]
  double I_c = not_given;       // [-]
};

/// Vectors of one length; depths do not fall.
struct BehaviourProfile {
  std::vector<double> depth;  // [m]
  std::vector<double> q_t;    // [Pa]
  std::vector<double> R_f;    // [%]
  std::vector<Behaviour> behaviour;
};

/// Runs of readings of one zone. Those thinner than `least` [m] join a neighbour, the thinnest first: the one
/// whose mean I_c is nearer. Readings without a zone belong to no interval where they span `least` or more.
[[nodiscard]] std::vector<BehaviourInterval> behaviour_intervals(const BehaviourProfile& profile,
                                                                 double least);

}  // namespace cpt::recordings

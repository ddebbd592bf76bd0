// What is read out of a sounding beyond its readings, and what had to be assumed for it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recordings/behaviour_intervals.hpp"
#include "recordings/push_speed.hpp"
#include "recordings/soil_behaviour.hpp"
#include "recordings/spikes.hpp"

namespace cpt::recordings {

/// What is known of ground and cone; what is not given is assumed (GroundModel), or taken from the file.
struct KnownGround {
  std::optional<double> unit_weight;    // [N/m3]
  std::optional<double> water_table;    // [m]
  std::optional<double> surcharge;      // [Pa]
  std::optional<double> area_quotient;  // [-]
};

enum class Origin { given, from_file, assumed };
[[nodiscard]] std::string_view name_of(Origin origin);

/// A value that the interpretation rests on.
struct Assumption {
  std::string what;
  double value;
  std::string unit;
  Origin origin;
};

struct Interpretation {
  std::vector<Assumption> assumptions;
  bool corrected = false;  ///< q_t holds the pore pressure; else q_t = q_c for the reason below
  std::string why_not_corrected, why_no_behaviour;  ///< "" where there is nothing to tell
  // One for each reading; NaN where it is not known.
  std::vector<double> q_t;  // [Pa]
  std::vector<double> R_f;  // [%] 100 f_s/q_t
  std::vector<Ground> ground;
  std::vector<Behaviour> behaviour;
  double least_interval = 0.0;  // [m] thinner ones have joined a neighbour
  std::vector<BehaviourInterval> intervals;
  std::vector<Spike> spikes;
  PushSpeed speed;
  std::vector<OddSpeed> odd_speeds;
};

/// Readings above the predrilled depth have no behaviour: they are not of the soil.
[[nodiscard]] Interpretation interpret(const Recording& recording, const KnownGround& known = {});

}  // namespace cpt::recordings

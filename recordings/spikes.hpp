// Single readings that stand out of their neighbours: knocks, lost contacts, a sensor that failed once.
#pragma once

#include <string_view>
#include <vector>

#include "recordings/recording.hpp"

namespace cpt::recordings {

struct Spike {
  std::size_t reading;        ///< of recording.readings
  std::string_view quantity;  ///< "q_c", "f_s" or "u_2"
  double value;               // [Pa]
  double neighbours;          // [Pa] median of the neighbours
};

/// What makes a value a spike: it is off the median m of its neighbours, three above and three below, by more
/// than six standard deviations, while the readings next to it are not. The standard deviation is 1.4826
/// times the median of |neighbour - m| (a Hampel filter), or the same of the whole sounding if that is more.
/// It must also be off by a tenth of |m|, and by `least` [Pa], below which sensors count in steps.
struct SpikeRule {
  int neighbours = 3;       // on each side
  double deviations = 6.0;  // [-]
  double share = 0.1;       // [-] of |m|
};

/// Spikes of q_c, f_s and u_2 in order of depth. Readings after a stop are no spikes and no neighbours:
/// resistance and pore pressure start anew there. Voids are left out.
[[nodiscard]] std::vector<Spike> spikes(const Recording& recording, const SpikeRule& rule = {});

}  // namespace cpt::recordings

// Where a realization's process finds the socket to its parent.
#pragma once

namespace cpt::campaign {

inline constexpr int channel_descriptor = 3;

}  // namespace cpt::campaign

// Sand and clay mixed where they meet.
//
// Over `thickness`, half of it to either side of an interface, the share of one soil goes linearly from 1 to
// 0. A material point is one soil or the other; which one is drawn from its number, the same for every run.
#pragma once

#include <cstdint>

namespace cpt::solver {

struct InterfaceMixing {
  double thickness = 0.0;  // [m]

  [[nodiscard]] bool on() const { return thickness != 0.0; }
  /// True if the point of this number, `distance` [m] below an interface, belongs to the soil above it.
  [[nodiscard]] bool upper_soil(double distance, std::uint64_t id) const;
};

}  // namespace cpt::solver

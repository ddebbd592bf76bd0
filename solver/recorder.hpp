// q_c and f_s over depth: impulses divided by the time spent in each depth bin.
#pragma once

#include <vector>

#include "solver/penetrometer.hpp"
#include "solver/simulate.hpp"

namespace cpt::solver {

class Recorder {
 public:
  Recorder(double bin_height, double final_depth, double projected_area);

  /// Adds a step during which the tip was at this depth [m].
  void add(double depth, const PenetrometerLoad& load, double dt);

  /// The bins that the tip passed, in order of depth.
  [[nodiscard]] DepthProfile profile() const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive("bins.time", time_);
    archive("bins.cone_impulse", cone_impulse_);
    archive("bins.friction", friction_);
  }

 private:
  double bin_height_, projected_area_;
  std::vector<double> time_, cone_impulse_, friction_;
};

}  // namespace cpt::solver

// The channels over depth: impulses divided by the time spent in each depth bin.
#pragma once

#include <string>
#include <vector>

#include "solver/channels.hpp"

namespace cpt::solver {

class Recorder {
 public:
  Recorder(double bin_height, double final_depth, double projected_area);

  /// Adds a step during which the tip was at this depth [m].
  void add(double depth, const StepLoads& loads, double dt);

  /// The bins that the tip passed, in order of depth.
  [[nodiscard]] DepthProfile profile() const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive("bins.time", time_);
    for (std::size_t k = 0; k < impulse_.size(); ++k)
      archive("bins." + std::string(channels()[k].name), impulse_[k]);
  }

 private:
  double bin_height_, projected_area_;
  std::vector<double> time_;                  // [s] of each bin
  std::vector<std::vector<double>> impulse_;  // of each channel and bin, what is measured times time
};

}  // namespace cpt::solver

// Follows chosen material points and the stresses at the wall through a push.
#pragma once

#include <cstdint>
#include <vector>

#include "results/push/histories.hpp"
#include "results/push/point_quantities.hpp"
#include "solver/point_states.hpp"

namespace cpt::results {

class HistoryRecorder {
 public:
  /// Chooses the points from the state at the start of the push. Surcharge is not followed.
  HistoryRecorder(const std::vector<Place>& track, const std::vector<DepthInterval>& wall_between,
                  const std::vector<solver::PointState>& start, const solver::Setup& setup);

  /// Adds a row for the tip at this depth [m].
  void add(double tip_depth, const solver::MaterialPoints& points);

  /// The rows so far: tip_depth, points and walls are filled.
  [[nodiscard]] const Histories& histories() const { return histories_; }

 private:
  Histories histories_;
  std::vector<PointQuantity> quantities_;
  std::vector<solver::PointState> start_;  // of the tracked points
  std::vector<std::int64_t> ids_;          // the tracked points, then those of each wall interval
};

}  // namespace cpt::results

// Watches one push: writes fields at chosen depths, gathers histories, keeps the first and the last state.
#pragma once

#include <exception>
#include <optional>
#include <vector>

#include "results/push/field_series.hpp"
#include "results/push/history_recorder.hpp"
#include "solver/setup.hpp"
#include "solver/simulate.hpp"

namespace cpt::results {

/// What to record of a push.
struct PushRequest {
  std::vector<double> fields_at;  // [m] depths of the tip, rising; those above the start mean the start
  std::vector<Place> track;       ///< material points to follow
  std::vector<DepthInterval> wall_between;  ///< where to average the stresses at the wall
};

/// Histories get a row at the start and at the end of each depth bin of the q_c profile.
class PushRecorder : public solver::Observer {
 public:
  /// `fields` is written to during the push and must outlive the recorder.
  PushRecorder(PushRequest request, const solver::Setup& setup, FieldSeries& fields);

  [[nodiscard]] double next_look() const override;
  void look(double depth, const solver::MaterialPoints& points) override;
  /// Ends a push whose fields cannot be written.
  bool stop_requested(std::string& reason) override;

  /// Throws what ended the recording, if something did.
  void rethrow() const;
  /// All rows so far, and the soil at the final depth.
  [[nodiscard]] Histories histories() const;
  /// Material points before the push, and at its final depth (empty if it did not get there).
  [[nodiscard]] const std::vector<solver::PointState>& start() const { return start_; }
  [[nodiscard]] const std::vector<solver::PointState>& end() const { return end_; }

 private:
  void record(double depth, const solver::MaterialPoints& points);

  PushRequest request_;
  solver::Setup setup_;
  double bin_height_, final_depth_;  // [m]
  FieldSeries& fields_;
  std::optional<HistoryRecorder> history_;
  std::vector<solver::PointState> start_, end_;
  std::size_t next_field_ = 0;
  std::int64_t next_bin_ = 0;  // whose end is the next row of the histories
  std::exception_ptr failure_;
};

}  // namespace cpt::results

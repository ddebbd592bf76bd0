#include "results/push/push_recorder.hpp"

#include <algorithm>
#include <limits>

namespace cpt::results {

PushRecorder::PushRecorder(PushRequest request, const solver::Setup& setup, FieldSeries& fields)
    : request_(std::move(request)),
      setup_(setup),
      bin_height_(setup.numerics.bin_height),
      final_depth_(setup.penetrometer.final_depth),
      fields_(fields) {}

double PushRecorder::next_look() const {
  if (!end_.empty() || failure_) return std::numeric_limits<double>::infinity();
  if (start_.empty()) return 0.0;
  double next = final_depth_;
  if (next_field_ < request_.fields_at.size()) next = std::min(next, request_.fields_at[next_field_]);
  if (history_) next = std::min(next, static_cast<double>(next_bin_ + 1) * bin_height_);
  return next;
}

// Nothing may be thrown into the time loop, which takes it for a breakdown of the physics.
void PushRecorder::look(double depth, const solver::MaterialPoints& points) {
  try {
    record(depth, points);
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void PushRecorder::record(double depth, const solver::MaterialPoints& points) {
  const bool first = start_.empty(), last = depth >= final_depth_;
  if (first) {
    start_ = solver::point_states(points);
    if (!request_.track.empty() || !request_.wall_between.empty())
      history_.emplace(request_.track, request_.wall_between, start_, setup_);
  }
  if (history_ && (first || last || depth >= static_cast<double>(next_bin_ + 1) * bin_height_)) {
    history_->add(depth, points);
    next_bin_ = std::max(next_bin_ + 1, static_cast<std::int64_t>(depth / bin_height_));
  }
  const auto field_due = [&] {
    return next_field_ < request_.fields_at.size() && depth >= request_.fields_at[next_field_];
  };
  if (!last && !field_due()) return;
  std::vector<solver::PointState> now = solver::point_states(points);
  for (; field_due(); ++next_field_) fields_.add(request_.fields_at[next_field_], depth, now, start_);
  if (last) end_ = std::move(now);
}

bool PushRecorder::stop_requested(std::string& reason) {
  if (failure_) reason = "the recording failed";
  return failure_ != nullptr;
}

void PushRecorder::rethrow() const {
  if (failure_) std::rethrow_exception(failure_);
}

Histories PushRecorder::histories() const {
  Histories histories = history_ ? history_->histories() : Histories{};
  histories.end = soil_at_end(start_, end_);
  return histories;
}

}  // namespace cpt::results

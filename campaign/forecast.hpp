// Remaining time and speed of a campaign, from finished wall times and the progress of what runs. Pure: the
// time is an argument.
#pragma once

#include <deque>
#include <map>
#include <optional>

namespace cpt::campaign {

class Forecast {
 public:
  void started(int realization, int threads, double now);
  /// `fraction` of the push done, in [0, 1]; `point_steps` = steps x material points so far.
  void progressed(int realization, double fraction, double point_steps, double now);
  /// A realization ended; only a completed one teaches how long others take.
  void ended(int realization, bool completed, double point_steps, double now);
  /// A realization is to start again from nothing.
  void restarted(int realization);

  /// [s] until `pending` more realizations and those running are done on `slots` cores; nullopt while nothing
  /// is known.
  [[nodiscard]] std::optional<double> remaining_seconds(int pending, int slots, double now) const;
  /// [1/s] material-point steps per second over the last seconds.
  [[nodiscard]] double point_steps_per_second(double now) const;

 private:
  struct Running {
    double since;
    int threads;
    double fraction = 0.0;
    double point_steps = 0.0;
  };
  struct Sample {
    double time;
    double point_steps;
  };
  void sample(double now);
  [[nodiscard]] std::optional<double> core_seconds_each(double now) const;

  std::map<int, Running> running_;
  double finished_core_seconds_ = 0.0;
  int finished_ = 0;
  double total_point_steps_ = 0.0;
  std::deque<Sample> samples_;
};

}  // namespace cpt::campaign

#include "recordings/behaviour_intervals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>

namespace cpt::recordings {
namespace {

constexpr std::size_t no_run = static_cast<std::size_t>(-1);

// A run of readings, in a chain of runs.
struct Run {
  std::size_t first = 0, last = 0;  // readings
  int zone = 0;
  double sum_of_I_c = 0.0;
  int with_I_c = 0;
  std::size_t above = no_run, below = no_run;  // runs
  bool gone = false;
};

class Intervals {
 public:
  Intervals(const BehaviourProfile& profile, double least) : profile_(profile), least_(least) {}

  std::vector<BehaviourInterval> find() {
    make_runs();
    for (std::size_t i = 0; i < runs_.size(); ++i) watch(i);
    while (!thin_.empty()) {
      const auto [thickness, index, last] = thin_.top();
      thin_.pop();
      // It may have grown or gone since.
      if (runs_[index].gone || runs_[index].last != last || thickness != thickness_of(runs_[index])) continue;
      if (const std::size_t into = nearer(runs_[index]); into != no_run) join(index, into);
    }
    std::vector<BehaviourInterval> intervals;
    std::vector<Run> kept;
    for (const Run& run : runs_)
      if (!run.gone) kept.push_back(run);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (i > 0 && main_zone(kept[i - 1]) == main_zone(kept[i])) {
        kept[i].first = kept[i - 1].first;
        intervals.pop_back();
      }
      intervals.push_back(interval_of(kept[i]));
    }
    std::erase_if(intervals, [](const BehaviourInterval& interval) { return interval.zone == 0; });
    return intervals;
  }

 private:
  using Thin = std::tuple<double, std::size_t, std::size_t>;  // thickness, run, its last reading

  void make_runs() {
    for (std::size_t i = 0; i < profile_.depth.size(); ++i) {
      const Behaviour& b = profile_.behaviour[i];
      if (runs_.empty() || runs_.back().zone != b.zone) {
        Run run;
        run.first = i;
        run.zone = b.zone;
        run.above = runs_.empty() ? no_run : runs_.size() - 1;
        if (!runs_.empty()) runs_.back().below = runs_.size();
        runs_.push_back(run);
      }
      Run& run = runs_.back();
      run.last = i;
      if (std::isnan(b.I_c)) continue;
      run.sum_of_I_c += b.I_c;
      ++run.with_I_c;
    }
  }

  // Half way to the next reading.
  [[nodiscard]] double top(const Run& run) const {
    return run.first == 0 ? profile_.depth.front()
                          : 0.5 * (profile_.depth[run.first - 1] + profile_.depth[run.first]);
  }
  [[nodiscard]] double bottom(const Run& run) const {
    return run.last + 1 == profile_.depth.size()
               ? profile_.depth.back()
               : 0.5 * (profile_.depth[run.last] + profile_.depth[run.last + 1]);
  }
  [[nodiscard]] double thickness_of(const Run& run) const { return bottom(run) - top(run); }

  void watch(std::size_t index) {
    const double thickness = thickness_of(runs_[index]);
    if (thickness < least_) thin_.emplace(thickness, index, runs_[index].last);
  }

  /// The neighbour that a run joins.
  [[nodiscard]] std::size_t nearer(const Run& run) const {
    if (run.above == no_run || run.below == no_run) return run.above == no_run ? run.below : run.above;
    const auto mean = [](const Run& r) { return r.with_I_c > 0 ? r.sum_of_I_c / r.with_I_c : not_given; };
    const double to_above = std::abs(mean(run) - mean(runs_[run.above]));
    const double to_below = std::abs(mean(run) - mean(runs_[run.below]));
    return to_below < to_above || std::isnan(to_above) ? run.below : run.above;
  }

  void join(std::size_t index, std::size_t into) {
    absorb(into, index);
    // What the vanished run kept apart may now be one.
    for (const std::size_t next : {runs_[into].above, runs_[into].below})
      if (next != no_run && runs_[next].zone == runs_[into].zone) absorb(into, next);
    watch(into);
  }

  void absorb(std::size_t into, std::size_t index) {
    Run& grown = runs_[into];
    Run& lost = runs_[index];
    lost.gone = true;
    grown.first = std::min(grown.first, lost.first);
    grown.last = std::max(grown.last, lost.last);
    grown.sum_of_I_c += lost.sum_of_I_c;
    grown.with_I_c += lost.with_I_c;
    if (lost.above != no_run) runs_[lost.above].below = lost.below;
    if (lost.below != no_run) runs_[lost.below].above = lost.above;
    if (grown.above == index) grown.above = lost.above;
    if (grown.below == index) grown.below = lost.below;
  }

  [[nodiscard]] std::array<int, 10> zones_in(const Run& run) const {
    std::array<int, 10> counts{};
    for (std::size_t i = run.first; i <= run.last; ++i)
      ++counts[static_cast<std::size_t>(profile_.behaviour[i].zone)];
    return counts;
  }

  /// That most of the readings have; 0 where most have none.
  [[nodiscard]] int main_zone(const Run& run) const {
    const auto counts = zones_in(run);
    return static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  }

  [[nodiscard]] BehaviourInterval interval_of(const Run& run) const {
    std::vector<double> q_t, R_f, I_c;
    for (std::size_t i = run.first; i <= run.last; ++i) {
      if (profile_.behaviour[i].zone == 0) continue;
      q_t.push_back(profile_.q_t[i]);
      R_f.push_back(profile_.R_f[i]);
      I_c.push_back(profile_.behaviour[i].I_c);
    }
    const int zone = main_zone(run);
    return {top(run),
            bottom(run),
            zone,
            static_cast<int>(q_t.size()),
            zones_in(run)[static_cast<std::size_t>(zone)],
            spread(q_t).median,
            spread(R_f).median,
            spread(I_c).median};
  }

  const BehaviourProfile& profile_;
  double least_;
  std::vector<Run> runs_;
  std::priority_queue<Thin, std::vector<Thin>, std::greater<>> thin_;
};

}  // namespace

std::vector<BehaviourInterval> behaviour_intervals(const BehaviourProfile& profile, double least) {
  return Intervals(profile, least).find();
}

}  // namespace cpt::recordings

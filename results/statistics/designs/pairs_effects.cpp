#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "parameters/designs/pairs.hpp"
#include "parameters/designs/variation.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {
namespace {

// Why there is no interval from them.
std::string without_repeats(const Snapshot& s) {
  const auto is_repeat = [](const RealizationRow& run) { return run.side == "repeat"; };
  if (std::ranges::none_of(s.realizations, is_repeat)) return "no interval: the study has no repeats";
  const bool waiting = std::ranges::any_of(
      s.realizations, [&](const RealizationRow& run) { return is_repeat(run) && run.waiting(); });
  return waiting ? "no interval until the repeats have run" : "no interval: too few repeats completed";
}

// An interval from some of them is not the one to come.
std::string some_repeats(const Snapshot& s) {
  const std::string so_far = repeats_so_far(s);
  return so_far.empty() ? "" : "interval of " + so_far;
}

}  // namespace

void add_pairs_effects(WindowEffects& w) {
  const auto noise = std::ranges::find_if(w.snapshot.repeat_noise,
                                          [&](const auto& row) { return row.window == w.window.name; });
  const bool repeated = noise != w.snapshot.repeat_noise.end();
  const double scatter =
      repeated ? noise->si_half_width / std::sqrt(2.0) : parameters::undefined;  // t s / mean
  const auto pairs = parameters::pairs_of(parameters::width_of(w.study.design));
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto y = w.y.segment<4>(4 * static_cast<Eigen::Index>(k));
    const parameters::Estimate both =
        w.constant ? parameters::Estimate()
                   : parameters::interaction_estimate({y(0), y(1), y(2), y(3)}, scatter);
    const int used = static_cast<int>(y.array().isFinite().count());
    const Runs runs = w.runs.subspan(4 * k, 4);
    const std::string gap = w.window.problem.empty() ? missing_runs(runs) : w.window.problem;
    std::string note = gap.empty() ? "" : "undefined: " + gap;
    if (w.constant) note = parameters::does_not_vary;
    if (note.empty()) note = repeated ? some_repeats(w.snapshot) : without_repeats(w.snapshot);
    if (const std::string lies = runs_out_of_line(runs); !lies.empty())
      note += (note.empty() ? "" : "; ") + lies;
    w.rows.push_back({w.window.name, w.name(static_cast<std::size_t>(pairs[k].first)),
                      w.name(static_cast<std::size_t>(pairs[k].second)), "interaction", w.window.unit(),
                      both.value, both.lower, both.upper, used, 4 - used, std::move(note),
                      "second difference, interval from repeats", used});
  }
}

}  // namespace cpt::results

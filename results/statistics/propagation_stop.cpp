#include "results/statistics/propagation_stop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "parameters/all_realizations.hpp"
#include "parameters/designs/design.hpp"
#include "parameters/designs/propagation.hpp"

namespace cpt::results {

using Eigen::Index;
using Eigen::VectorXd;

std::optional<std::size_t> runs_that_suffice(const parameters::Study& study, const Snapshot& snapshot,
                                             Runs runs) {
  const parameters::Design& design = study.design;
  if (!design.until) return std::nullopt;
  const auto waits = [](const RealizationRow* run) { return run == nullptr || !run->ended(); };
  const auto ended = std::ranges::find_if(runs, waits) - runs.begin();
  std::vector<VectorXd> averages;
  std::vector<EffectRow> unused;
  for (const WindowRow& window : snapshot.windows)
    if (window.problem.empty()) averages.push_back(WindowEffects(study, snapshot, window, runs, unused).y);
  if (averages.empty()) return std::nullopt;
  for (Index count = parameters::first_look; count <= ended; count += parameters::look_interval)
    if (std::ranges::all_of(averages, [&](const VectorXd& y) {
          return parameters::suffices(*design.until, y, count, design.latin, design.numerical_error.front());
        }))
      return static_cast<std::size_t>(count);
  return std::nullopt;
}

std::vector<int> ids_beyond(const parameters::Study& study, std::size_t enough) {
  const auto realizations = parameters::all_realizations(study);
  const auto runs = parameters::design_realizations(study, realizations);
  const std::set<std::size_t> taken(runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(enough));
  std::vector<int> beyond;
  const auto first = static_cast<int>(study.design.first_point);
  const auto end = first + static_cast<int>(study.design.points);
  for (std::size_t k = 0; k < realizations.size(); ++k)
    if (realizations[k].point >= first && realizations[k].point < end && !taken.contains(k))
      beyond.push_back(realizations[k].id);
  return beyond;
}

std::string stop_words(const parameters::Study& study, std::optional<std::size_t> enough) {
  if (!study.design.until) return "";
  const parameters::StopRule& rule = *study.design.until;
  const std::string number =
      std::isnan(rule.quantile) ? "mean" : fmt::format("{:g} % quantile", 100.0 * rule.quantile);
  const auto runs = static_cast<std::size_t>(parameters::run_count(study.design));
  if (!enough)
    return fmt::format("the {} is not yet known to ± {:g} % in every window", number,
                       100.0 * rule.half_width);
  return fmt::format("the {} is known to ± {:g} % in every window after {} runs{}", number,
                     100.0 * rule.half_width, *enough,
                     *enough < runs ? fmt::format(": {} of the design are not needed", runs - *enough) : "");
}

}  // namespace cpt::results

#include "validation/numerics/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "parameters/all_realizations.hpp"
#include "parameters/designs/variation.hpp"
#include "parameters/read_study.hpp"
#include "results/statistics/sensitivity.hpp"

namespace cpt::validation::numerics {
namespace {

constexpr std::string_view point_shift = "numerics.point_shift";

bool is_numerical(const solver::Quantity& quantity) {
  return quantity.name.starts_with("numerics.") || quantity.name == "penetrometer.speed_m_per_s";
}

parameters::Study study_of(const results::Snapshot& campaign, const std::filesystem::path& database) {
  auto study = parameters::parse_study(campaign.campaign.study_text, database);
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&study))
    throw results::Error(fmt::format("the study that {} holds cannot be read: {}", database.string(),
                                     parameters::format(*errors)));
  return std::get<parameters::Study>(std::move(study));
}

// What the realization changes if that is one thing.
std::optional<parameters::Change> only_change(const parameters::Study& study,
                                              const parameters::Realization& realization) {
  if (realization.row >= 0)
    return parameters::Change{study.rows[static_cast<std::size_t>(realization.row)].quantity,
                              parameters::parameter_value(study, realization)};
  if (realization.point < 0) return std::nullopt;
  const auto& changes = study.points[static_cast<std::size_t>(realization.point)].changes;
  return changes.size() == 1 ? std::optional(changes.front()) : std::nullopt;
}

const results::WindowMeanRow* mean_row(const results::Snapshot& campaign, int realization,
                                       std::string_view window) {
  for (const results::WindowMeanRow& mean : campaign.window_means)
    if (mean.realization == realization && mean.window == window) return &mean;
  return nullptr;
}

}  // namespace

NumericsStudy read_numerics(const std::filesystem::path& database) {
  return read_numerics(results::read_snapshot(database), database);
}

NumericsStudy read_numerics(results::Snapshot campaign, const std::filesystem::path& database) {
  NumericsStudy found{std::move(campaign), {}, {}};
  const parameters::Study study = study_of(found.campaign, database);
  const auto realizations = parameters::all_realizations(study);
  const int baseline = realizations.front().id;
  found.repeats.push_back(baseline);

  for (const solver::Quantity& quantity : solver::all_quantities()) {
    if (!is_numerical(quantity)) continue;
    const double at_baseline = quantity.value(study.baseline);
    Setting setting{&quantity, at_baseline, {{at_baseline, baseline}}};
    for (const parameters::Realization& realization : realizations) {
      const auto change = only_change(study, realization);
      if (!change || change->quantity != &quantity) continue;
      if (quantity.name == point_shift)
        found.repeats.push_back(realization.id);
      else if (change->value != at_baseline)
        setting.runs.push_back({change->value, realization.id});
    }
    if (setting.runs.size() < 2) continue;
    std::sort(setting.runs.begin(), setting.runs.end(),
              [](const Run& a, const Run& b) { return a.value < b.value; });
    found.settings.push_back(std::move(setting));
  }
  // The model's resolution first, then what it is pushed with.
  std::stable_partition(found.settings.begin(), found.settings.end(), [](const Setting& setting) {
    return setting.quantity->name.starts_with("numerics.");
  });
  return found;
}

const results::RealizationRow* run_row(const results::Snapshot& campaign, int realization) {
  for (const results::RealizationRow& row : campaign.realizations)
    if (row.id == realization) return &row;
  return nullptr;
}

std::optional<double> mean_in(const results::Snapshot& campaign, int realization, std::string_view window,
                              std::size_t channel) {
  const results::WindowMeanRow* row = mean_row(campaign, realization, window);
  if (row == nullptr) return std::nullopt;
  const double mean = channel == tip_resistance ? row->q_c_mean_kPa : row->other_means_kPa[channel - 1];
  return std::isnan(mean) ? std::nullopt : std::optional(mean);
}

std::optional<double> noise_in(const results::Snapshot& campaign, int realization, std::string_view window) {
  const results::WindowMeanRow* mean = mean_row(campaign, realization, window);
  return mean == nullptr ? std::nullopt
                         : std::optional(results::noise_index(mean->q_c_min_kPa, mean->q_c_max_kPa));
}

std::optional<results::RepeatNoise> repeats_in(const NumericsStudy& study, std::string_view window,
                                               std::size_t channel) {
  std::vector<double> means;
  for (const int realization : study.repeats)
    if (const auto mean = mean_in(study.campaign, realization, window, channel)) means.push_back(*mean);
  return results::repeat_noise(means);
}

std::optional<double> reference_in(const NumericsStudy& study, std::string_view window, std::size_t channel) {
  const auto repeats = repeats_in(study, window, channel);
  return repeats ? std::optional(repeats->mean)
                 : mean_in(study.campaign, study.repeats.front(), window, channel);
}

bool told_from_repeats(double q_c, double reference, const std::optional<results::RepeatNoise>& repeats) {
  return repeats && parameters::differ(q_c, reference) &&
         std::abs(q_c - reference) > results::prediction_half_width(*repeats);
}

std::optional<Run> most_accurate(const results::Snapshot& campaign, const Setting& setting) {
  const bool more_is_better =
      setting.quantity->name == refinement || setting.quantity->name == "numerics.point_density";
  std::optional<Run> best;
  for (const Run& run : setting.runs) {
    const results::RealizationRow* row = run_row(campaign, run.realization);
    if (row != nullptr && row->completed() && (more_is_better || !best)) best = run;
  }
  return best;
}

}  // namespace cpt::validation::numerics

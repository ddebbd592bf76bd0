#include "validation/paper/studies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "reports/labels.hpp"

namespace cpt::validation::paper {
namespace {

using reports::baseline_run, reports::bound_run, reports::symbol_of;

template <class Row>
const Row* find_named(const std::vector<Row>& rows, std::string_view name) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

std::string why_not(const results::RealizationRow* run) {
  if (run == nullptr) return "there is no such realization";
  if (run->waiting()) return fmt::format("realization {} has not been run", run->id);
  if (run->failed()) return fmt::format("realization {} failed ({}: {})", run->id, run->status, run->reason);
  return fmt::format("realization {} has no q_c in the window", run->id);
}

}  // namespace

std::vector<std::string_view> study_names() {
  return {
      sand_study,           clay_study,        layered_study,        flexible_study, dense_rigid_study,
      dense_flexible_study, second_push_study, image_pressure_study, at_rest_study,  at_rest_flexible_study};
}

Studies read_studies(const std::filesystem::path& folder) {
  Studies studies;
  std::error_code ignored;
  for (const std::string_view name : study_names()) {
    const std::filesystem::path database = folder / (std::string(name) + ".sqlite");
    if (std::filesystem::is_regular_file(database, ignored))
      studies.emplace(std::string(name), results::read_snapshot(database));
  }
  if (studies.empty())
    throw results::Error(fmt::format("{} holds none of {}.sqlite; scripts/reproduce-paper makes them",
                                     folder.string(), fmt::join(study_names(), ".sqlite, ")));
  return studies;
}

std::string presets_of(const Studies& studies) {
  std::set<std::string> presets;
  for (const auto& [name, study] : studies) presets.insert(study.campaign.preset);
  return fmt::format("{}", fmt::join(presets, " and "));
}

StudyView::StudyView(const Studies& studies, std::string_view name) : name_(name) {
  const auto found = studies.find(name);
  snapshot_ = found == studies.end() ? nullptr : &found->second;
}

Value missing_value(std::string why) { return {std::numeric_limits<double>::quiet_NaN(), std::move(why)}; }

Value StudyView::missing(std::string why) const {
  return missing_value(snapshot_ == nullptr ? name_ + " has not been run"
                                            : fmt::format("{}: {}", name_, why));
}

const results::WindowRow* StudyView::window(std::string_view name) const {
  return snapshot_ == nullptr ? nullptr : find_named(snapshot_->windows, name);
}

const results::SensitivityRow* StudyView::row(std::string_view window, std::string_view parameter) const {
  if (snapshot_ == nullptr) return nullptr;
  for (const results::SensitivityRow& row : snapshot_->sensitivity)
    if (row.window == window && row.parameter == parameter) return &row;
  return nullptr;
}

Value StudyView::q_c(std::string_view window, std::string_view parameter, Bound bound) const {
  if (snapshot_ == nullptr) return missing({});
  const results::RealizationRow* run = baseline_run(*snapshot_);
  if (bound != Bound::baseline) {
    if (this->parameter(parameter) == nullptr) return missing(fmt::format("has no row {}", parameter));
    // A bound without a realization of its own equals the baseline.
    const auto* own = bound_run(*snapshot_, parameter, bound == Bound::lower ? "lower" : "upper");
    if (own != nullptr) run = own;
  }
  for (const results::WindowMeanRow& mean : snapshot_->window_means)
    if (run != nullptr && mean.realization == run->id && mean.window == window)
      return {mean.q_c_mean_kPa, {}};
  if (this->window(window) == nullptr) return missing(fmt::format("has no window {}", window));
  return missing(why_not(run));
}

Value StudyView::index(std::string_view window, std::string_view parameter) const {
  const results::SensitivityRow* found = row(window, parameter);
  if (found == nullptr) return missing(fmt::format("has no row {} or no window {}", parameter, window));
  if (!std::isfinite(found->si)) return missing(found->note);
  return {found->si, {}};
}

Value StudyView::noise(std::string_view window) const {
  if (const Value q = baseline(window); !q) return q;
  const results::RealizationRow* run = baseline_run(*snapshot_);
  for (const results::WindowMeanRow& mean : snapshot_->window_means)
    if (mean.realization == run->id && mean.window == window && mean.q_c_max_kPa > 0.0)
      return {(mean.q_c_max_kPa - mean.q_c_min_kPa) / mean.q_c_max_kPa, {}};
  return missing("q_c of the baseline is not positive");
}

const results::ParameterRow* StudyView::parameter(std::string_view name) const {
  return snapshot_ == nullptr ? nullptr : find_named(snapshot_->parameters, name);
}

std::string StudyView::symbol(std::string_view parameter) const {
  const results::ParameterRow* row = this->parameter(parameter);
  return row == nullptr ? std::string(parameter) : html(symbol_of(*snapshot_, *row));
}

}  // namespace cpt::validation::paper

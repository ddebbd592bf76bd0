#include "diagnosis/run_curves.hpp"

#include <algorithm>
#include <stdexcept>

#include "solver/mechanisms/reading.hpp"

namespace cpt::diagnosis {
namespace {

constexpr double least_reading = 1e3;  // [Pa]: logarithms of what a zero's offset leaves, of a sleeve at rest

}  // namespace

VectorXd channel_means(const SoundingGrid& grid, std::span<const double> depth, std::vector<double> values,
                       const solver::Channel& channel) {
  if (channel.name != "q_c")
    for (double& value : values) value = std::max(value, least_reading);  // NaN stays
  return log_cell_means(grid, depth, values);
}

RunCurves::RunCurves(const SoundingData& data, const SoundingGrid& grid, const ChannelList& measured)
    : data_(data),
      grid_(grid),
      measured_(measured),
      realizations_(parameters::all_realizations(data.study.study)) {}

std::optional<VectorXd> RunCurves::of(int id) const {
  const solver::DepthProfile* profile = profile_of(id);
  return profile != nullptr ? std::optional(means(*profile)) : std::nullopt;
}

std::optional<VectorXd> RunCurves::read_otherwise(int id,
                                                  const std::vector<parameters::Change>& changes) const {
  const solver::DepthProfile* profile = profile_of(id);
  if (profile == nullptr) return std::nullopt;
  solver::Setup setup = data_.study.study.baseline;
  for (const parameters::Change& change : changes)
    if (std::ranges::none_of(data_.request.changes, [&](const auto& known) {
          return known.quantity->name == change.quantity->name;
        }))
      change.quantity->set_value(setup, change.value);
  solver::DepthProfile read = solver::as_recorded(*profile, setup);
  for (double& q_c : read.q_c) q_c = std::max(q_c, least_reading);
  return means(read);
}

std::optional<VectorXd> RunCurves::of_row(int row, parameters::Side side) const {
  return of(parameters::realization_of(realizations_, row, side));
}

int RunCurves::id_of_point(std::size_t point) const {
  for (const parameters::Realization& realization : realizations_)
    if (realization.point == static_cast<int>(point)) return realization.id;
  throw std::logic_error("no such point");
}

const solver::DepthProfile* RunCurves::profile_of(int id) const {
  for (const results::RealizationRow& row : data_.campaign.realizations)
    if (row.id == id && !row.completed()) return nullptr;
  for (const results::CurveRow& curve : data_.campaign.curves)
    if (curve.realization == id) return &curve.profile;
  return nullptr;
}

VectorXd RunCurves::means(const solver::DepthProfile& profile) const {
  std::vector<VectorXd> channels;
  for (const solver::Channel* channel : measured_)
    channels.push_back(channel_means(grid_, profile.depth, profile.*channel->values, *channel));
  return concatenate(channels);
}

std::optional<VectorXd> joined_run(const std::vector<RunCurves>& soundings,
                                   const std::function<std::optional<VectorXd>(const RunCurves&)>& get) {
  std::vector<VectorXd> parts;
  for (const RunCurves& sounding : soundings) {
    const std::optional<VectorXd> part = get(sounding);
    if (!part) return std::nullopt;
    parts.push_back(*part);
  }
  return concatenate(parts);
}

}  // namespace cpt::diagnosis

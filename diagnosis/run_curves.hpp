// The finished curves of one sounding's campaign, as logarithms of cell means.
#pragma once

#include <functional>
#include <optional>

#include "diagnosis/assemble.hpp"
#include "parameters/all_realizations.hpp"

namespace cpt::diagnosis {

/// ln of the cell means of a channel. No q_c is none; other channels have zeros, and are 1 kPa there.
[[nodiscard]] VectorXd channel_means(const SoundingGrid& grid, std::span<const double> depth,
                                     std::vector<double> values, const solver::Channel& channel);

/// On the sounding's grid, channel behind channel (n). Looks at the data that it is made of.
class RunCurves {
 public:
  RunCurves(const SoundingData& data, const SoundingGrid& grid, const ChannelList& measured);

  /// Nothing if the realization did not complete.
  [[nodiscard]] std::optional<VectorXd> of(int id) const;
  /// The same as instruments would read it that `changes` tell of, but what is known of the sounding.
  [[nodiscard]] std::optional<VectorXd> read_otherwise(int id,
                                                       const std::vector<parameters::Change>& changes) const;
  [[nodiscard]] std::optional<VectorXd> of_row(int row, parameters::Side side) const;
  [[nodiscard]] int id_of_point(std::size_t point) const;
  [[nodiscard]] std::optional<VectorXd> of_point(std::size_t point) const { return of(id_of_point(point)); }
  [[nodiscard]] const SoundingData& sounding() const { return data_; }
  [[nodiscard]] int baseline_id() const { return realizations_.front().id; }
  [[nodiscard]] std::optional<VectorXd> baseline() const { return of(baseline_id()); }

 private:
  [[nodiscard]] const solver::DepthProfile* profile_of(int id) const;
  [[nodiscard]] VectorXd means(const solver::DepthProfile& profile) const;

  const SoundingData& data_;
  SoundingGrid grid_;
  const ChannelList& measured_;
  std::vector<parameters::Realization> realizations_;
};

/// The same run in all soundings end to end; nothing if one of them is missing.
[[nodiscard]] std::optional<VectorXd> joined_run(
    const std::vector<RunCurves>& soundings,
    const std::function<std::optional<VectorXd>(const RunCurves&)>& get);

}  // namespace cpt::diagnosis

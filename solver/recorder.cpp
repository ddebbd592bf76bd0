#include "solver/recorder.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::solver {

Recorder::Recorder(double bin_height, double final_depth, double projected_area)
    : bin_height_(bin_height), projected_area_(projected_area) {
  const auto bins = static_cast<std::size_t>(std::ceil(final_depth / bin_height)) + 1;
  time_.assign(bins, 0.0);
  impulse_.assign(channels().size(), std::vector<double>(bins, 0.0));
}

void Recorder::add(double depth, const StepLoads& loads, double dt) {
  const auto bin = std::min(static_cast<std::size_t>(depth / bin_height_), time_.size() - 1);
  time_[bin] += dt;
  for (std::size_t k = 0; k < impulse_.size(); ++k) impulse_[k][bin] += channels()[k].measured(loads) * dt;
}

DepthProfile Recorder::profile() const {
  DepthProfile profile;
  for (std::size_t bin = 0; bin < time_.size(); ++bin) {
    if (time_[bin] <= 0.0) continue;
    profile.depth.push_back((static_cast<double>(bin) + 0.5) * bin_height_);
    for (std::size_t k = 0; k < impulse_.size(); ++k) {
      const Channel& channel = channels()[k];
      const double mean = impulse_[k][bin] / time_[bin];
      (profile.*channel.values).push_back(channel.by_projected_area ? mean / projected_area_ : mean);
    }
  }
  return profile;
}

}  // namespace cpt::solver

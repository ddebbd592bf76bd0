#include "solver/recorder.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::solver {

Recorder::Recorder(double bin_height, double final_depth, double projected_area)
    : bin_height_(bin_height), projected_area_(projected_area) {
  const auto bins = static_cast<std::size_t>(std::ceil(final_depth / bin_height)) + 1;
  time_.assign(bins, 0.0);
  cone_impulse_.assign(bins, 0.0);
  friction_.assign(bins, 0.0);
}

void Recorder::add(double depth, const PenetrometerLoad& load, double dt) {
  const auto bin = std::min(static_cast<std::size_t>(depth / bin_height_), time_.size() - 1);
  time_[bin] += dt;
  cone_impulse_[bin] += load.cone_force * dt;
  if (load.sleeve_area > 0.0) friction_[bin] += load.sleeve_force / load.sleeve_area * dt;
}

DepthProfile Recorder::profile() const {
  DepthProfile profile;
  for (std::size_t bin = 0; bin < time_.size(); ++bin) {
    if (time_[bin] <= 0.0) continue;
    profile.depth.push_back((static_cast<double>(bin) + 0.5) * bin_height_);
    profile.q_c.push_back(cone_impulse_[bin] / time_[bin] / projected_area_);
    profile.f_s.push_back(friction_[bin] / time_[bin]);
  }
  return profile;
}

}  // namespace cpt::solver

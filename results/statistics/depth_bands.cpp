#include "results/statistics/depth_bands.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "parameters/designs/propagation.hpp"
#include "results/statistics/value_at_depth.hpp"
#include "solver/channels.hpp"

namespace cpt::results {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using solver::DepthProfile;

std::vector<double> common_depths(const std::vector<const DepthProfile*>& curves, std::size_t most) {
  const DepthProfile* finest = nullptr;
  for (const DepthProfile* curve : curves)
    if (curve != nullptr && (finest == nullptr || curve->depth.size() > finest->depth.size())) finest = curve;
  std::vector<double> depths;
  if (finest == nullptr) return depths;
  const std::size_t step = (finest->depth.size() + most - 1) / most;
  for (std::size_t k = 0; k < finest->depth.size(); k += step) depths.push_back(finest->depth[k]);
  return depths;
}

DepthBandRow row_of(std::string_view channel, double depth, const VectorXd& y, bool latin, double error) {
  DepthBandRow row{std::string(channel),
                   depth,
                   static_cast<int>((y.array() == y.array()).count()),
                   {},
                   std::numeric_limits<double>::quiet_NaN(),
                   {}};
  if (row.runs < 2) return row;
  row.mean = parameters::by_sections(
      y, 1, [](const VectorXd& of) { return of.mean(); }, latin);
  row.standard_deviation =
      parameters::by_sections(
          y, 2, [error](const VectorXd& of) { return parameters::sample_deviation(of, error); }, latin)
          .value;
  for (std::size_t k = 0; k < band_quantiles.size(); ++k)
    row.quantiles[k] = parameters::by_sections(
        y, 2, [=](const VectorXd& of) { return parameters::sample_quantile(of, band_quantiles[k], error); },
        latin);
  return row;
}

}  // namespace

std::vector<DepthBandRow> depth_bands(const parameters::Study& study, const Snapshot& snapshot, Runs runs,
                                      std::size_t most_depths) {
  std::map<int, const DepthProfile*> curve_of;
  for (const CurveRow& curve : snapshot.curves) curve_of[curve.realization] = &curve.profile;
  std::vector<const DepthProfile*> curves;
  for (const RealizationRow* run : runs)
    curves.push_back(run != nullptr && run->completed() && curve_of.contains(run->id) ? curve_of[run->id]
                                                                                      : nullptr);
  const std::vector<double> depths = common_depths(curves, most_depths);
  std::vector<DepthBandRow> rows;
  for (const solver::Channel& channel : solver::channels())
    for (const double depth : depths) {
      constexpr double kPa = 1e3;  // [Pa]
      VectorXd y(static_cast<Index>(curves.size()));
      for (std::size_t k = 0; k < curves.size(); ++k)
        y(static_cast<Index>(k)) =
            curves[k] == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                 : value_at_depth(curves[k]->depth, curves[k]->*channel.values, depth) / kPa;
      const auto number = static_cast<std::size_t>(&channel - solver::channels().data());
      DepthBandRow row =
          row_of(channel.name, depth, y, study.design.latin, study.design.numerical_error[number]);
      if (row.runs > 0) rows.push_back(std::move(row));
    }
  return rows;
}

std::vector<DepthBandRow> design_bands(const StoredDesign& design, const Snapshot& snapshot) {
  constexpr std::size_t most_depths = 500;
  if (!design.study || design.study->design.kind != "propagation") return {};
  return depth_bands(*design.study, snapshot, design.runs, most_depths);
}

}  // namespace cpt::results

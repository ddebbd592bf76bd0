#include "results/push/history_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cpt::results {
namespace {

using solver::PointState;

bool is_soil(const PointState& point) { return !point.surcharge; }

const PointState* nearest(const std::vector<PointState>& points, const Place& place) {
  const PointState* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const PointState& point : points) {
    const double distance = std::hypot(point.r - place.r, -point.z - place.depth);
    if (!is_soil(point) || distance >= least) continue;
    least = distance;
    best = &point;
  }
  if (best == nullptr) throw Error("there is no material point to follow");
  return best;
}

std::vector<PointState> beside_wall(const std::vector<PointState>& points, const DepthInterval& between) {
  double outermost = 0.0;
  for (const PointState& point : points)
    if (is_soil(point)) outermost = std::max(outermost, point.r);
  std::vector<PointState> chosen;
  for (const PointState& point : points)
    if (is_soil(point) && point.r > outermost - 1e-9 && -point.z >= between.from && -point.z <= between.to)
      chosen.push_back(point);
  if (chosen.empty()) chosen.push_back(*nearest(points, {outermost, 0.5 * (between.from + between.to)}));
  return chosen;
}

// "stress_rr", "p"
std::string column_name(const PointQuantity& quantity, std::size_t component) {
  if (quantity.components.empty()) return std::string(quantity.name);
  return fmt::format("{}_{}", quantity.name, quantity.components[component]);
}

void add_row(HistoryColumns& columns, const std::vector<PointQuantity>& quantities, const PointState& now,
             const PointState& start) {
  for (const PointQuantity& quantity : quantities)
    for (std::size_t c = 0; c < std::max<std::size_t>(1, quantity.components.size()); ++c) {
      HistoryColumn& column = columns[column_name(quantity, c)];
      column.unit = quantity.unit;
      column.values.push_back(quantity.value(now, start, c));
    }
}

}  // namespace

HistoryRecorder::HistoryRecorder(const std::vector<Place>& track,
                                 const std::vector<DepthInterval>& wall_between,
                                 const std::vector<PointState>& start, const solver::Setup& setup)
    : quantities_(point_quantities(setup)) {
  for (const Place& place : track) {
    const PointState& point = *nearest(start, place);
    histories_.points.push_back(
        {place, {point.r, -point.z}, point.id, material_name(setup, point.material), {}});
    start_.push_back(point);
    ids_.push_back(point.id);
  }
  for (const DepthInterval& between : wall_between) {
    const std::vector<PointState> chosen = beside_wall(start, between);
    histories_.walls.push_back(
        {between, static_cast<int>(chosen.size()), {{"sigma_r", {"Pa", {}}}, {"sigma_v", {"Pa", {}}}}});
    for (const PointState& point : chosen) ids_.push_back(point.id);
  }
}

void HistoryRecorder::add(double tip_depth, const solver::MaterialPoints& points) {
  const std::vector<PointState> now = solver::point_states(points, ids_);
  histories_.tip_depth.push_back(tip_depth);
  std::size_t next = 0;
  for (PointHistory& history : histories_.points) {
    add_row(history.columns, quantities_, now[next], start_[next]);
    ++next;
  }
  for (WallHistory& wall : histories_.walls) {
    double volume = 0.0, sigma_r = 0.0, sigma_v = 0.0;
    for (int i = 0; i < wall.points; ++i, ++next) {
      volume += now[next].volume;
      sigma_r -= now[next].s_rr * now[next].volume;
      sigma_v -= now[next].s_zz * now[next].volume;
    }
    wall.columns.at("sigma_r").values.push_back(sigma_r / volume);
    wall.columns.at("sigma_v").values.push_back(sigma_v / volume);
  }
}

}  // namespace cpt::results

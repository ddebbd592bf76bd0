#include "reports/view/raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cpt::reports::view {
namespace {

constexpr double width_over_size = 0.7;  // standard deviation of the Gaussian over the point's size
constexpr double least_width = 0.5;      // [pixels]
constexpr double reach = 2.6;            // standard deviations at which a point ends
// Weights of points on a square lattice sum up to 2 pi width_over_size^2 = 3.1: less than this is no soil.
constexpr float least_weight = 0.15F;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The pixels of one axis that a point reaches, and its weight in each.
struct Reach {
  int first = 0;
  std::vector<float> weights;

  void set(double at, double width, int count) {  // in pixels
    first = std::max(0, static_cast<int>(std::ceil(at - reach * width - 0.5)));
    const int last = std::min(count - 1, static_cast<int>(std::floor(at + reach * width - 0.5)));
    weights.resize(static_cast<std::size_t>(std::max(0, last - first + 1)));
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double away = (first + static_cast<double>(i) + 0.5 - at) / width;
      weights[i] = static_cast<float>(std::exp(-0.5 * away * away));
    }
  }
};

}  // namespace

Raster::Raster(const DrawnPoints& points, const Window& window, int columns, int rows)
    : columns_(columns), rows_(rows), fields_(points.fields.size()), soils_(points.soils) {
  sums_.assign((soils_ + 1) * (fields_ + 1),
               std::vector<float>(static_cast<std::size_t>(columns) * rows, 0.0F));
  const double across = columns / window.radius, down = rows / (window.bottom - window.top);
  Reach in_row, in_column;
  for (std::size_t k = 0; k < points.r.size(); ++k) {
    const double width_r = std::max(least_width, width_over_size * points.size[k] * across);
    const double width_z = std::max(least_width, width_over_size * points.size[k] * down);
    in_column.set((points.depth[k] - window.top) * down, width_z, rows);
    if (in_column.weights.empty()) continue;
    std::vector<float>* const sums = &sums_[points.material[k] * (fields_ + 1)];
    in_row.set(points.r[k] * across, width_r, columns);
    if (in_row.weights.empty()) continue;
    for (std::size_t j = 0; j < in_column.weights.size(); ++j) {
      const std::size_t start = pixel(in_row.first, in_column.first + static_cast<int>(j));
      for (std::size_t field = 0; field <= fields_; ++field) {
        const float factor =
            in_column.weights[j] * (field == 0 ? 1.0F : static_cast<float>(points.fields[field - 1][k]));
        float* const sum = sums[field].data() + start;
        for (std::size_t i = 0; i < in_row.weights.size(); ++i) sum[i] += factor * in_row.weights[i];
      }
    }
  }
}

std::optional<std::size_t> Raster::material(int column, int row) const {
  const std::size_t at = pixel(column, row);
  float total = 0.0F;
  std::size_t largest = 0;
  for (std::size_t m = 0; m <= soils_; ++m) {
    total += weight(m, at);
    if (weight(m, at) > weight(largest, at)) largest = m;
  }
  if (total < least_weight) return std::nullopt;
  return largest;
}

double Raster::value(std::size_t field, int column, int row) const {
  const auto found = material(column, row);
  if (!found) return nan;
  const std::size_t m = *found;
  const std::size_t at = pixel(column, row);
  return static_cast<double>(sums_[m * (fields_ + 1) + 1 + field][at]) / static_cast<double>(weight(m, at));
}

std::optional<std::pair<std::size_t, std::size_t>> Raster::soils(int column, int row) const {
  if (soils_ < 2) return std::nullopt;
  const std::size_t at = pixel(column, row);
  std::size_t first = 0, second = 1;
  if (weight(second, at) > weight(first, at)) std::swap(first, second);
  for (std::size_t m = 2; m < soils_; ++m)
    if (weight(m, at) > weight(first, at)) {
      second = first;
      first = m;
    } else if (weight(m, at) > weight(second, at)) {
      second = m;
    }
  return std::minmax(first, second);
}

double Raster::first_or_second(std::pair<std::size_t, std::size_t> soils, int column, int row) const {
  const std::size_t at = pixel(column, row);
  const float first = weight(soils.first, at), second = weight(soils.second, at);
  if (first + second < least_weight) return nan;
  return static_cast<double>((first - second) / (first + second));
}

}  // namespace cpt::reports::view

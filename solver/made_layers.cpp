#include "solver/made_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/actual_setup.hpp"
#include "solver/lengths.hpp"
#include "solver/point_grid.hpp"

namespace cpt::solver {
namespace {

constexpr double mm = 1.0e-3;  // [m]

// "16 mm", "5.3 mm"
std::string millimetres(double length) { return fmt::format("{:.3g} mm", length / mm); }

// Depth of the lower face of the deepest row whose middle lies above `depth`, as initial_state decides it:
// rows go upward from the bottom.
double face_above(const PointGrid& grid, double depth) {
  int low = 0, high = grid.rows;  // the first row that lies above the depth is among these
  while (low < high) {
    const int middle = (low + high) / 2;
    if (-grid.z(middle) < depth)
      high = middle;
    else
      low = middle + 1;
  }
  return low == grid.rows ? -grid.z(grid.rows - 1) - 0.5 * grid.dz : -grid.z(low) + 0.5 * grid.dz;
}

// Rows above the soil's top are the surcharge's.
double interface_at(const PointGrid& grid, double depth) { return std::max(0.0, face_above(grid, depth)); }

const MadeInterval& worst_of(const std::vector<MadeInterval>& zones) {
  return *std::ranges::max_element(zones, {}, &MadeInterval::deviation);
}

// "47.9 mm beyond r = 0.2 m"
std::string where(const MadeInterval& zone, double radius) {
  if (zone.outer >= radius) return fmt::format("beyond r = {:.3g} m", zone.inner);
  if (zone.inner == 0.0) return fmt::format("up to r = {:.3g} m", zone.outer);
  return fmt::format("between r = {:.3g} and {:.3g} m", zone.inner, zone.outer);
}

// "is 12.1 mm thick between r = 0.08 and 0.2 m", or where it lies if its interface is farther off.
std::string deviation_of(const MadeInterval& zone, double radius, std::string_view is,
                         std::string_view lies) {
  const bool none = zone.made() < length_rounding;
  if (none || std::abs(zone.made() - zone.asked()) >= (zone.deviation() - length_rounding) * zone.asked())
    return fmt::format("{} {} thick {}", is, millimetres(none ? 0.0 : zone.made()), where(zone, radius));
  return fmt::format("{} from {:.4g} to {:.4g} m {}", lies, zone.made_top, zone.made_bottom,
                     where(zone, radius));
}

std::vector<std::vector<MadeInterval>> by_layer(const std::vector<MadeInterval>& made, std::size_t zones) {
  std::vector<std::vector<MadeInterval>> layers;
  for (std::size_t k = 0; k < made.size(); k += zones)
    layers.emplace_back(made.begin() + static_cast<std::ptrdiff_t>(k),
                        made.begin() + static_cast<std::ptrdiff_t>(k + zones));
  return layers;
}

}  // namespace

double MadeInterval::deviation() const {
  const double off =
      std::max({std::abs(made() - asked()), std::abs(made_top - top), std::abs(made_bottom - bottom)});
  return off / asked();
}

std::vector<MadeInterval> made_layers(const Setup& setup) {
  const Setup actual = actual_setup(setup);
  std::vector<MadeInterval> made;
  if (actual.layers.size() < 2) return made;
  const std::vector<PointGrid> grids = point_grids(actual);
  for (std::size_t k = 0; k < actual.layers.size(); ++k) {
    const Layer& layer = actual.layers[k];
    const bool first = k == 0, last = k + 1 == actual.layers.size();
    for (const PointGrid& grid : grids)
      made.push_back({grid.inner, grid.outer, grid.dz, layer.top, layer.bottom,
                      first ? layer.top : interface_at(grid, layer.top),
                      last ? layer.bottom : interface_at(grid, layer.bottom)});
  }
  return made;
}

std::vector<MadeInterval> made_lens(const Setup& setup) {
  std::vector<MadeInterval> made;
  const DensityLens& lens = setup.mechanisms.density_lens;
  const double top = std::max(0.0, lens.centre - 0.5 * lens.thickness);
  const double bottom = std::min(setup.chamber.soil_height, lens.centre + 0.5 * lens.thickness);
  if (lens.change == 0.0 || !(bottom > top)) return made;
  for (const PointGrid& grid : point_grids(actual_setup(setup)))
    made.push_back({grid.inner, grid.outer, grid.dz, top, bottom, top > 0.0 ? interface_at(grid, top) : 0.0,
                    bottom < setup.chamber.soil_height ? interface_at(grid, bottom) : bottom});
  return made;
}

LeastThickness least_thickness(const Setup& setup, double deviation) {
  LeastThickness least{setup.numerics.near_height / setup.numerics.refinement, 0.0};
  for (const PointGrid& grid : point_grids(actual_setup(setup)))
    if (const double thickness = grid.dz / deviation; thickness > least.thickness)
      least = {thickness, grid.inner};
  return least;
}

std::vector<std::string> layer_remarks(const Setup& setup) {
  std::vector<std::string> remarks;
  const std::size_t zones = point_grids(actual_setup(setup)).size();
  const auto made = by_layer(made_layers(setup), zones);
  std::size_t off = 0;
  const std::vector<MadeInterval>* worst = nullptr;
  for (const std::vector<MadeInterval>& layer : made) {
    const double deviation = worst_of(layer).deviation();
    if (!exceeds(deviation, layer_as_asked)) continue;
    ++off;
    if (worst == nullptr || deviation > worst_of(*worst).deviation()) worst = &layer;
  }
  const LeastThickness least = least_thickness(setup, layer_as_asked);
  const std::string always = fmt::format("made within {:g} % wherever it lies is a layer of {} or more",
                                         100.0 * layer_as_asked, millimetres(least.thickness));
  if (worst != nullptr) {
    const MadeInterval& zone = worst_of(*worst);
    const Layer& layer = setup.layers[static_cast<std::size_t>(worst - made.data())];
    remarks.push_back(fmt::format(
        "layers are made of whole rows of material points: {} of {} differ by more than {:g} % somewhere, "
        "most the {} from {:.4g} to {:.4g} m, {} thick: it {}; {}",
        off, made.size(), 100.0 * layer_as_asked, setup.soils[layer.soil].name, zone.top, zone.bottom,
        millimetres(zone.asked()), deviation_of(zone, setup.chamber.radius, "is", "lies"), always));
  }
  if (const auto lens = made_lens(setup);
      !lens.empty() && exceeds(worst_of(lens).deviation(), layer_as_asked))
    remarks.push_back(fmt::format("the density lens, {} thick, {}; {}", millimetres(worst_of(lens).asked()),
                                  deviation_of(worst_of(lens), setup.chamber.radius, "is", "lies"), always));
  const double mixed = setup.mechanisms.interface_mixing.thickness;
  double coarsest = 0.0;
  for (const PointGrid& grid : point_grids(actual_setup(setup))) coarsest = std::max(coarsest, grid.dz);
  if (made.size() > 1 && mixed > 0.0 && falls_short(mixed, coarsest))
    remarks.push_back(
        fmt::format("the mixed zone, {} thick, lies between rows of material points where these are {} "
                    "apart: interfaces stay sharp there",
                    millimetres(mixed), millimetres(coarsest)));
  return remarks;
}

std::string not_made(const Setup& setup, const std::vector<MadeInterval>& zones, std::string_view what) {
  if (zones.empty()) return "";
  const MadeInterval& worst = worst_of(zones);
  const double cell = setup.numerics.near_height / setup.numerics.refinement;
  const bool thin = falls_short(worst.asked(), cell);
  if (!thin && !exceeds(worst.deviation(), layer_not_made)) return "";
  const LeastThickness least = least_thickness(setup, layer_not_made);
  const std::string why = exceeds(worst.deviation(), layer_not_made)
                              ? deviation_of(worst, setup.chamber.radius, "would be", "would lie")
                              : fmt::format("is lower than a cell around the tip, {}", millimetres(cell));
  return fmt::format(
      "{} from {:.4g} to {:.4g} m, {} thick, {}: the least that this resolution makes within "
      "{:g} % wherever it lies is {}{}; numerics.refinement above {:g} makes finer rows",
      what, worst.top, worst.bottom, millimetres(worst.asked()), why, 100.0 * layer_not_made,
      millimetres(least.thickness),
      least.outside > 0.0 ? fmt::format(", for the rows beyond r = {:.3g} m", least.outside) : "",
      setup.numerics.refinement);
}

}  // namespace cpt::solver

#include "solver/thin_layers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/actual_setup.hpp"
#include "solver/lengths.hpp"
#include "solver/point_grid.hpp"

namespace cpt::solver {
namespace {

// "16 mm", "5.3 mm"
std::string millimetres(double length) { return fmt::format("{:.3g} mm", length * 1e3); }

}  // namespace

std::string too_thin(const Setup& setup, double top, double bottom, std::string_view what) {
  const double cell = actual_setup(setup).numerics.near_height;
  if (!falls_short(bottom - top, cell)) return "";
  return fmt::format(
      "{} from {:.4g} to {:.4g} m, {} thick, is lower than a cell around the tip, {}: it would move as its "
      "neighbours do whatever it is made of; numerics.refinement above {:g} makes lower cells",
      what, top, bottom, millimetres(bottom - top), millimetres(cell), setup.numerics.refinement);
}

std::vector<std::string> layer_remarks(const Setup& setup) {
  const double mixed = setup.mechanisms.interface_mixing.thickness;
  double coarsest = 0.0;
  for (const PointGrid& grid : point_grids(actual_setup(setup)))
    for (const PointBand& band : grid.bands)
      if (band.bottom < 0.0) coarsest = std::max(coarsest, band.dz);
  if (setup.layers.size() < 2 || mixed <= 0.0 || !falls_short(mixed, coarsest)) return {};
  return {
      fmt::format("the mixed zone, {} thick, lies between rows of material points where these are {} apart: "
                  "interfaces stay sharp there",
                  millimetres(mixed), millimetres(coarsest))};
}

}  // namespace cpt::solver

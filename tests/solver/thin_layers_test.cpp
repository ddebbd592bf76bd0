// Interfaces lie where they were asked for; layers lower than a cell are refused.
#include "solver/thin_layers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "solver/actual_setup.hpp"
#include "solver/initial_state.hpp"
#include "solver/point_grid.hpp"
#include "solver/presets.hpp"
#include "solver/quantities.hpp"

namespace cpt::solver {
namespace {

constexpr double mm = 1.0e-3;

/// Sand with one seam of clay.
solver::Setup with_seam(Preset preset, double top, double thickness) {
  solver::Setup setup = make_setup(Profile::homogeneous_sand, preset);
  setup.layers = {
      {0.0, top, default_sand}, {top, top + thickness, default_clay}, {top + thickness, 1.0, default_sand}};
  return setup;
}

/// Volume of the clay's points in each zone over the zone's area: its thickness.
std::vector<double> thickness_by_volume(const solver::Setup& setup) {
  const solver::Setup actual = actual_setup(setup);
  const InitialState state = initial_state(actual, {});
  std::vector<double> thickness;
  for (const PointGrid& grid : point_grids(actual)) {
    double clay = 0.0;
    for (std::size_t k = 0; k < state.points.size(); ++k) {
      const Point& point = state.points[k];
      if (point.r >= grid.inner && point.r < grid.outer &&
          state.material[k] == static_cast<std::int32_t>(default_clay))
        clay += point.volume;
    }
    // Midpoint sums of r dr are exact, the shift of the points aside.
    double area = 0.0;
    for (int i = 0; i < grid.columns; ++i) area += grid.r(i) * grid.dr;
    thickness.push_back(clay / area);
  }
  return thickness;
}

TEST(Layers, AreAsThickAsAskedInEveryZoneAndWhereverTheyLie) {
  for (const Preset preset : all_presets())
    for (const double diameter : {0.0253, 0.0357, 0.0437})
      for (const double thickness : {1.0, 7.3, 10.0, 25.0, 40.0})
        for (const double top : {60.0, 61.7})
          for (const double shift : {0.0, 0.25, -0.5}) {
            solver::Setup setup = with_seam(preset, top * mm, thickness * mm);
            setup.penetrometer.diameter = diameter;
            setup.numerics.point_shift = shift;
            for (const double made : thickness_by_volume(setup))
              EXPECT_NEAR(made, thickness * mm, 1e-9) << to_string(preset) << " " << diameter;
          }
}

TEST(Layers, OfTheLayeredProfileBeginWhereTheyWereAskedFor) {
  for (const Preset preset : all_presets()) {
    const solver::Setup actual = actual_setup(make_setup(Profile::layered_sand_clay, preset));
    for (const PointGrid& grid : point_grids(actual))
      for (const Layer& layer : actual.layers) {
        double nearest = 1.0;
        for (const PointBand& band : grid.bands)
          nearest = std::min(nearest, std::abs(band.bottom + layer.top));
        EXPECT_LT(nearest, 1e-12) << to_string(preset) << " " << layer.top;
      }
  }
}

TEST(Layers, FollowShiftedInterfacesAndTheRefinement) {
  solver::Setup setup = with_seam(Preset::quick, 0.06, 20 * mm);
  setup.mechanisms.layer_shift.shift = 0.0037;
  setup.numerics.refinement = 2.0;
  for (const double made : thickness_by_volume(setup)) EXPECT_NEAR(made, 20 * mm, 1e-9);
}

TEST(Layers, RowsAreNoFartherApartThanAskedFor) {
  for (const Preset preset : all_presets()) {
    const solver::Setup actual = actual_setup(with_seam(preset, 0.0613, 7 * mm));
    const std::vector<PointGrid> grids = point_grids(actual);
    for (std::size_t z = 0; z < grids.size(); ++z)
      for (const PointBand& band : grids[z].bands)
        EXPECT_LE(band.dz * actual.numerics.zones[z].rows_per_metre, 1.0 + 1e-6);
  }
}

TEST(Layers, ThinnerThanACellAreRefused) {
  const auto message = [](Preset preset, double thickness, double refinement = 1.0) {
    solver::Setup setup = with_seam(preset, 0.06, thickness * mm);
    setup.numerics.refinement = refinement;
    const auto found = problems(setup);
    return found.empty() ? std::string() : found.front().quantity + ": " + found.front().message;
  };
  EXPECT_EQ(message(Preset::quick, 0.5),
            "layers: the clay from 0.06 to 0.0605 m, 0.5 mm thick, is lower than a cell around the tip, 6.33 "
            "mm: it "
            "would move as its neighbours do whatever it is made of; numerics.refinement above 1 makes lower "
            "cells");
  EXPECT_NE(message(Preset::standard, 6.0), "");
  EXPECT_EQ(message(Preset::standard, 6.5), "");
  EXPECT_EQ(message(Preset::standard, 4.0, 2.0), "");
  EXPECT_NE(message(Preset::standard, 3.0, 2.0), "");
}

TEST(Layers, AShiftThatLeavesNothingOfALayerIsRefused) {
  solver::Setup setup = with_seam(Preset::quick, 0.06, 40 * mm);
  setup.mechanisms.layer_shift.shift = -0.06;
  const auto found = problems(setup);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].quantity, "layer_shift.shift_mm");
  EXPECT_NE(found[0].message.find("layer_shift.shift_mm = -60 leaves nothing"), std::string::npos);
}

TEST(Layers, AThinLensIsRefusedAndOthersAreMade) {
  solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::quick);
  setup.mechanisms.density_lens = {-0.2, 0.20, 2.0 * mm};
  const auto found = problems(setup);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].quantity, "density_lens.thickness_mm");
  EXPECT_NE(found[0].message.find("density_lens.thickness_mm = 2"), std::string::npos);
  setup.mechanisms.density_lens = {-0.2, 0.2013, 17.0 * mm};
  ASSERT_TRUE(problems(setup).empty());
  const solver::Setup actual = actual_setup(setup);
  for (const PointGrid& grid : point_grids(actual)) {
    double height = 0.0;
    for (const PointBand& band : grid.bands)
      if (actual.mechanisms.density_lens.at(-grid.z(band, 0)) != 0.0) height += band.rows * band.dz;
    EXPECT_NEAR(height, 17.0 * mm, 1e-9);
  }
}

TEST(Layers, AMixedZoneBetweenRowsIsTold) {
  solver::Setup setup = make_setup(Profile::layered_sand_clay, Preset::fine);
  EXPECT_TRUE(layer_remarks(setup).empty());
  setup.mechanisms.interface_mixing.thickness = 3.0 * mm;
  const auto remarks = layer_remarks(setup);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("stay sharp"), std::string::npos);
}

}  // namespace
}  // namespace cpt::solver

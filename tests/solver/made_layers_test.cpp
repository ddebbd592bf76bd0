// Layers as they are asked for and as the material points make them.
#include "solver/made_layers.hpp"

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

/// Thickness of the clay in each zone by the volume of its material points.
std::vector<double> thickness_by_volume(const solver::Setup& setup) {
  const solver::Setup actual = actual_setup(setup);
  const InitialState state = initial_state(actual, {});
  std::vector<double> thickness;
  for (const PointGrid& grid : point_grids(actual)) {
    double clay = 0.0, lowest = 1.0;
    std::map<double, double> row;  // volume by height
    for (std::size_t k = 0; k < state.points.size(); ++k) {
      const Point& point = state.points[k];
      if (point.r < grid.inner || point.r >= grid.outer) continue;
      row[point.z] += point.volume;
      lowest = std::min(lowest, point.z);
      if (state.material[k] == static_cast<std::int32_t>(default_clay)) clay += point.volume;
    }
    thickness.push_back(clay / row.at(lowest) * grid.dz);
  }
  return thickness;
}

TEST(MadeLayers, AreWhatThePointsMakeAtAllPresets) {
  for (const Preset preset : all_presets())
    for (const double thickness : {0.5, 1.0, 2.0, 4.0, 7.3, 16.0, 25.0, 40.0})
      for (const double shift : {0.0, 0.25, -0.5}) {
        solver::Setup setup = with_seam(preset, 0.06, thickness * mm);
        setup.numerics.point_shift = shift;
        const std::vector<double> measured = thickness_by_volume(setup);
        const std::vector<MadeInterval> made = made_layers(setup);
        const std::size_t zones = measured.size();
        ASSERT_EQ(made.size(), 3 * zones);
        for (std::size_t z = 0; z < zones; ++z)
          EXPECT_NEAR(made[zones + z].made(), measured[z], 1e-9)
              << to_string(preset) << " " << thickness << " mm, zone " << z;
      }
}

TEST(MadeLayers, FollowShiftedInterfacesAndTheRefinement) {
  solver::Setup setup = with_seam(Preset::quick, 0.06, 20 * mm);
  setup.mechanisms.layer_shift.shift = 0.0037;
  setup.numerics.refinement = 2.0;
  const std::vector<double> measured = thickness_by_volume(setup);
  const std::vector<MadeInterval> made = made_layers(setup);
  for (std::size_t z = 0; z < measured.size(); ++z)
    EXPECT_NEAR(made[measured.size() + z].made(), measured[z], 1e-9);
  EXPECT_DOUBLE_EQ(made[measured.size()].top, 0.0637);
}

// The worst of a seam's zones decides: one that is off by more than a quarter is refused, by more than a
// twentieth told.
TEST(MadeLayers, WhatIsNotMadeIsRefusedAndWhatIsOffIsTold) {
  int refused = 0, told = 0, as_asked = 0;
  for (const Preset preset : all_presets())
    for (double thickness = 0.5; thickness < 60.0; thickness += 2.5) {
      const solver::Setup setup = with_seam(preset, 0.06, thickness * mm);
      const std::vector<double> measured = thickness_by_volume(setup);
      double worst = 0.0;
      for (const double one : measured) worst = std::max(worst, std::abs(one / (thickness * mm) - 1.0));
      const auto found = problems(setup);
      refused += found.empty() ? 0 : 1;
      for (const Problem& problem : found) EXPECT_EQ(problem.quantity, "layers");
      const bool remarked = !layer_remarks(setup).empty();
      if (worst > layer_not_made + 1e-6) {
        EXPECT_FALSE(found.empty()) << to_string(preset) << " " << thickness;
      }
      if (worst > layer_as_asked + 1e-6) {
        EXPECT_TRUE(remarked) << to_string(preset) << " " << thickness;
      }
      if (found.empty()) ++(remarked ? told : as_asked);
    }
  EXPECT_GT(refused, 10);
  EXPECT_GT(told, 20);
  EXPECT_GT(as_asked, 3);
}

TEST(MadeLayers, TheMessageSaysHowThickWhereAndWhatCanBeMade) {
  const auto message = [](Preset preset, double thickness) {
    const auto found = problems(with_seam(preset, 0.06, thickness * mm));
    return found.empty() ? std::string() : found.front().message;
  };
  EXPECT_EQ(
      message(Preset::quick, 0.5),
      "the clay from 0.06 to 0.0605 m, 0.5 mm thick, would be 0 mm thick between r = 0.08 and 0.2 m: the "
      "least "
      "that this resolution makes within 25 % wherever it lies is 31.9 mm, for the rows beyond r = 0.2 m; "
      "numerics.refinement above 1 makes finer rows");
  for (const double thickness : {0.5, 2.0, 4.0, 8.0})
    EXPECT_NE(message(Preset::quick, thickness), "") << thickness;
  EXPECT_NE(message(Preset::standard, 1.0), "");
  EXPECT_EQ(message(Preset::quick, 16.0), "");  // made 12.1 to 16 mm thick
  const auto remarks = layer_remarks(with_seam(Preset::quick, 0.06, 16.0 * mm));
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find(
                "most the clay from 0.06 to 0.076 m, 16 mm thick: it is 12.1 mm thick between r = 0.08 and "
                "0.2 m"),
            std::string::npos)
      << remarks[0];
}

TEST(MadeLayers, TheLeastThicknessIsMadeWhereverItLies) {
  for (const Preset preset : all_presets()) {
    const solver::Setup plain = make_setup(Profile::homogeneous_sand, preset);
    for (const double deviation : {layer_as_asked, layer_not_made}) {
      const double least = least_thickness(plain, deviation).thickness;
      for (double top = 0.05; top < 0.07; top += 0.00013) {
        const std::vector<MadeInterval> made = made_layers(with_seam(preset, top, least));
        for (std::size_t k = made.size() / 3; k < 2 * made.size() / 3; ++k)  // the seam's
          EXPECT_LE(made[k].deviation(), deviation + 1e-9) << to_string(preset) << " " << top;
      }
    }
  }
}

TEST(MadeLayers, OneLayerIsAlwaysAsAskedAndTheLayeredProfileIsMade) {
  for (const Preset preset : all_presets()) {
    EXPECT_TRUE(made_layers(make_setup(Profile::homogeneous_clay, preset)).empty());
    EXPECT_TRUE(layer_remarks(make_setup(Profile::homogeneous_clay, preset)).empty());
    solver::Setup setup = make_setup(Profile::layered_sand_clay, preset);
    for (const double shift : {-15.0, -7.7, 0.0, 3.1, 15.0})
      for (const double points : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
        setup.mechanisms.layer_shift.shift = shift * mm;
        setup.numerics.point_shift = points;
        EXPECT_TRUE(problems(setup).empty()) << to_string(preset) << " " << shift << " " << points;
      }
  }
}

TEST(MadeLayers, AShiftThatLeavesNothingOfALayerIsRefused) {
  solver::Setup setup = with_seam(Preset::quick, 0.06, 40 * mm);
  setup.mechanisms.layer_shift.shift = -0.06;
  const auto found = problems(setup);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].quantity, "layer_shift.shift_mm");
  EXPECT_NE(found[0].message.find("layer_shift.shift_mm = -60 leaves nothing"), std::string::npos);
}

TEST(MadeLayers, AThinLensIsRefusedAndThoseOfTheCatalogueAreMade) {
  for (const Preset preset : all_presets()) {
    solver::Setup setup = make_setup(Profile::homogeneous_sand, preset);
    setup.mechanisms.density_lens = {-0.2, 0.20, 2.0 * mm};
    const auto found = problems(setup);
    ASSERT_EQ(found.size(), 1u) << to_string(preset);
    EXPECT_EQ(found[0].quantity, "density_lens.thickness_mm");
    EXPECT_NE(found[0].message.find("density_lens.thickness_mm = 2"), std::string::npos);
    for (double thickness = 30.0; thickness <= 120.0; thickness += 0.7)
      for (double centre = 60.0; centre <= 300.0; centre += 23.3) {
        setup.mechanisms.density_lens = {-0.2, centre * mm, thickness * mm};
        EXPECT_TRUE(problems(setup).empty()) << to_string(preset) << " " << thickness << " at " << centre;
      }
  }
}

TEST(MadeLayers, AMixedZoneBetweenRowsIsTold) {
  solver::Setup setup = make_setup(Profile::layered_sand_clay, Preset::fine);
  setup.mechanisms.interface_mixing.thickness = 3.0 * mm;
  bool told = false;
  for (const std::string& remark : layer_remarks(setup))
    told = told || remark.find("stay sharp") != remark.npos;
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace cpt::solver

#include "solver/presets.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/default_soils.hpp"

namespace cpt::solver {
namespace {

/// Material points in the zones, the penetrometer's place included.
double grid_points(const solver::Setup& setup) {
  double points = 0.0;
  for (const PointZone& zone : setup.numerics.zones)
    points +=
        zone.columns * zone.rows_per_metre * (setup.chamber.soil_height + setup.chamber.surcharge_height);
  return points;
}

TEST(Presets, NamesComeBack) {
  ASSERT_EQ(all_profiles().size(), 3u);
  ASSERT_EQ(all_presets().size(), 4u);
  for (const Profile profile : all_profiles()) EXPECT_EQ(profile_from_string(to_string(profile)), profile);
  for (const Preset preset : all_presets()) EXPECT_EQ(preset_from_string(to_string(preset)), preset);
  EXPECT_EQ(profile_from_string("sand"), std::nullopt);
  EXPECT_EQ(preset_from_string(""), std::nullopt);
}

TEST(Presets, ResolutionRises) {
  const auto points = [](Preset preset) {
    return grid_points(make_setup(Profile::homogeneous_sand, preset));
  };
  EXPECT_EQ(points(Preset::paper), 71000.0);  // Yost et al. (2023), section 4.1
  EXPECT_EQ(points(Preset::fine), 123000.0);
  EXPECT_LT(points(Preset::standard), 50000.0);
  EXPECT_GT(points(Preset::standard), 40000.0);
  EXPECT_LT(points(Preset::quick), 15000.0);
}

TEST(Presets, FineHalvesTheCellsAtTheCone) {
  const Numerics paper = make_setup(Profile::homogeneous_clay, Preset::paper).numerics;
  const Numerics fine = make_setup(Profile::homogeneous_clay, Preset::fine).numerics;
  EXPECT_EQ(fine.face_elements, 2 * paper.face_elements);
  EXPECT_EQ(fine.near_height, 0.5 * paper.near_height);
  EXPECT_EQ(fine.courant, paper.courant);
  EXPECT_EQ(fine.zones.front().rows_per_metre, 2.0 * paper.zones.front().rows_per_metre);
}

TEST(Presets, ProfilesDifferFromThePaperInNothingButTheirResolution) {
  for (const Preset preset : all_presets()) {
    const solver::Setup sand = make_setup(Profile::homogeneous_sand, preset);
    EXPECT_EQ(sand_of(sand).D_r, 0.36);
    EXPECT_GT(sand.penetrometer.final_depth, 0.5255);  // end of the window
    EXPECT_TRUE(contains(sand, default_sand));
    EXPECT_FALSE(contains(sand, default_clay));

    const solver::Setup clay = make_setup(Profile::homogeneous_clay, preset);
    EXPECT_GT(clay.penetrometer.final_depth, 0.5255);
    EXPECT_FALSE(contains(clay, default_sand));

    const solver::Setup layered = make_setup(Profile::layered_sand_clay, preset);
    EXPECT_EQ(sand_of(layered).D_r, 0.29);
    EXPECT_GT(layered.penetrometer.final_depth, 0.3094);
    for (const solver::Setup& setup : {sand, clay, layered}) {
      EXPECT_EQ(setup.initial.sigma_v0, 50.0e3);
      EXPECT_EQ(setup.initial.sigma_h0, 25.0e3);
      EXPECT_EQ(setup.chamber.wall, Wall::rigid);
    }
  }
}

TEST(Presets, LayersAlternateAndAre40MillimetresThick) {
  const solver::Setup setup = make_setup(Profile::layered_sand_clay, Preset::paper);
  ASSERT_EQ(setup.layers.size(), 11u);
  for (std::size_t i = 0; i < setup.layers.size(); ++i) {
    EXPECT_EQ(setup.layers[i].soil, i % 2 == 0 ? default_sand : default_clay);
    if (i > 0 && i + 1 < setup.layers.size()) {
      EXPECT_NEAR(setup.layers[i].bottom - setup.layers[i].top, 0.04, 1e-12);
    }
  }
  EXPECT_EQ(setup.layers.front().top, 0.0);
  EXPECT_EQ(setup.layers[1].top, 0.23);
  EXPECT_EQ(setup.layers.back().bottom, setup.chamber.soil_height);
}

}  // namespace
}  // namespace cpt::solver

// Surface compaction and the density lens set the void ratio they promise, and stress that fits it.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/actual_setup.hpp"
#include "tests/solver/default_soils.hpp"
#include "tests/solver/mechanisms/mechanism_fixture.hpp"

namespace cpt::solver {
namespace {

constexpr double range = 0.890 - 0.552;  // e_max - e_min

TEST(SurfaceCompaction, DecaysFromTheTop) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.1);
  const double e_0 = bulk(setup, default_sand).e;
  setup.mechanisms.surface_compaction = {0.25, 0.05};
  for_initial_soil(setup, [&](const Point& point, std::int32_t) {
    const double depth = -point.z;
    EXPECT_NEAR(point.e, e_0 - 0.25 * range * std::exp(-depth / 0.05), 1e-12);
  });
}

TEST(SurfaceCompaction, EndsAtTheDensestState) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.1);
  setup.mechanisms.surface_compaction = {0.80, 0.05};
  const Soil& sand = setup.soils[default_sand];
  EXPECT_EQ(law_of(sand).void_ratio_at(setup, sand.parameters, {}, 0.0), sand_of(setup).e_min);
}

TEST(SurfaceCompaction, IsFeltNearTheTopMost) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.11);
  const Outcome off = run(setup);
  setup.mechanisms.surface_compaction = {0.25, 0.03};
  const Outcome on = run(setup);
  const auto rise = [&](double from, double to) {
    return mean_q_c(on, from, to) / mean_q_c(off, from, to) - 1.0;
  };
  EXPECT_GT(rise(0.04, 0.06), 0.06);
  EXPECT_LT(std::abs(rise(0.09, 0.11)), 0.75 * rise(0.04, 0.06));
}

TEST(DensityLens, ChangesItsDepthsOnly) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.1);
  const double e_0 = bulk(setup, default_sand).e;
  setup.mechanisms.density_lens = {-0.2, 0.30, 0.08};
  for_initial_soil(setup, [&](const Point& point, std::int32_t) {
    const bool inside = std::abs(-point.z - 0.30) < 0.04;
    EXPECT_NEAR(point.e, inside ? e_0 + 0.2 * range : e_0, 1e-12);
  });
}

TEST(DensityTrend, TurnsAboutTheMiddleOfThePush) {
  for (const double final_depth : {0.3, 0.5}) {
    solver::Setup setup = quick(Profile::homogeneous_sand, final_depth);
    const Soil& sand = setup.soils[default_sand];
    const auto e = [&](double depth) {
      return law_of(sand).void_ratio_at(setup, sand.parameters, {}, depth);
    };
    const double e_0 = bulk(setup, default_sand).e;
    setup.mechanisms.density_trend.difference = 0.2;
    EXPECT_NEAR(e(0.0), e_0 + 0.1 * range, 1e-12);
    EXPECT_NEAR(e(0.5 * final_depth), e_0, 1e-12);
    EXPECT_NEAR(e(final_depth), e_0 - 0.1 * range, 1e-12);
    setup.mechanisms.density_trend.difference = -1.0;
    EXPECT_EQ(e(0.0), e_0 - 0.5 * range);  // not beyond the densest and the loosest state
    EXPECT_EQ(e(2.0), sand_of(setup).e_max);
    const solver::Setup actual = actual_setup(setup);  // the same sand for a shorter push before it
    solver::Setup first = actual;
    first.penetrometer.final_depth = 0.1;
    EXPECT_EQ(law_of(sand).void_ratio_at(first, sand.parameters, {}, 0.2),
              law_of(sand).void_ratio_at(actual, sand.parameters, {}, 0.2));
  }
}

// A lens over the whole depth is another relative density.
TEST(DensityLens, OfTheWholeDepthIsAnotherDensity) {
  solver::Setup lens = quick(Profile::homogeneous_sand, 0.06), denser = lens;
  lens.mechanisms.density_lens = {0.10, 0.5, 2.0};
  sand_of(denser).D_r += 0.10;
  const double a = mean_q_c(run(lens), 0.04, 0.06), b = mean_q_c(run(denser), 0.04, 0.06);
  EXPECT_NEAR(a, b, 0.01 * b);  // the lens leaves the self-weight alone
}

}  // namespace
}  // namespace cpt::solver

#include "solver/mechanisms/previous_push.hpp"

#include <gtest/gtest.h>

#include "solver/first_push.hpp"
#include "solver/mesh.hpp"
#include "solver/quantities.hpp"
#include "tests/solver/mechanisms/mechanism_fixture.hpp"

namespace cpt::solver {
namespace {

TEST(PreviousPush, LeftBehindIsLinearBetweenBins) {
  LeftBehind left;
  EXPECT_EQ(left.sigma_h(0.3), 1.0);
  EXPECT_EQ(left.void_ratio(0.3), 0.0);
  left.bin = 0.1;
  left.sigma_h_ratio = {1.0, 2.0, 4.0};
  EXPECT_DOUBLE_EQ(left.sigma_h(0.01), 1.0);
  EXPECT_DOUBLE_EQ(left.sigma_h(0.10), 1.5);
  EXPECT_DOUBLE_EQ(left.sigma_h(0.20), 3.0);
  EXPECT_DOUBLE_EQ(left.sigma_h(0.90), 4.0);
}

// Soil that nothing has touched has nothing left behind.
TEST(PreviousPush, OfUntouchedSoilChangesNothing) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.2);
  setup.mechanisms.previous_push = {1.0, 0.15};
  const InitialState state = initial_state(setup, models_of(setup));
  const auto materials = static_cast<std::int32_t>(setup.soils.size() + 1);
  const Mesh mesh(chamber_layout(setup));
  std::vector<std::int32_t> bucket_of;
  for (std::size_t k = 0; k < state.points.size(); ++k)
    bucket_of.push_back(mesh.locate(state.points[k].r, state.points[k].z).cell * materials +
                        state.material[k]);
  const MaterialPoints points(state.points, bucket_of, static_cast<std::int32_t>(mesh.cells().size()),
                              materials);
  Observer nobody;
  FirstPush first(setup, nobody);
  first.look(0.2, points);
  const LeftBehind& left = first.left_behind();
  // The points of a bin do not lie symmetrically about its middle: the self-weight of a few millimetres.
  EXPECT_NEAR(left.sigma_v_ratio, 1.0, 1e-3);
  for (const double ratio : left.sigma_h_ratio) EXPECT_NEAR(ratio, 1.0, 2e-3);
  for (const double change : left.void_ratio_change) EXPECT_NEAR(change, 0.0, 1e-12);
}

TEST(PreviousPush, OutsideTheChamberIsAProblem) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.06);
  setup.chamber.radius = 0.25;  // the default spacing is 0.26 m
  EXPECT_TRUE(problems(setup).empty());
  setup.mechanisms.previous_push.share = 1.0;
  ASSERT_EQ(problems(setup).size(), 1U);
  EXPECT_EQ(problems(setup)[0].quantity, "previous_push.spacing_m");
}

// The first push may have gone deeper, and is judged like a push of its own.
TEST(PreviousPush, HasADepthOfItsOwn) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.05);
  setup.mechanisms.previous_push = {.share = 1.0, .depth = 0.08};
  EXPECT_TRUE(problems(setup).empty());
  Observer nobody;
  FirstPush first(setup, nobody);
  EXPECT_EQ(first.setup().penetrometer.final_depth, 0.08);
  EXPECT_EQ(first.next_look(), 0.08);
  setup.mechanisms.previous_push.depth = 0.99;  // the chamber ends at 1 m
  ASSERT_EQ(problems(setup).size(), 1U);
  EXPECT_EQ(problems(setup)[0].quantity, "previous_push.depth_m");
  EXPECT_NE(problems(setup)[0].message.find("0.99"), std::string::npos);
}

TEST(PreviousPush, NearbyRaisesTheResistance) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.06);
  setup.chamber.radius = 0.20;
  const double first = mean_q_c(run(setup), 0.04, 0.06);
  setup.mechanisms.previous_push = {1.0, 0.06};
  const double second = mean_q_c(run(setup), 0.04, 0.06);
  EXPECT_GT(second, 1.05 * first);
}

// Stress and density, taken over one at a time, each leave the other as it was; together they are the whole.
TEST(PreviousPush, StressAndDensityCanBeTakenOverAlone) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.06);
  setup.chamber.radius = 0.20;
  const auto left_behind = [&](double stress, double density) {
    setup.mechanisms.previous_push = {0.8, 0.06, stress, density};
    Observer nobody;
    FirstPush first(setup, nobody);
    EXPECT_EQ(simulate(first.setup(), first, {1}).status, Status::completed);
    return first.left_behind();
  };
  const LeftBehind both = left_behind(1.0, 1.0);
  const LeftBehind stress = left_behind(1.0, 0.0);
  const LeftBehind density = left_behind(0.0, 1.0);
  EXPECT_NE(both.sigma_v_ratio, 1.0);
  EXPECT_EQ(stress.sigma_v_ratio, both.sigma_v_ratio);
  EXPECT_EQ(stress.sigma_h_ratio, both.sigma_h_ratio);
  EXPECT_EQ(stress.void_ratio_change, std::vector<double>(stress.void_ratio_change.size(), 0.0));
  EXPECT_EQ(density.sigma_v_ratio, 1.0);
  EXPECT_EQ(density.sigma_h_ratio, std::vector<double>(density.sigma_h_ratio.size(), 1.0));
  EXPECT_EQ(density.void_ratio_change, both.void_ratio_change);
  EXPECT_LT(density.void_ratio_change[0], 0.0);  // loose sand is compacted
}

}  // namespace
}  // namespace cpt::solver

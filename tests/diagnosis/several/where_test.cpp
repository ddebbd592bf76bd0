#include "diagnosis/several/where.hpp"

#include <gtest/gtest.h>

#include "toy.hpp"

namespace cpt::diagnosis {
namespace {

const std::vector<Cell> two = cells_of({{0.0, 0.01, 30}}, 2);  // two channels
const VectorXd noise = VectorXd::Constant(60, 0.02);

Band nothing() { return {VectorXd::Zero(60), VectorXd::Constant(60, 0.005)}; }

TEST(WhereEffectsAre, WithTheirSignInTheirChannel) {
  Band effects = nothing();
  effects.mean.segment(5, 10).setConstant(-0.2);
  effects.mean.segment(40, 5).setConstant(0.1);
  VectorXd difference = VectorXd::Zero(60);
  difference.segment(5, 10).setConstant(-0.25);
  const auto found = where_effects_are(two, effects, noise, difference);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].channel, 0);
  EXPECT_NEAR(found[0].from, 0.05, 1e-12);
  EXPECT_NEAR(found[0].to, 0.15, 1e-12);
  EXPECT_NEAR(found[0].effect, -0.2, 1e-12);
  EXPECT_NEAR(found[0].over_refitted, -0.25, 1e-12);
  EXPECT_EQ(found[0].rows.size(), 10U);
  EXPECT_EQ(found[1].channel, 1);
  EXPECT_NEAR(found[1].from, 0.1, 1e-12);
  EXPECT_NEAR(found[1].effect, 0.1, 1e-12);
}

TEST(WhereEffectsAre, NotWhereTheyMayBeNoise) {
  Band effects = nothing();
  effects.mean.setConstant(0.021);  // one deviation of 0.005 above the noise would be 0.025
  EXPECT_TRUE(where_effects_are(two, effects, noise, VectorXd::Zero(60)).empty());
  effects.mean.setConstant(0.03);
  EXPECT_EQ(where_effects_are(two, effects, noise, VectorXd::Zero(60)).size(), 2U);  // a channel each
  effects.deviation.setConstant(0.05);
  EXPECT_TRUE(where_effects_are(two, effects, noise, VectorXd::Zero(60)).empty());
}

TEST(WhereEffectsAre, GapsOfOneCellAreClosedAndSingleCellsLeftOut) {
  Band effects = nothing();
  effects.mean.segment(3, 8).setConstant(0.2);
  effects.mean(6) = 0.0;
  effects.mean(20) = 0.2;
  const auto found = where_effects_are(two, effects, noise, VectorXd::Zero(60));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].rows.size(), 8U);
  // Another sign is another stretch.
  effects.mean.segment(7, 4).setConstant(-0.2);
  EXPECT_EQ(where_effects_are(two, effects, noise, VectorXd::Zero(60)).size(), 2U);
}

}  // namespace
}  // namespace cpt::diagnosis

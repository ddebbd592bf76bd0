// The whole second edition on a toy problem of two channels.
#include "diagnosis/several/findings.hpp"

#include <gtest/gtest.h>

#include "diagnosis/random.hpp"
#include "toy.hpp"

namespace cpt::diagnosis {
namespace {

const std::vector<Cell> one = toy::cells();
const NoiseModel noise{Kernel::ar1, 0.02, 0.03};

// The second channel sees each effect otherwise: twice as much of the lens, nothing of the drift, and the top
// upside down.
VectorXd doubled(const VectorXd& first, double share) {
  VectorXd both(120);
  both << first, share * first;
  return both;
}

MechanismEffect in_both(MechanismEffect effect, double share) {
  MatrixXd both(120, effect.delta.cols());
  both << effect.delta, share * effect.delta;
  effect.delta = both;
  return effect;
}

Problem problem(const VectorXd& missing, std::uint64_t seed) {
  Problem p;
  p.cells = cells_of({{0.0, 0.01, 60}}, 2);
  p.baseline = doubled(toy::baseline(one), 1.0);
  p.parameters = toy::parameters(one);
  for (ParameterEffect& parameter : p.parameters) {
    parameter.lower = doubled(parameter.lower, 1.0);
    parameter.upper = doubled(parameter.upper, 1.0);
  }
  p.mechanisms = {in_both(toy::lens(one, 24), 2.0), in_both(toy::top(one, 16), -1.0),
                  in_both(toy::drift(one, 6), 0.0)};
  const Whitener scatter(noise_covariance(p.cells, noise));
  p.recorded = p.baseline + scatter.colour(Random(seed, 3).normals(120)).col(0) + missing;
  p.repeats = MatrixXd(120, 0);
  return p;
}

const std::vector<ChannelFacts> known(2, {.noise = ChannelNoise{0.02, 0.0, 0.03}});

TEST(Findings, NameAnEffectWithItsCurveAndGain) {
  const VectorXd missing = doubled(toy::top_curve(one, 0.7, 0.5), -1.0);
  const Findings found = find_several(problem(missing, 1), known);
  EXPECT_EQ(found.naming.named, std::vector<std::size_t>{1});
  EXPECT_TRUE(found.naming.alarm);
  EXPECT_GT(found.check.p, 0.01);
  ASSERT_TRUE(found.over_wrong && found.over_nothing);
  EXPECT_GT(found.over_wrong->sum, 3.0);
  EXPECT_GT(found.over_nothing->sum, 3.0);
  EXPECT_LT((found.summary.effects.mean - missing).norm(), 0.3 * missing.norm());
}

TEST(Findings, NothingIsMissingWhereTheSoilAloneIsOther) {
  Problem p = problem(VectorXd::Zero(120), 2);
  p.recorded += 0.6 * (p.parameters[0].upper - p.baseline);
  const Findings found = find_several(p, known);
  EXPECT_FALSE(found.naming.alarm);
  EXPECT_TRUE(found.naming.named.empty());
}

// A second channel whose level is wrong by a factor: taken for known it raises an alarm, with a factor of its
// own none.
TEST(Findings, AChannelMayHaveAFactor) {
  Problem p = problem(VectorXd::Zero(120), 3);
  p.recorded.tail(60).array() += 0.3;
  EXPECT_TRUE(find_several(p, known).naming.alarm);
  std::vector<ChannelFacts> calibrated = known;
  calibrated[1].factor = 0.35;
  EXPECT_FALSE(find_several(p, calibrated).naming.alarm);
}

TEST(Findings, NoiseThatIsNotKnownIsEstimated) {
  Problem p = problem(VectorXd::Zero(120), 4);
  std::vector<ChannelFacts> unknown = known;
  unknown[0].noise.reset();
  const Findings found = find_several(p, unknown);
  ASSERT_TRUE(found.noise);
  EXPECT_LT(found.noise->lower, 0.02);
  EXPECT_GT(found.noise->upper, 0.01);
  EXPECT_FALSE(found.naming.alarm);
}

TEST(Findings, SameInputSameBits) {
  const Problem p = problem(doubled(toy::lens_curve(one, 0.5, 0.5), 2.0), 5);
  const Findings a = find_several(p, known), b = find_several(p, known);
  EXPECT_EQ(a.explained.inclusion, b.explained.inclusion);
  EXPECT_EQ(a.alarm_level, b.alarm_level);
  EXPECT_EQ(a.summary.effects.mean, b.summary.effects.mean);
}

}  // namespace
}  // namespace cpt::diagnosis

#include "diagnosis/several/soil.hpp"

#include <gtest/gtest.h>

#include "diagnosis/several/soil_scaling.hpp"
#include "toy.hpp"

namespace cpt::diagnosis {
namespace {

struct Sand {
  std::vector<Cell> cells = toy::cells();
  std::vector<ParameterEffect> effects = toy::parameters(cells);
  Sand() { effects.push_back({"wall", 0.0, {}, toy::baseline(cells).array() + 0.3, true}); }
  [[nodiscard]] ResponseSurface surface() const { return {toy::baseline(cells), effects}; }
};

MatrixXd covariance_of(const LocalSoil& soil) {
  return soil.slopes * soil.slopes.transpose() + soil.remainder * soil.remainder.transpose();
}

TEST(LocalSoil, BeforeTheRecordingIsThePrior) {
  const Sand sand;
  const ResponseSurface surface = sand.surface();
  const SoilPrior prior = soil_prior(sand.effects, {});
  const LocalSoil soil = local_soil(surface, prior, before_recording(prior));
  const MatrixXd factors = surface.prior_factors();
  EXPECT_LT((soil.mean - surface.prior_mean()).cwiseAbs().maxCoeff(), 1e-5);
  const MatrixXd covariance = factors * factors.transpose();
  EXPECT_LT((covariance_of(soil) - covariance).norm(), 1e-4 * covariance.norm());
  EXPECT_LT((soil.places - VectorXd::Constant(3, 0.5)).cwiseAbs().maxCoeff(), 1e-9);
}

// Of one soil: the surface's own value and slope there, by differences.
TEST(LocalSoil, WhereTheSoilIsKnownIsTheTangent) {
  Sand sand;
  sand.effects.pop_back();
  const ResponseSurface surface = sand.surface();
  const SoilPrior prior = soil_prior(sand.effects, {});
  const Eigen::Vector2d scores(0.7, -1.2);
  const LocalSoil soil = local_soil(surface, prior, {scores, VectorXd::Constant(2, 1e-4)});
  const auto at = [&](const Eigen::Vector2d& z) {
    return surface.predict(Eigen::Vector2d(prior.place_of_score[0](z(0)), prior.place_of_score[1](z(1))));
  };
  EXPECT_LT((soil.mean + soil.slopes * scores - at(scores)).cwiseAbs().maxCoeff(), 1e-7);
  constexpr double step = 1e-4;
  for (Index j = 0; j < 2; ++j) {
    const Eigen::Vector2d aside = step * Eigen::Vector2d::Unit(j);
    const VectorXd slope = (at(scores + aside) - at(scores - aside)) / (2.0 * step);
    EXPECT_LT((soil.slopes.col(j) - slope).cwiseAbs().maxCoeff(), 1e-6);
  }
  EXPECT_LT(soil.remainder.norm(), 1e-6);
}

// Lognormal and correlated: the moments of the curves are those of the draws.
TEST(LocalSoil, KnowsDistributionsAndTheirCorrelation) {
  Sand sand;
  sand.effects.pop_back();
  sand.effects[1].place_of_score = [](double z) { return 0.3 * std::exp(0.4 * z); };
  const Eigen::Matrix2d correlation{{1.0, -0.7}, {-0.7, 1.0}};
  const ResponseSurface surface = sand.surface();
  const SoilPrior prior = soil_prior(sand.effects, correlation);
  const LocalSoil soil = local_soil(surface, prior, before_recording(prior));
  const MatrixXd draws = draw_soil(surface, prior, 1e-12 * MatrixXd::Identity(60, 60), 20000, 1);
  EXPECT_LT((draws.rowwise().mean() - soil.mean).cwiseAbs().maxCoeff(), 0.004);
  const MatrixXd about = draws.colwise() - draws.rowwise().mean();
  const MatrixXd sample = about * about.transpose() / 20000.0;
  EXPECT_LT((sample - covariance_of(soil)).norm(), 0.05 * sample.norm());
  // Taken for independent they would be far off.
  EXPECT_GT(
      (sample - covariance_of(local_soil(surface, soil_prior(sand.effects, {}), before_recording(prior))))
          .norm(),
      0.2 * sample.norm());
}

TEST(LocalSoil, RefusesWhatIsNoCorrelation) {
  const Sand sand;
  EXPECT_THROW((void)soil_prior(sand.effects, MatrixXd::Constant(3, 3, 2.0)), std::invalid_argument);
  EXPECT_THROW((void)soil_prior(sand.effects, MatrixXd::Identity(2, 2)), std::invalid_argument);
}

// The lens does 1 + 0.8 s_1 - 0.5 s_2 times as much in other soil.
MechanismEffect lens_in_soil(const std::vector<Cell>& cells, double first, double second) {
  MechanismEffect lens = toy::lens(cells, 16);
  constexpr Index runs = 8;
  lens.joint_design.resize(runs, 2);
  lens.joint_soil.resize(runs, 2);
  lens.joint_delta.resize(60, runs);
  for (Index k = 0; k < runs; ++k) {
    const int i = static_cast<int>(k) + 1;
    lens.joint_design.row(k) << 0.5 + 0.5 * toy::spread(i, 2), toy::spread(i, 3);
    lens.joint_soil.row(k) << toy::spread(i, 5) - 0.5, toy::spread(i, 7) - 0.5;
    lens.joint_delta.col(k) = (1.0 + first * lens.joint_soil(k, 0) + second * lens.joint_soil(k, 1)) *
                              toy::lens_curve(cells, lens.joint_design(k, 0), lens.joint_design(k, 1));
  }
  return lens;
}

TEST(SoilScaling, FindsThatAnEffectDoesMoreInOtherSoil) {
  const std::vector<Cell> cells = toy::cells();
  const MechanismEffect lens = lens_in_soil(cells, 0.8, -0.5);
  const CurveEmulator emulator(lens);
  const SoilScaling scaling(cells, lens, emulator);
  const CurveEmulator there = scaling.at(Eigen::Vector2d(0.4, -0.3));
  const Eigen::Vector2d phi(0.8, 0.5);
  const VectorXd truth = (1.0 + 0.8 * 0.4 + 0.5 * 0.3) * toy::lens_curve(cells, 0.8, 0.5);
  EXPECT_LT((there.mean(phi) - truth).norm(), 0.1 * truth.norm());
  EXPECT_LT(there.joint_residuals().norm(), 0.4 * emulator.joint_residuals().norm());
}

TEST(SoilScaling, LeavesAnEffectThatIsTheSameEverywhere) {
  const std::vector<Cell> cells = toy::cells();
  const MechanismEffect lens = lens_in_soil(cells, 0.0, 0.0);
  const CurveEmulator emulator(lens);
  const SoilScaling scaling(cells, lens, emulator);
  const Eigen::Vector2d phi(0.8, 0.5);
  EXPECT_LT((scaling.at(Eigen::Vector2d(0.4, -0.3)).mean(phi) - emulator.mean(phi)).norm(),
            0.02 * emulator.mean(phi).norm());
  // Nor has one without joint runs a scale.
  MechanismEffect alone = lens;
  alone.joint_design = alone.joint_delta = alone.joint_soil = {};
  const CurveEmulator plain(alone);
  EXPECT_EQ(SoilScaling(cells, alone, plain).at(Eigen::Vector2d(0.4, -0.3)).mean(phi), plain.mean(phi));
}

}  // namespace
}  // namespace cpt::diagnosis

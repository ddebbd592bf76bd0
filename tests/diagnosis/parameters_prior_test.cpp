#include "diagnosis/parameters_prior.hpp"

#include <gtest/gtest.h>

#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

TEST(AdditiveModel, PassesThroughTheRuns) {
  const auto cells = toy::cells();
  const auto effects = toy::parameters(cells);
  const AdditiveModel model(toy::baseline(cells), effects);
  EXPECT_LT((model.predict(model.baseline_place()) - toy::baseline(cells)).norm(), 1e-12);
  EXPECT_LT((model.predict(Eigen::Vector2d(0.5, 0.0)) - effects[1].lower).norm(), 1e-12);
  EXPECT_LT((model.predict(Eigen::Vector2d(0.5, 1.0)) - effects[1].upper).norm(), 1e-12);
  // From the baseline widened twice, half the way is the old end.
  const AdditiveModel wide = model.widened(2.0);
  EXPECT_LT((wide.predict(Eigen::Vector2d(0.75, 0.4)) - effects[0].upper).norm(), 1e-12);
}

TEST(AdditiveModel, HasThePriorsMoments) {
  const auto cells = toy::cells();
  auto effects = toy::parameters(cells);
  effects.push_back({"wall", 0.0, {}, toy::baseline(cells).array() + 0.3, true});
  const NullModel null = null_model(AdditiveModel(toy::baseline(cells), effects),
                                    MatrixXd::Zero(60, 60) + 1e-12 * MatrixXd::Identity(60, 60));
  const MatrixXd draws = draw_null(null, 20000, 1);
  EXPECT_LT(draws.rowwise().mean().cwiseAbs().maxCoeff(), 0.005);
  const MatrixXd sample = draws * draws.transpose() / 20000.0;
  EXPECT_LT((sample - null.covariance).norm(), 0.02 * null.covariance.norm());
  // By hand, in the middle of the depths where nothing tilts (z = 0.3) but for 0.02 of the tilt's run.
  EXPECT_NEAR(null.covariance(29, 29), 0.2 * 0.2 / 12.0 + 0.3 * 0.3 / 4.0, 2e-4);
}

TEST(AdditiveModel, RefusesWhatIsNoEffect) {
  const auto cells = toy::cells();
  const VectorXd y = toy::baseline(cells);
  EXPECT_THROW(AdditiveModel(y, {{"none", 0.5, {}, {}}}), std::invalid_argument);
  EXPECT_THROW(AdditiveModel(y, {{"outside", 1.5, y, y}}), std::invalid_argument);
  EXPECT_THROW(AdditiveModel(y, {{"short", 0.5, VectorXd::Ones(3), y}}), std::invalid_argument);
  EXPECT_THROW(AdditiveModel(y, {{"choice", 0.5, y, y, true}}), std::invalid_argument);
}

TEST(Recalibrate, FindsTheParametersAndKeepsToTheBounds) {
  const auto cells = toy::cells();
  const AdditiveModel model(toy::baseline(cells), toy::parameters(cells));
  const Whitener sigma(noise_covariance(cells, toy::noise));
  const Eigen::Vector2d truth(0.2, 0.8);
  const Recalibration exact = recalibrate(model, model.predict(truth), sigma);
  EXPECT_LT((exact.place - truth).norm(), 1e-4);
  EXPECT_LT(exact.rmse, 1e-4);

  // 40 % more q_c than the baseline: only 10 % are within the bounds.
  const Recalibration bound = recalibrate(model, model.baseline().array() + 0.4, sigma);
  EXPECT_NEAR(bound.place(0), 1.0, 1e-9);
  EXPECT_GT(bound.rmse, 0.2);
  EXPECT_TRUE((bound.place.array() >= 0.0 && bound.place.array() <= 1.0).all());
}

TEST(Recalibrate, CoversTheTruth) {
  const auto cells = toy::cells();
  const NullModel null = toy::null(cells);
  const Whitener sigma(null.sigma);
  double squares = 0.0;
  Random random(5, 0);
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector2d truth(0.2 + 0.6 * random.uniform(), 0.2 + 0.6 * random.uniform());
    const VectorXd y = null.parameters.predict(truth) + sigma.colour(random.normals(60));
    const Recalibration fit = recalibrate(null.parameters, y, sigma);
    squares += std::pow((fit.place(0) - truth(0)) / fit.deviation(0), 2) / 200.0;
  }
  EXPECT_NEAR(squares, 1.0, 0.35);
}

}  // namespace
}  // namespace cpt::diagnosis

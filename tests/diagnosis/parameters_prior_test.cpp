#include "diagnosis/parameters_prior.hpp"

#include <gtest/gtest.h>

#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

TEST(Recalibrate, FindsTheParametersAndKeepsToTheBounds) {
  const auto cells = toy::cells();
  const ResponseSurface model(toy::baseline(cells), toy::parameters(cells));
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

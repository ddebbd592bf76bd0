#include "diagnosis/calibration/posterior_distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/random.hpp"

namespace cpt::diagnosis {
namespace {

using parameters::Family;

TEST(PosteriorDistribution, TheKindThatTheDrawsAreOfIsChosen) {
  Random random(3, 0);
  const Eigen::VectorXd z = random.normals(20000);
  const Eigen::VectorXd lognormal = (0.5 * z.array()).exp() * 10.0;
  const FittedDistribution skewed = fitted_distribution(lognormal, 0.1, 200.0, false);
  EXPECT_EQ(skewed.family, Family::lognormal);
  EXPECT_NEAR(skewed.mean, 10.0 * std::exp(0.125), 0.2);
  EXPECT_LT(skewed.apart, 0.05);

  const FittedDistribution even = fitted_distribution(z.array() * 2.0 - 5.0, -30.0, 20.0, false);
  EXPECT_NE(even.family, Family::lognormal);  // negative
  EXPECT_NEAR(even.deviation, 2.0, 0.05);
  EXPECT_LT(even.apart, 0.05);

  Eigen::VectorXd uniform(20000);
  for (double& value : uniform) value = 3.0 + 2.0 * random.uniform();
  const FittedDistribution flat = fitted_distribution(uniform, 3.0, 5.0, false);
  EXPECT_EQ(flat.family, Family::beta);
  EXPECT_LT(flat.apart, 0.05);
}

TEST(PosteriorDistribution, AChoiceKeepsItsShares) {
  Eigen::VectorXd draws(4);
  draws << 0.0, 1.0, 1.0, 1.0;
  const FittedDistribution fitted = fitted_distribution(draws, 0.0, 1.0, true);
  EXPECT_EQ(fitted.family, Family::discrete);
  EXPECT_EQ(fitted.values, (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(fitted.weights, (std::vector<double>{0.25, 0.75}));
}

}  // namespace
}  // namespace cpt::diagnosis

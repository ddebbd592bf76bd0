// Quantiles and moments of each family against closed forms.
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <cmath>

#include "parameters/distributions/moments.hpp"
#include "tests/parameters/distributions/with_openturns.hpp"

namespace cpt::parameters {
namespace {

using Marginals = WithOpenTurns;
constexpr double probabilities[] = {1e-6, 0.01, 0.05, 0.3, 0.5, 0.77, 0.95, 0.999};

// Against Boost.Math, another library.
template <class Reference>
void expect_like(const Distribution& distribution, const Reference& reference) {
  const auto asked = marginal(distribution);
  for (const double p : probabilities) {
    const double x = boost::math::quantile(reference, p);
    EXPECT_NEAR(asked->quantile(p), x, 1e-9 * (1.0 + std::abs(x))) << to_string(distribution.family) << p;
    EXPECT_NEAR(asked->probability(x), p, 1e-9);
  }
  EXPECT_NEAR(asked->mean(), boost::math::mean(reference), 1e-9 * (1.0 + std::abs(asked->mean())));
  EXPECT_NEAR(asked->standard_deviation(), boost::math::standard_deviation(reference), 1e-9);
}

TEST_F(Marginals, AgreeWithAnotherLibrary) {
  expect_like({Family::normal, {30.0, 1.5}}, boost::math::normal(30.0, 1.5));
  expect_like({Family::lognormal, {0.3, 0.2}}, boost::math::lognormal(0.3, 0.2));
  expect_like({Family::triangular, {1.0, 2.0, 5.0}}, boost::math::triangular(1.0, 2.0, 5.0));
  expect_like({Family::beta, {2.0, 3.0, 0.0, 1.0}}, boost::math::beta_distribution(2.0, 3.0));
}

TEST_F(Marginals, HaveTheMomentsTheyWereMadeFrom) {
  for (const Family family : {Family::normal, Family::lognormal, Family::uniform}) {
    const auto made = marginal(from_moments(family, 743.0, 110.0).value());
    EXPECT_NEAR(made->mean(), 743.0, 1e-9) << to_string(family);
    EXPECT_NEAR(made->standard_deviation(), 110.0, 1e-9) << to_string(family);
  }
  const auto beta = marginal(beta_from_moments(0.1, 0.5, 0.2, 0.07).value());
  EXPECT_NEAR(beta->mean(), 0.2, 1e-12);
  EXPECT_NEAR(beta->standard_deviation(), 0.07, 1e-12);
  EXPECT_FALSE(beta_from_moments(0.1, 0.5, 0.2, most_deviation(0.1, 0.5, 0.2)));
  EXPECT_FALSE(from_moments(Family::lognormal, -1.0, 0.1));
}

TEST_F(Marginals, GoThroughTheQuantilesTheyWereMadeFrom) {
  for (const Family family : {Family::normal, Family::lognormal, Family::uniform}) {
    const auto made = marginal(from_quantiles(family, {{{0.05, 600.0}, {0.9, 900.0}}}).value());
    EXPECT_NEAR(made->quantile(0.05), 600.0, 1e-9) << to_string(family);
    EXPECT_NEAR(made->quantile(0.9), 900.0, 1e-9) << to_string(family);
  }
  EXPECT_FALSE(from_quantiles(Family::normal, {{{0.05, 900.0}, {0.9, 600.0}}}));
}

TEST_F(Marginals, AreCutOffAndScaledUp) {
  Distribution cut{Family::normal, {0.0, 1.0}};
  cut.least = -1.0, cut.most = 2.0;
  const auto made = marginal(cut);
  const boost::math::normal whole;
  const double below = cdf(whole, -1.0), kept = cdf(whole, 2.0) - below;
  for (const double p : probabilities)
    EXPECT_NEAR(made->quantile(p), quantile(whole, below + p * kept), 1e-9);
  EXPECT_EQ(made->probability(-1.0), 0.0);
  EXPECT_EQ(made->probability(2.0), 1.0);
}

TEST_F(Marginals, StepThroughDiscreteValues) {
  const auto made = marginal({Family::discrete, {}, {1.0, 2.0, 4.0}, {0.25, 0.5, 0.25}});
  EXPECT_EQ(made->quantile(0.1), 1.0);
  EXPECT_EQ(made->quantile(0.5), 2.0);
  EXPECT_EQ(made->quantile(0.9), 4.0);
  EXPECT_NEAR(made->mean(), 2.25, 1e-12);
}

TEST_F(Marginals, RefuseParametersOfNoMember) {
  EXPECT_THROW((void)marginal({Family::normal, {0.0, -1.0}}), std::invalid_argument);
  EXPECT_THROW((void)marginal({Family::uniform, {2.0, 1.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace cpt::parameters

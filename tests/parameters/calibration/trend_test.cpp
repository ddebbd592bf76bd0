#include "parameters/calibration/trend.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::calibration {
namespace {

HardeningFit fit(double psi_0, double p_0, double H) {
  HardeningFit f;
  f.psi_0 = psi_0;
  f.p_0 = p_0;
  f.H = H;
  return f;
}

TEST(HardeningTrend, FindsTheCoefficientsThatMadeThePoints) {
  std::vector<HardeningFit> fits;
  for (const double psi : {-0.25, -0.15, -0.02})
    for (const double p : {40e3, 160e3, 640e3})
      fits.push_back(fit(psi, p, 40 - 300 * psi - 12 * std::log(p / 100e3)));
  const auto both = hardening_trend(fits, TrendIn::psi_and_p);
  ASSERT_TRUE(both);
  EXPECT_NEAR(both->H_0, 40, 1e-9);
  EXPECT_NEAR(both->by_psi, -300, 1e-9);
  EXPECT_NEAR(both->by_p, -12, 1e-9);
  EXPECT_NEAR(both->r_squared, 1, 1e-12);
  EXPECT_EQ(both->tests, 9);
  const auto one = hardening_trend(fits, TrendIn::psi);
  ASSERT_TRUE(one);
  EXPECT_NEAR(one->by_psi, -300, 1e-9);  // psi and p are independent here
  EXPECT_EQ(one->by_p, 0.0);
  EXPECT_LT(one->r_squared, 0.95);
}

TEST(HardeningTrend, NeedsTestsThatTellTheCoefficientsApart) {
  std::vector<HardeningFit> fits = {fit(-0.2, 100e3, 60), fit(-0.1, 100e3, 40)};
  EXPECT_FALSE(hardening_trend(fits, TrendIn::psi));
  fits.push_back(fit(-0.15, 100e3, 52));
  EXPECT_TRUE(hardening_trend(fits, TrendIn::psi));
  fits.push_back(fit(-0.05, 100e3, 30));
  EXPECT_FALSE(hardening_trend(fits, TrendIn::psi_and_p));  // all at one p_0
  for (HardeningFit& f : fits) f.psi_0 = -0.1;
  EXPECT_FALSE(hardening_trend(fits, TrendIn::psi));
}

TEST(HardeningTrend, LeavesOutFitsWithAProblem) {
  std::vector<HardeningFit> fits = {fit(-0.2, 1e5, 60), fit(-0.1, 1e5, 40), fit(0.0, 1e5, 20),
                                    fit(-0.1, 1e5, 2000)};
  fits.back().problem = "H lies at the bound";
  const auto trend = hardening_trend(fits, TrendIn::psi);
  ASSERT_TRUE(trend);
  EXPECT_NEAR(trend->by_psi, -200, 1e-9);
}

}  // namespace
}  // namespace cpt::calibration

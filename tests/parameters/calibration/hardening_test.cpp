// H comes back from curves that were made with it.
#include "parameters/calibration/hardening.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solver/constitutive/element_test.hpp"

namespace cpt::calibration {
namespace {

struct Specimen {
  double D_r, p_0, H;
};

// What a laboratory would read: every `spacing` of engineering strain up to 15 %, with an error of `noise`
// times the largest q.
TriaxialCurve measured(const Specimen& specimen, double spacing, double noise, unsigned seed = 1) {
  solver::ElementTest test;
  solver::NorSandParameters sand;
  sand.D_r = specimen.D_r;
  sand.H = specimen.H;
  test.material = sand;
  test.sigma_a = test.sigma_r = specimen.p_0;
  test.max_axial_strain = -std::log1p(-0.15);
  test.steps = 4000;
  const auto rows = solver::run_element_test(test).rows;
  double largest = 0.0;
  for (const auto& row : rows) largest = std::max(largest, row.q);

  std::mt19937 generator(seed);
  std::normal_distribution<double> error;  // in standard deviations
  TriaxialCurve curve;
  curve.p_0 = specimen.p_0;
  curve.D_r = specimen.D_r;
  double next = 0.0;
  for (const auto& row : rows) {
    const double eps_a = -std::expm1(-row.eps_a);
    if (eps_a < next) continue;
    curve.readings.push_back({eps_a, row.q + noise * largest * error(generator), -std::expm1(-row.eps_v)});
    next += spacing;
  }
  return curve;
}

class Hardening : public ::testing::TestWithParam<Specimen> {};

TEST_P(Hardening, ComesBackFromFineCleanCurvesWithin1Percent) {
  const HardeningFit fit = fit_hardening(measured(GetParam(), 0.0002, 0.0), solver::NorSandParameters{});
  EXPECT_EQ(fit.problem, "");
  EXPECT_NEAR(fit.H, GetParam().H, 0.01 * GetParam().H);
  EXPECT_LT(fit.misfit, 0.005);
  EXPECT_NEAR(fit.E_sand, fit.E_test, 0.005 * fit.E_test);
  EXPECT_LT(fit.eps_v_misfit, 5e-4);
}

TEST_P(Hardening, ComesBackFromCoarseNoisyCurvesWithin10Percent) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const HardeningFit fit =
        fit_hardening(measured(GetParam(), 0.001, 0.005, seed), solver::NorSandParameters{});
    EXPECT_EQ(fit.problem, "");
    EXPECT_NEAR(fit.H, GetParam().H, 0.10 * GetParam().H) << "seed " << seed << ", readings " << fit.readings;
  }
}

// Densities of Yost et al. (2023), section 4.2, and the range of H it finds.
INSTANTIATE_TEST_SUITE_P(Tests, Hardening,
                         ::testing::Values(Specimen{0.80, 320e3, 75}, Specimen{0.51, 160e3, 50},
                                           Specimen{0.51, 40e3, 150}, Specimen{0.01, 80e3, 25}));

TEST(HardeningFit, OtherParametersStayAtTheirBaseline) {
  // A curve of stiffer elasticity is matched by a larger H, not by what was not to be touched.
  const TriaxialCurve curve = measured({0.51, 160e3, 50}, 0.0005, 0.0);
  solver::NorSandParameters soft;
  soft.G_ref = 500.0;
  EXPECT_GT(fit_hardening(curve, soft).H, 1.02 * 50);
}

TEST(HardeningFit, StateBeforeShearing) {
  TriaxialCurve curve = measured({0.80, 320e3, 75}, 0.0005, 0.0);
  const HardeningFit from_density = fit_hardening(curve, solver::NorSandParameters{});
  EXPECT_DOUBLE_EQ(from_density.e_0, 0.890 - 0.80 * (0.890 - 0.552));
  EXPECT_NEAR(from_density.psi_0, from_density.e_0 - (0.90 - 0.012 * std::pow(3.2, 0.7)), 1e-12);
  curve.D_r = not_given;
  curve.e_0 = from_density.e_0;
  EXPECT_EQ(fit_hardening(curve, solver::NorSandParameters{}).H, from_density.H);
}

TEST(HardeningFit, SaysWhyThereIsNoH) {
  TriaxialCurve curve =
      measured({0.80, 320e3, 75}, 0.02, 0.0);  // the second reading is past half of the peak
  HardeningFit fit = fit_hardening(curve, solver::NorSandParameters{});
  EXPECT_TRUE(std::isnan(fit.H));
  EXPECT_NE(fit.problem.find("readings up to 0.5 of the largest q"), std::string::npos) << fit.problem;

  curve = measured({0.80, 320e3, 75}, 0.0005, 0.0);
  curve.p_0 = not_given;
  EXPECT_NE(fit_hardening(curve, solver::NorSandParameters{}).problem.find("not known"), std::string::npos);
}

TEST(HardeningFit, ABoundIsToldAsSuch) {
  HardeningOptions options;
  options.H_upper = 60.0;
  const HardeningFit fit =
      fit_hardening(measured({0.80, 320e3, 75}, 0.0005, 0.0), solver::NorSandParameters{}, options);
  EXPECT_NEAR(fit.H, 60.0, 0.6);
  EXPECT_NE(fit.problem.find("at the bound"), std::string::npos) << fit.problem;
}

}  // namespace
}  // namespace cpt::calibration

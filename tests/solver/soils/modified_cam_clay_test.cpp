// Modified Cam Clay against its closed forms: isotropic lines, critical state, undrained paths (Roscoe &
// Burland 1968; Muir Wood, Soil Behaviour and Critical State Soil Mechanics, 1990, chapter 5).
#include "solver/soils/modified_cam_clay.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/constitutive/element_test.hpp"

namespace cpt::solver {
namespace {

constexpr double p_0 = 100e3;

ElementTest test_of(double OCR, ElementPath path, bool drained) {
  ModifiedCamClayParameters clay;
  clay.OCR = OCR;
  ElementTest test;
  test.material = clay;
  test.path = path;
  test.drained = drained;
  test.sigma_a = test.sigma_r = p_0;
  return test;
}

const ModifiedCamClayParameters clay;

TEST(ModifiedCamClay, IsotropicCompressionFollowsItsLines) {
  ElementTest test = test_of(4.0, ElementPath::isotropic, true);
  test.max_axial_strain = 0.12;
  test.steps = 120;
  const ElementResult result = run_element_test(test);
  ASSERT_EQ(result.problem, "");
  const double p_c = 4.0 * p_0, v_0 = 1.0 + clay.e_0;
  const double N = v_0 - clay.kappa * std::log(p_c / p_0) + clay.lambda * std::log(p_c);
  int elastic = 0, plastic = 0;
  for (const ElementRow& row : result.rows) {
    if (row.p < 0.999 * p_c) {
      EXPECT_NEAR(1.0 + row.e, v_0 - clay.kappa * std::log(row.p / p_0), 1e-10);
      ++elastic;
    } else if (row.p > 1.001 * p_c) {
      EXPECT_NEAR(1.0 + row.e, N - clay.lambda * std::log(row.p), 1e-9);
      EXPECT_NEAR(row.h_0, row.p, 1e-6 * row.p);
      ++plastic;
    }
  }
  EXPECT_GT(elastic, 5);
  EXPECT_GT(plastic, 50);
}

// q / p' = M and v = Gamma - lambda ln p', from either side.
TEST(ModifiedCamClay, DrainedCompressionEndsInTheCriticalState) {
  for (const double OCR : {1.0, 2.0, 8.0}) {
    ElementTest test = test_of(OCR, ElementPath::triaxial, true);
    test.max_axial_strain = 1.5;
    test.steps = 300;
    const ElementResult result = run_element_test(test);
    ASSERT_EQ(result.problem, "") << OCR;
    const double p_c = OCR * p_0;
    const double N = 1.0 + clay.e_0 - clay.kappa * std::log(p_c / p_0) + clay.lambda * std::log(p_c);
    const double Gamma = N - (clay.lambda - clay.kappa) * std::log(2.0);
    const ElementRow& last = result.rows.back();
    EXPECT_NEAR(last.q / last.p, clay.M, 1e-3) << OCR;
    EXPECT_NEAR(last.q, 3.0 * p_0 * clay.M / (3.0 - clay.M), 2e-3 * last.q) << OCR;
    EXPECT_NEAR(1.0 + last.e, Gamma - clay.lambda * std::log(last.p), 1e-3) << OCR;
    EXPECT_NEAR(last.h_0, 2.0 * last.p, 4e-3 * last.p) << OCR;
  }
}

// p' / p_0 = (M^2 / (M^2 + eta^2))^Lambda of a normally consolidated clay, Lambda = 1 - kappa / lambda:
// whatever the step, since it follows from the volume alone. The strain at which a stress is reached has the
// error of the backward Euler rule.
double q_at_two_percent(double increment) {
  ElementTest test = test_of(1.0, ElementPath::triaxial, false);
  test.max_axial_strain = 0.02;
  test.steps = 10;
  test.max_increment = increment;
  const ElementResult result = run_element_test(test);
  EXPECT_EQ(result.problem, "");
  for (const ElementRow& row : result.rows) {
    const double eta = row.q / row.p;
    const double exact =
        p_0 * std::pow(clay.M * clay.M / (clay.M * clay.M + eta * eta), 1.0 - clay.kappa / clay.lambda);
    EXPECT_NEAR(row.p, exact, 1e-9 * exact);
    EXPECT_EQ(row.e, clay.e_0);
  }
  return result.rows.back().q;
}

TEST(ModifiedCamClay, UndrainedPathIsTheClosedFormAndStrainsConvergeToTheFirstOrder) {
  const double coarse = q_at_two_percent(1e-3), middle = q_at_two_percent(5e-4),
               fine = q_at_two_percent(2.5e-4);
  EXPECT_NEAR(std::log2((coarse - middle) / (middle - fine)), 1.0, 0.1);
  EXPECT_NEAR(fine, 2.0 * fine - middle, 0.01 * fine);
}

// s_u / p_0 = M / 2 (OCR / 2)^Lambda.
TEST(ModifiedCamClay, UndrainedStrengthFollowsOverconsolidation) {
  for (const double OCR : {1.0, 2.0, 4.0, 16.0}) {
    ElementTest test = test_of(OCR, ElementPath::triaxial, false);
    test.max_axial_strain = 0.6;
    test.max_increment = 1e-4;
    test.steps = 60;
    const ElementRow last = run_element_test(test).rows.back();
    const double Lambda = 1.0 - clay.kappa / clay.lambda;
    EXPECT_NEAR(last.q / 2.0, clay.M / 2.0 * p_0 * std::pow(OCR / 2.0, Lambda), 0.01 * last.q) << OCR;
    EXPECT_NEAR(last.q / last.p, clay.M, 2e-3) << OCR;
  }
}

// K_0 compression of a clay on its normal compression line keeps a constant stress ratio.
TEST(ModifiedCamClay, OneDimensionalCompressionReachesItsOwnK0) {
  ElementTest test = test_of(1.0, ElementPath::oedometer, true);
  test.max_axial_strain = 0.6;
  test.steps = 300;
  const ElementResult result = run_element_test(test);
  ASSERT_EQ(result.problem, "");
  const ElementRow &last = result.rows.back(), &before = result.rows[result.rows.size() - 60];
  EXPECT_NEAR(last.q / last.p, before.q / before.p, 2e-3);
  // eta of eta (1 + nu) (1 - Lambda) / (3 (1 - 2 nu)) + 3 eta Lambda / (M^2 - eta^2) = 1 (Muir Wood 1990,
  // eq. 10.19).
  const double Lambda = 1.0 - clay.kappa / clay.lambda, eta = last.q / last.p;
  const double sum = eta * (1.0 + clay.nu) * (1.0 - Lambda) / (3.0 * (1.0 - 2.0 * clay.nu)) +
                     3.0 * eta * Lambda / (clay.M * clay.M - eta * eta);
  EXPECT_NEAR(sum, 1.0, 0.02);
}

}  // namespace
}  // namespace cpt::solver

// What NorSand must satisfy whatever its integration: critical state, stress-dilatancy, energy, strengths.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/constitutive/critical_state_line.hpp"
#include "solver/constitutive/element_test.hpp"
#include "solver/constitutive/norsand.hpp"

namespace cpt::solver {
namespace {

constexpr double M_tc = 1.2;  // 6 sin 30 / (3 - sin 30)

ElementTest drained(double D_r, double p_0, double H) {
  NorSandParameters sand;
  sand.D_r = D_r;
  sand.H = H;
  sand.substep_tolerance = 1e-7;  // far below what the identities are held to
  ElementTest test;
  test.material = sand;
  test.sigma_a = test.sigma_r = p_0;
  return test;
}

TEST(NorSandIdentities, EndsInTheCriticalState) {
  ElementTest test = drained(0.80, 320e3, 25.0);
  test.max_axial_strain = 3.0;
  test.steps = 6000;
  const ElementResult result = run_element_test(test);
  ASSERT_EQ(result.problem, "");
  const ElementRow& last = result.rows.back();
  EXPECT_NEAR(last.q / last.p, M_tc, 1e-7);
  EXPECT_NEAR(last.e, CriticalStateLine(NorSandParameters{}).void_ratio(last.p), 1e-7);
  EXPECT_NEAR(last.h_0, last.p, 1e-6 * last.p);
}

TEST(NorSandIdentities, DrainedTriaxialStaysOnItsLine) {
  const ElementResult result = run_element_test(drained(0.36, 100e3, 25.0));
  ASSERT_EQ(result.rows.size(), 251U);
  for (const ElementRow& row : result.rows) EXPECT_NEAR(row.q, 3.0 * (row.p - 100e3), 1e-6 * row.p);
}

// eta_max = M_tc - (1 - N) chi_i psi_i at the peak (Jefferies & Been 2015): nearer the harder the sand.
TEST(NorSandIdentities, PeakStressRatio) {
  for (const auto& [H, tolerance] : {std::pair{25.0, 0.013}, std::pair{75.0, 0.005}}) {
    ElementTest test = drained(0.80, 320e3, H);
    test.steps = 500;
    const ElementResult result = run_element_test(test);
    const auto peak =
        std::max_element(result.rows.begin(), result.rows.end(),
                         [](const ElementRow& a, const ElementRow& b) { return a.q / a.p < b.q / b.p; });
    const CriticalStateLine line(NorSandParameters{});
    const double slope = line.slope(peak->h_0);
    const double chi_i = 2.7 / (1.0 - slope * 2.7 / M_tc);
    const double eta_max = M_tc - (1.0 - 0.1) * chi_i * (peak->e - line.void_ratio(peak->h_0));
    EXPECT_NEAR(peak->q / peak->p, eta_max, tolerance * eta_max) << "H " << H;
    EXPECT_GT(eta_max, 1.5);
  }
}

TEST(NorSandIdentities, NumberOfRowsIsNoMatterOfAccuracy) {
  for (const bool is_drained : {true, false}) {
    ElementTest test = drained(0.80, 320e3, 25.0);
    test.drained = is_drained;
    test.max_axial_strain = 0.30;
    test.steps = 6;
    const ElementResult few = run_element_test(test);
    test.steps = 1200;
    const ElementResult many = run_element_test(test);
    ASSERT_EQ(few.rows.size(), 7U);
    EXPECT_NEAR(few.rows.back().q, many.rows.back().q, 1e-6 * many.rows.back().q);
    EXPECT_NEAR(few.rows.back().e, many.rows.back().e, 1e-7);
  }
}

TEST(NorSandIdentities, UndrainedStrength) {
  ElementTest test = drained(0.80, 320e3, 25.0);
  test.drained = false;
  test.max_axial_strain = 0.30;
  test.steps = 3000;
  const ElementResult result = run_element_test(test);
  EXPECT_NEAR(result.rows.back().q, 8902.2e3, 5e-5 * 8902.2e3);
  EXPECT_NEAR(result.rows.back().eps_v, 0.0, 1e-15);
}

TEST(NorSandIdentities, StartsOnTheYieldSurfaceUnderK0) {
  const NorSandParameters sand;
  const NorSand law(sand);
  const double p_i = law.initial_image_pressure(-25e3, -50e3, -25e3, 0.0, 0.76832);
  EXPECT_NEAR(p_i, 23.3390e3, 0.05);
  const NorSandState state = law.evaluate({-25e3, -50e3, -25e3, 0.0}, 0.76832, p_i);
  EXPECT_NEAR(state.psi_i, -0.12735, 5e-6);
  EXPECT_NEAR(state.M_i, 1.16538, 5e-6);
  EXPECT_NEAR(state.yield, 0.0, 1e-13);
  EXPECT_DOUBLE_EQ(state.q, 25e3);
  EXPECT_NEAR(state.sin3theta, 1.0, 1e-14);

  NorSandParameters overconsolidated;
  overconsolidated.OCR = 2.0;
  EXPECT_DOUBLE_EQ(NorSand(overconsolidated).initial_image_pressure(-25e3, -50e3, -25e3, 0.0, 0.76832),
                   2.0 * p_i);
}

// Each of the four safeguards alone, and a usual state that none holds.
TEST(NorSandIdentities, SafeguardsAreSeen) {
  const NorSandParameters sand;
  const NorSand law(sand);
  EXPECT_FALSE(law.evaluate({-25e3, -50e3, -25e3, 0.0}, 0.76832, 23.339e3).limited);
  // 1 - slope chi / M_tc = 0.25 at p_i = 19.2 MPa; far inside the yield surface, so that nothing flows.
  EXPECT_FALSE(law.evaluate({-15e6, -15e6, -15e6, 0.0}, 0.5, 18.8e6).limited);
  EXPECT_TRUE(law.evaluate({-15e6, -15e6, -15e6, 0.0}, 0.5, 19.6e6).limited);
  // M_itc = M_tc - N chi |psi| reaches 0.1 M_tc at |psi| = 0.51 for N = 0.6 and chi = 3.5.
  NorSandParameters dilatant = sand;
  dilatant.N = 0.6;
  dilatant.chi_tc = 3.5;
  EXPECT_TRUE(NorSand(dilatant).evaluate({-25e3, -25e3, -25e3, 0.0}, 0.30, 30e3).limited);
  EXPECT_FALSE(NorSand(dilatant).evaluate({-25e3, -25e3, -25e3, 0.0}, 0.60, 30e3).limited);
  EXPECT_TRUE(law.evaluate({-25e3, -25e3, -25e3, 0.0}, sand.e_min_star + 0.005, 30e3).limited);
  // Loose sand just beyond the peak softens faster than its elasticity gives way, if H is large.
  NorSandParameters brittle = sand;
  brittle.H = 2000.0;
  const NorSand steep(brittle);
  const double p = 3e6, q = 4.5e6, s_a = -(p + 2.0 * q / 3.0), s_r = -(p - q / 3.0);
  const double e = 0.95, p_i = steep.initial_image_pressure(s_r, s_a, s_r, 0.0, e);
  EXPECT_TRUE(steep.evaluate({s_r, s_a, s_r, 0.0}, e, p_i).limited);
}

// The formulas of the state by hand, off the triaxial axes.
TEST(NorSandIdentities, StateMatchesTheFormulas) {
  const NorSandParameters sand;
  const NorSand law(sand);
  const double e = 0.70, p_i = 80e3;
  const NorSandState state = law.evaluate({-60e3, -140e3, -90e3, 20e3}, e, p_i);
  const double p = (60e3 + 140e3 + 90e3) / 3.0;
  const double a = 60e3 - p, b = 140e3 - p, c = 90e3 - p, t = -20e3;
  const double q = std::sqrt(1.5 * (a * a + b * b + c * c + 2.0 * t * t));
  const double sin3theta = 13.5 * c * (a * b - t * t) / (q * q * q);
  EXPECT_NEAR(state.p, p, 1e-12 * p);
  EXPECT_NEAR(state.q, q, 1e-12 * q);
  EXPECT_NEAR(state.sin3theta, sin3theta, 1e-12);

  const CriticalStateLine line(sand);
  const double psi_i = e - line.void_ratio(p_i);
  const double chi_i = 2.7 / (1.0 - line.slope(p_i) * 2.7 / M_tc);
  const double M_itc = M_tc - 0.1 * chi_i * std::abs(psi_i);
  const double theta = std::asin(sin3theta) / 3.0;
  const double M_theta = M_tc - M_tc * M_tc / (3.0 + M_tc) * std::cos(1.5 * theta + std::acos(-1.0) / 4.0);
  EXPECT_NEAR(state.psi, e - line.void_ratio(p), 1e-13);
  EXPECT_NEAR(state.psi_i, psi_i, 1e-13);
  EXPECT_NEAR(state.chi_i, chi_i, 1e-12);
  EXPECT_NEAR(state.M_itc, M_itc, 1e-12);
  EXPECT_NEAR(state.M_i, M_itc * M_theta / M_tc, 4e-4);  // the corner's rounding
  EXPECT_NEAR(state.D_p, state.M_i - q / p, 1e-12);
  EXPECT_NEAR(state.p_mx, p * std::exp(-chi_i * psi_i / M_itc), 1e-9 * p);
  EXPECT_NEAR(state.yield, q / p - state.M_i * (1.0 + std::log(p_i / p)), 1e-12);
  const double G = 743.0 * 100e3 / (e - 0.051) * std::pow(p / 100e3, 0.57);
  EXPECT_NEAR(state.G, G, 1e-12 * G);
  EXPECT_NEAR(state.K, G * 2.0 * 1.2 / (3.0 * 0.6), 1e-12 * state.K);
}

/// One triaxial state and the plastic strain that led from another to it.
struct Work {
  double total = 0.0, elastic = 0.0, plastic = 0.0;  // [Pa]
  double largest_dilatancy_error = 0.0;
};

// Compresses a K0 state at a fixed strain ratio and sums work by the trapezoidal rule.
Work compress(int steps) {
  const NorSandParameters sand;
  const NorSand law(sand);
  Specimen specimen(law, {-25e3, -50e3, -25e3, 0.0}, 0.76832,
                    law.initial_image_pressure(-25e3, -50e3, -25e3, 0.0, 0.76832));
  Work work;
  const auto state = [&] { return law.evaluate(specimen.stress(), specimen.e(), specimen.h_0()); };
  NorSandState before = state();
  for (int i = 0; i < steps; ++i) {
    const double axial = 0.02 / steps, radial = -0.45 * axial;
    const double eps_v = axial + 2.0 * radial, eps_q = 2.0 / 3.0 * (axial - radial);
    specimen.strain(-radial, -axial, -radial, 0.0);
    const NorSandState after = state();
    const auto mean = [](double a, double b) { return 0.5 * (a + b); };
    const double p = mean(before.p, after.p), q = mean(before.q, after.q);
    const double elastic_v = (after.p - before.p) * mean(1.0 / before.K, 1.0 / after.K);
    const double elastic_q = (after.q - before.q) * mean(1.0 / before.G, 1.0 / after.G) / 3.0;
    const double plastic_v = eps_v - elastic_v, plastic_q = eps_q - elastic_q;
    work.total += p * eps_v + q * eps_q;
    work.elastic += p * elastic_v + q * elastic_q;
    work.plastic += mean(before.p * before.M_i, after.p * after.M_i) * plastic_q;
    if (i > 0) {
      const double error = std::abs(plastic_v / plastic_q - mean(before.D_p, after.D_p));
      work.largest_dilatancy_error = std::max(work.largest_dilatancy_error, error);
    }
    before = after;
  }
  return work;
}

// Plastic work p D_p de_q + q de_q = p M_i de_q: the dissipation that the flow rule comes from.
TEST(NorSandIdentities, EnergyAndDilatancy) {
  const Work work = compress(160000);
  EXPECT_NEAR(work.total, work.elastic + work.plastic, 1e-9 * work.total);
  EXPECT_LT(work.largest_dilatancy_error, 1e-4);
  const Work coarse = compress(1000);
  EXPECT_LT(coarse.largest_dilatancy_error, 1e-3);
}

}  // namespace
}  // namespace cpt::solver

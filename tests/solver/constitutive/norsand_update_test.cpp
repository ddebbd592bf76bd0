// How NorSand's update behaves: order of convergence, independence of the lanes, elastic path, limits, bad
// input.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "solver/constitutive/norsand.hpp"
#include "solver/constitutive/specimen.hpp"
#include "tests/solver/constitutive/batch_fixture.hpp"

namespace cpt::solver {
namespace {

constexpr PointStress k0_stress = {-25e3, -50e3, -25e3, 0.0};
constexpr double e_0 = 0.76832;

Specimen k0_specimen(const NorSandParameters& sand) {
  const NorSand law(sand);
  return {law, k0_stress, e_0, law.initial_image_pressure(-25e3, -50e3, -25e3, 0.0, e_0)};
}

double distance(const Specimen& a, const Specimen& b) {
  return std::hypot(a.stress().rr - b.stress().rr, a.stress().zz - b.stress().zz,
                    a.stress().rz - b.stress().rz) +
         std::abs(a.stress().tt - b.stress().tt);
}

// A smooth plastic path that turns in stress space.
Specimen sheared(double tolerance, int steps) {
  NorSandParameters sand;
  sand.substep_tolerance = tolerance;
  Specimen specimen = k0_specimen(sand);
  for (int i = 0; i < steps; ++i)
    specimen.strain(0.010 / steps, -0.016 / steps, 0.004 / steps, 0.008 / steps);
  return specimen;
}

TEST(NorSandUpdate, SecondOrderInTheStrainStep) {
  const Specimen exact = sheared(1e-9, 4000);
  // A tolerance of 1 leaves one modified Euler step to each increment.
  const double coarse = distance(sheared(1.0, 1200), exact), fine = distance(sheared(1.0, 2400), exact);
  const double order = std::log2(coarse / fine);
  EXPECT_GT(order, 1.8) << coarse << " Pa, " << fine << " Pa";
  EXPECT_LT(order, 2.6);
  EXPECT_LT(fine, 1e-3 * exact.p());
}

TEST(NorSandUpdate, SubstepToleranceGovernsTheErrorOfLargeSteps) {
  const Specimen exact = sheared(1e-9, 4000);
  double last = std::numeric_limits<double>::infinity();
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const double error = distance(sheared(tolerance, 40), exact) / exact.p();
    EXPECT_LT(error, 0.3 * last);
    EXPECT_LT(error, 30.0 * tolerance);
    last = error;
  }
}

TEST(NorSandUpdate, DefaultToleranceCostsNothingAgainstOtherErrors) {
  const Specimen exact = sheared(1e-9, 4000);
  for (const int steps : {10, 100, 1000})
    EXPECT_LT(distance(sheared(NorSandParameters{}.substep_tolerance, steps), exact), 1e-3 * exact.p())
        << steps;
}

// Points in all kinds of states: elastic, yielding, near the axis, loose, capped.
struct Points {
  std::vector<double> fields[OwnedBatch::field_count];
};
Points random_points(std::size_t n) {
  std::mt19937_64 generator(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(generator);
  };
  const NorSand law{NorSandParameters{}};
  Points points;
  for (std::size_t k = 0; k < n; ++k) {
    const double p = std::pow(10.0, uniform(2.0, 6.7));
    const double eta = k % 7 == 0 ? 0.0 : uniform(0.0, 1.3), angle = uniform(0.0, 6.283);
    const double a = p * eta * std::cos(angle) / std::sqrt(3.0), b = p * eta * std::sin(angle) / 3.0;
    const double e = uniform(0.55, 0.89);
    const double s_rr = -p + a + b, s_zz = -p - a + b, s_tt = -p - 2.0 * b;
    const double p_i =
        law.initial_image_pressure(s_rr, s_zz, s_tt, 0.0, e) * (k % 3 == 0 ? uniform(1.0, 3.0) : 1.0);
    const double size = std::pow(10.0, uniform(-6.0, -2.7));
    const double values[] = {s_rr,
                             s_zz,
                             s_tt,
                             0.0,
                             e,
                             p_i,
                             size * uniform(-1.0, 1.0),
                             size * uniform(-1.0, 1.0),
                             size * uniform(-1.0, 1.0),
                             size * uniform(-1.0, 1.0)};
    for (std::size_t f = 0; f < OwnedBatch::field_count; ++f) points.fields[f].push_back(values[f]);
  }
  return points;
}

OwnedBatch batch_of(const Points& points, const std::vector<std::size_t>& order) {
  OwnedBatch batch(order.size());
  for (std::size_t f = 0; f < OwnedBatch::field_count; ++f)
    for (std::size_t k = 0; k < order.size(); ++k) batch.field(f)[k] = points.fields[f][order[k]];
  return batch;
}

TEST(NorSandUpdate, BitsDoNotDependOnTheOtherPointsOfABatch) {
  constexpr std::size_t n = 4096;
  const Points points = random_points(n);
  std::vector<std::size_t> order(n);
  for (std::size_t k = 0; k < n; ++k) order[k] = k;
  OwnedBatch straight = batch_of(points, order);
  const NorSand law{NorSandParameters{}};
  const double modulus = law.update(straight.view());
  std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
  OwnedBatch shuffled = batch_of(points, order);
  EXPECT_EQ(law.update(shuffled.view()), modulus);
  for (std::size_t f = 0; f < 6; ++f)
    for (std::size_t k = 0; k < n; ++k) {
      ASSERT_TRUE(std::isfinite(shuffled.field(f)[k]));
      ASSERT_EQ(shuffled.field(f)[k], straight.field(f)[order[k]]) << "field " << f << " point " << order[k];
    }
}

TEST(NorSandUpdate, EndsInsideOrOnTheYieldSurface) {
  constexpr std::size_t n = 4096;
  const Points points = random_points(n);
  std::vector<std::size_t> order(n);
  for (std::size_t k = 0; k < n; ++k) order[k] = k;
  OwnedBatch batch = batch_of(points, order);
  const NorSand law{NorSandParameters{}};
  const double modulus = law.update(batch.view());
  double largest = 0.0;
  std::size_t loose = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const PointStress s = {batch.field(0)[k], batch.field(1)[k], batch.field(2)[k], batch.field(3)[k]};
    const NorSandState state = law.evaluate(s, batch.field(4)[k], batch.field(5)[k]);
    EXPECT_LT(state.yield, 1e-6) << k;
    largest = std::max(largest, state.K + 4.0 / 3.0 * state.G);
    if (state.p < NorSandParameters{}.p_min) {
      ++loose;
      EXPECT_NEAR(state.q, 0.0, 1e-9);
    } else {
      EXPECT_LT(batch.field(5)[k], 1.3 * state.p_mx * 1.02) << k;
    }
  }
  EXPECT_NEAR(modulus, largest, 1e-9 * largest);
  EXPECT_GT(loose, 10U);
  EXPECT_LT(loose, n / 2);
}

TEST(NorSandUpdate, InstructionSetsAgree) {
#if defined(__x86_64__)
  constexpr std::size_t n = 4096;
  const Points points = random_points(n);
  std::vector<std::size_t> order(n);
  for (std::size_t k = 0; k < n; ++k) order[k] = k;
  const NorSand law{NorSandParameters{}};
  OwnedBatch reference = batch_of(points, order);
  constitutive_kernels_baseline.update_norsand(law.constants(), reference.view());
  std::vector<const ConstitutiveKernels*> others;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    others.push_back(&constitutive_kernels_avx2);
  if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw"))
    others.push_back(&constitutive_kernels_avx512);
  for (const ConstitutiveKernels* kernels : others) {
    OwnedBatch batch = batch_of(points, order);
    kernels->update_norsand(law.constants(), batch.view());
    std::size_t different = 0;  // rounding may change where a sub-step ends
    for (std::size_t k = 0; k < n; ++k) {
      const double p = std::abs(reference.field(1)[k]) + NorSandParameters{}.p_min;
      for (std::size_t f = 0; f < 6; ++f) {
        const double scale = f == 4 ? 1.0 : p;
        ASSERT_NEAR(batch.field(f)[k], reference.field(f)[k], 0.02 * scale)
            << "field " << f << " point " << k;
        different += std::abs(batch.field(f)[k] - reference.field(f)[k]) > 1e-6 * scale;
      }
    }
    EXPECT_LT(different, n / 50);
  }
#endif
}

// G = G_c p^b and K in proportion: p^(1-b) grows linearly with volumetric strain, the deviator in proportion
// to p.
TEST(NorSandUpdate, ElasticPathIsExact) {
  NorSandParameters sand;
  sand.OCR = 20.0;
  sand.cap_ratio = 10.0;
  for (const double size : {1e-7, 1e-5, 1e-4}) {
    Specimen specimen = k0_specimen(sand);
    const NorSandState state = NorSand(sand).evaluate(specimen.stress(), e_0, specimen.h_0());
    specimen.strain(-0.3 * size, -size, -0.2 * size, 0.1 * size);
    const double eps_v = 1.5 * size;
    const double e_1 = (1.0 + e_0) * std::exp(-eps_v) - 1.0;
    const double K = state.K * (e_0 - 0.051) / (0.5 * (e_0 + e_1) - 0.051);
    const double p_0 = 100e3 / 3.0;
    const double p_1 = p_0 * std::pow(1.0 + (1.0 - 0.57) * K * eps_v / p_0, 1.0 / (1.0 - 0.57));
    const double two_G = 2.0 * (p_1 - p_0) / eps_v * state.G / state.K;
    EXPECT_NEAR(specimen.p(), p_1, 1e-11 * p_1);
    EXPECT_NEAR(specimen.stress().zz, -50e3 - (p_1 - p_0) - two_G * (size - 0.5 * size), 1e-11 * p_1);
    EXPECT_NEAR(specimen.stress().rz, two_G * 0.1 * size, 1e-11 * p_1);
    EXPECT_NEAR(specimen.e(), e_1, 1e-15);
  }
}

TEST(NorSandUpdate, UnloadsAlongTheElasticPathAndBack) {
  Specimen specimen = k0_specimen(NorSandParameters{});
  specimen.strain(2e-5, -1e-4, 2e-5, 0.0);
  const Specimen start = specimen;
  specimen.strain(-1e-5, 5e-5, -1e-5, 0.0);
  EXPECT_EQ(specimen.h_0(), start.h_0());
  specimen.strain(1e-5, -5e-5, 1e-5, 0.0);
  EXPECT_NEAR(specimen.stress().zz, start.stress().zz, 1e-7 * start.p());
  EXPECT_NEAR(specimen.h_0(), start.h_0(), 1e-7 * start.p());
}

// One increment that unloads, crosses the elastic range and yields on the other side equals many small ones.
TEST(NorSandUpdate, CrossesTheElasticRangeInOneIncrement) {
  Specimen once = k0_specimen(NorSandParameters{}), often = k0_specimen(NorSandParameters{});
  once.strain(-0.5e-3, 1e-3, -0.5e-3, 2e-4);
  for (int i = 0; i < 2000; ++i) often.strain(-0.25e-6, 0.5e-6, -0.25e-6, 1e-7);
  EXPECT_LT(distance(once, often), 2e-3 * often.p());
  EXPECT_GT(distance(once, k0_specimen(NorSandParameters{})), 0.5 * often.p());
}

TEST(NorSandUpdate, CarriesNothingBelowSmallestPressureAndStartsAgain) {
  Specimen specimen = k0_specimen(NorSandParameters{});
  for (int i = 0; i < 20; ++i) specimen.strain(2e-4, 2e-4, 2e-4, 0.0);
  EXPECT_EQ(specimen.p(), 0.0);
  EXPECT_NEAR(specimen.e(), (1.0 + e_0) * std::exp(0.012) - 1.0, 1e-12);
  EXPECT_GT(specimen.modulus(), 0.0);
  specimen.strain(1e-5, 1e-5, 1e-5, 3e-4);
  EXPECT_EQ(specimen.stress().rz, 0.0);
  for (int i = 0; i < 100; ++i) specimen.strain(-1e-5, -4e-5, 0.0, 3e-5);
  const NorSandState state =
      NorSand(NorSandParameters{}).evaluate(specimen.stress(), specimen.e(), specimen.h_0());
  EXPECT_GT(state.p, 3e3);
  EXPECT_GT(state.q, 0.0);
  EXPECT_LT(state.yield, 1e-6);
}

// Compressed to some MPa, unloaded to 20 kPa, then sheared at constant volume: without the cap the stress
// ratio passes 2.
TEST(NorSandUpdate, InnerCapBoundsTheStressRatioAfterUnloading) {
  const auto largest_ratio = [](double cap_ratio) {
    NorSandParameters sand;
    sand.cap_ratio = cap_ratio;
    const NorSand law(sand);
    Specimen specimen = k0_specimen(sand);
    for (int i = 0; i < 400; ++i) specimen.strain(0.0, -1e-4, 0.0, 0.0);
    while (specimen.p() > 20e3) specimen.strain(1e-6, 1e-6, 1e-6, 0.0);
    double ratio = 0.0;
    for (int i = 0; i < 1000; ++i) {
      specimen.strain(0.5e-6, -1e-6, 0.5e-6, 0.0);
      const NorSandState state = law.evaluate(specimen.stress(), specimen.e(), specimen.h_0());
      ratio = std::max(ratio, state.q / state.p);
    }
    return ratio;
  };
  EXPECT_LT(largest_ratio(1.3), 1.95);
  EXPECT_GT(largest_ratio(1e6), 2.5);
}

TEST(NorSandUpdate, BadInputIsNeitherHiddenNorEndless) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), inf, -inf})
    for (std::size_t f = 0; f < OwnedBatch::field_count; ++f) {
      OwnedBatch batch(8);
      const double good[] = {-25e3, -50e3, -25e3, 0.0, e_0, 23.339e3, 1e-5, -4e-5, 1e-5, 0.0};
      for (std::size_t g = 0; g < OwnedBatch::field_count; ++g) std::fill_n(batch.field(g), 8, good[g]);
      batch.field(f)[3] = bad;
      NorSand(NorSandParameters{}).update(batch.view());
      for (std::size_t g = 0; g < 6; ++g) {
        EXPECT_FALSE(std::isfinite(batch.field(g)[3])) << "bad field " << f << ", field " << g;
        EXPECT_TRUE(std::isfinite(batch.field(g)[2]));
      }
    }
}

TEST(NorSandUpdate, WildButFiniteInputReturns) {
  std::mt19937_64 generator(11);
  std::uniform_real_distribution<double> exponent(-12.0, 12.0), sign(-1.0, 1.0);
  OwnedBatch batch(1024);
  for (std::size_t f = 0; f < OwnedBatch::field_count; ++f)
    for (std::size_t k = 0; k < 1024; ++k)
      batch.field(f)[k] = std::copysign(std::pow(10.0, exponent(generator)), sign(generator));
  NorSand(NorSandParameters{}).update(batch.view());
  for (std::size_t k = 0; k < 1024; ++k) EXPECT_FALSE(std::isinf(batch.field(5)[k]));
}

}  // namespace
}  // namespace cpt::solver

// Tresca against its closed forms, and what every return must keep.
#include "solver/constitutive/tresca.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "solver/constitutive/specimen.hpp"
#include "tests/solver/constitutive/batch_fixture.hpp"

namespace cpt::solver {
namespace {

constexpr double s_u = 27.9e3, G = 552e3, nu = 0.4995;
constexpr double K = 2.0 * G * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));

std::array<double, 3> principal(const PointStress& s) {
  const double centre = 0.5 * (s.rr + s.zz), radius = std::hypot(0.5 * (s.rr - s.zz), s.rz);
  std::array<double, 3> values = {centre + radius, centre - radius, s.tt};
  std::sort(values.rbegin(), values.rend());
  return values;
}

TEST(Tresca, BulkToShearModulusIsAThousand) { EXPECT_NEAR(K / G, 999.67, 0.01); }

TEST(Tresca, ModulusIsTheElasticOne) {
  Specimen specimen(Tresca(TrescaParameters{}), {0.0, 0.0, 0.0, 0.0}, 0.567);
  specimen.strain(1e-5, 0.0, 0.0, 0.0);
  EXPECT_NEAR(specimen.modulus(), K + 4.0 / 3.0 * G, 1e-9 * K);
}

// Constant volume compression: q = 3 G eps_a up to 2 s_u = 55.8 kPa, the two corners of the hexagon.
TEST(Tresca, TriaxialCompressionAndExtension) {
  for (const double sign : {1.0, -1.0}) {
    Specimen specimen(Tresca(TrescaParameters{}), {-25e3, -25e3, -25e3, 0.0}, 0.567);
    double eps = 0.0;
    for (int i = 0; i < 100; ++i) {
      specimen.strain(sign * 2.5e-4, -sign * 5e-4, sign * 2.5e-4, 0.0);
      eps += 5e-4;
      const double q = std::min(3.0 * G * eps, 55.8e3);
      EXPECT_NEAR(specimen.stress().rr - specimen.stress().zz, sign * q, 1e-8 * 55.8e3);
      EXPECT_NEAR(specimen.p(), 25e3, 1e-8 * 25e3);
    }
    // (p + 4 s_u / 3, p - 2 s_u / 3, p - 2 s_u / 3) in compression, and its mirror image
    EXPECT_NEAR(-specimen.stress().zz, 25e3 + sign * 4.0 / 3.0 * s_u, 1e-8 * s_u);
    EXPECT_NEAR(-specimen.stress().tt, 25e3 - sign * 2.0 / 3.0 * s_u, 1e-8 * s_u);
  }
}

// Simple shear and plane strain end on the planes of the hexagon at s_u, the middle stress at the mean.
TEST(Tresca, ShearOffTheCorners) {
  Specimen shear(Tresca(TrescaParameters{}), {-25e3, -25e3, -25e3, 0.0}, 0.567);
  for (int i = 0; i < 100; ++i) shear.strain(0.0, 0.0, 0.0, 1e-3);
  EXPECT_NEAR(shear.stress().rz, s_u, 1e-8 * s_u);
  EXPECT_NEAR(shear.stress().rr, -25e3, 1e-8 * s_u);

  Specimen plane(Tresca(TrescaParameters{}), {-25e3, -25e3, -25e3, 0.0}, 0.567);
  for (int i = 0; i < 100; ++i) plane.strain(1e-3, -1e-3, 0.0, 0.0);
  EXPECT_NEAR(plane.stress().rr, -25e3 + s_u, 1e-8 * s_u);
  EXPECT_NEAR(plane.stress().zz, -25e3 - s_u, 1e-8 * s_u);
  EXPECT_NEAR(plane.stress().tt, -25e3, 1e-8 * s_u);
}

TEST(Tresca, EveryReturnIsAdmissibleAndKeepsPressureAndDirections) {
  constexpr std::size_t n = 8192;
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> stress(-200e3, 200e3);
  OwnedBatch batch(n);
  for (std::size_t f = 0; f < 4; ++f)
    for (std::size_t k = 0; k < n; ++k)
      batch.field(f)[k] = stress(generator) * (f == 3 && k % 5 == 0 ? 0.0 : 1.0);
  OwnedBatch before(n);
  for (std::size_t f = 0; f < 4; ++f) std::copy_n(batch.field(f), n, before.field(f));
  Tresca(TrescaParameters{}).update(batch.view());
  std::size_t corners = 0, elastic = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const PointStress s = {batch.field(0)[k], batch.field(1)[k], batch.field(2)[k], batch.field(3)[k]};
    const PointStress t = {before.field(0)[k], before.field(1)[k], before.field(2)[k], before.field(3)[k]};
    const auto now = principal(s), trial = principal(t);
    ASSERT_LE(now[0] - now[2], 2.0 * s_u * (1.0 + 1e-12));
    ASSERT_NEAR(s.rr + s.zz + s.tt, t.rr + t.zz + t.tt, 1e-9 * s_u);
    ASSERT_NEAR(s.rz * (t.rr - t.zz), t.rz * (s.rr - s.zz), 1e-9 * s_u * s_u);
    ASSERT_GE(s.rz * t.rz, 0.0);
    if (trial[0] - trial[2] <= 2.0 * s_u) {
      ++elastic;
      ASSERT_EQ(s.rr, t.rr);
      ASSERT_EQ(s.rz, t.rz);
      continue;
    }
    ASSERT_NEAR(now[0] - now[2], 2.0 * s_u, 1e-9 * s_u);
    // Closest point in the octahedral plane: no admissible point of the hexagon is nearer to the trial
    // stress.
    const auto distance = [&](double a, double b, double c) {
      return std::hypot(a - trial[0], b - trial[1], c - trial[2]);
    };
    const double mean = (now[0] + now[1] + now[2]) / 3.0, nearest = distance(now[0], now[1], now[2]);
    for (double middle = -2.0 / 3.0; middle <= 2.0 / 3.0; middle += 1.0 / 60.0) {
      const double half = mean - 0.5 * middle * s_u;
      ASSERT_GE(distance(half + s_u, mean + middle * s_u, half - s_u), nearest - 1e-9 * s_u);
    }
    corners += std::min(now[0] - now[1], now[1] - now[2]) < 1e-9 * s_u;
  }
  EXPECT_GT(corners, n / 10);
  EXPECT_GT(elastic, 10U);
}

// Exchanging r and z, or the sign of shear, exchanges the answer.
TEST(Tresca, IsSymmetric) {
  std::mt19937_64 generator(9);
  std::uniform_real_distribution<double> stress(-100e3, 100e3), strain(-1e-2, 1e-2);
  for (int i = 0; i < 500; ++i) {
    const PointStress s = {stress(generator), stress(generator), stress(generator), stress(generator)};
    const double d[] = {strain(generator), strain(generator), strain(generator), strain(generator)};
    Specimen straight(Tresca(TrescaParameters{}), s, 0.567),
        swapped(Tresca(TrescaParameters{}), {s.zz, s.rr, s.tt, -s.rz}, 0.567);
    straight.strain(d[0], d[1], d[2], d[3]);
    swapped.strain(d[1], d[0], d[2], -d[3]);
    const double scale = K * 3e-2;
    EXPECT_NEAR(straight.stress().rr, swapped.stress().zz, 1e-13 * scale);
    EXPECT_NEAR(straight.stress().zz, swapped.stress().rr, 1e-13 * scale);
    EXPECT_NEAR(straight.stress().tt, swapped.stress().tt, 1e-13 * scale);
    EXPECT_NEAR(straight.stress().rz, -swapped.stress().rz, 1e-13 * scale);
  }
}

TEST(Tresca, BadInputIsNotHidden) {
  for (std::size_t f = 0; f < 4; ++f) {
    OwnedBatch batch(8);
    batch.field(f)[2] = std::nan("");
    Tresca(TrescaParameters{}).update(batch.view());
    EXPECT_TRUE(std::isnan(batch.field(f)[2])) << f;
  }
}

}  // namespace
}  // namespace cpt::solver

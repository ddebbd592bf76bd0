// Mohr-Coulomb against its closed forms, and the exactness of its return on faces, edges and corners.
#include "solver/soils/mohr_coulomb.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/constitutive/element_test.hpp"
#include "solver/soils/law.hpp"

namespace cpt::solver {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

MohrCoulombParameters soil_of(double c, double phi, double psi, double sigma_t) {
  MohrCoulombParameters soil;
  soil.c = c;
  soil.phi = phi * degree;
  soil.psi = psi * degree;
  soil.sigma_t = sigma_t;
  return soil;
}

TEST(MohrCoulomb, TriaxialCompressionFailsAndDilatesAsItShould) {
  const MohrCoulombParameters soil = soil_of(5e3, 32.0, 8.0, 0.0);
  ElementTest test;
  test.material = soil;
  test.max_axial_strain = 0.05;
  const ElementResult result = run_element_test(test);
  ASSERT_EQ(result.problem, "");
  const double s = std::sin(soil.phi), K_p = (1.0 + s) / (1.0 - s);
  const ElementRow &last = result.rows.back(), &before = result.rows[result.rows.size() - 20];
  EXPECT_NEAR(last.q, 100e3 * (K_p - 1.0) + 2.0 * soil.c * std::sqrt(K_p), 1e-4);
  const double sin_psi = std::sin(soil.psi);
  EXPECT_NEAR((last.eps_v - before.eps_v) / (last.eps_a - before.eps_a), -2.0 * sin_psi / (1.0 - sin_psi),
              1e-6);
}

TEST(MohrCoulomb, WithoutFrictionItIsTresca) {
  ElementTest test;
  test.material = soil_of(20e3, 0.0, 0.0, 1000e3);
  test.drained = false;
  test.max_axial_strain = 0.05;
  EXPECT_NEAR(run_element_test(test).rows.back().q, 40e3, 1e-5);
}

// Stretched until it parts.
TEST(MohrCoulomb, BearsItsTensileStrengthAndNoMore) {
  const MohrCoulombParameters soil = soil_of(10e3, 30.0, 0.0, 4e3);
  const auto model = MohrCoulombParameters::law().model(soil, {});
  struct Shared {
    const SoilModel* model;
    [[nodiscard]] double update(const Batch& batch) const { return model->update(batch); }
  };
  Specimen specimen(Shared{model.get()}, {-20e3, -20e3, -20e3, 0.0}, 0.6);
  for (int i = 0; i < 100; ++i) specimen.strain(0.0, 1e-4, 0.0, 0.0);
  EXPECT_NEAR(specimen.stress().zz, 4e3, 1e-6);
  for (int i = 0; i < 100; ++i) specimen.strain(1e-4, 1e-4, 1e-4, 3e-5);
  for (const double s : {specimen.stress().rr, specimen.stress().zz, specimen.stress().tt})
    EXPECT_NEAR(s, 4e3, 1e-6);
}

Eigen::Vector3d principal(const PointStress& s) {
  const double centre = 0.5 * (s.rr + s.zz), radius = std::hypot(0.5 * (s.rr - s.zz), s.rz);
  return {centre + radius, centre - radius, s.tt};
}

// Largest violation of the yield surface [Pa].
double violation(const MohrCoulombParameters& soil, const Eigen::Vector3d& s) {
  double largest = s.maxCoeff() - soil.sigma_t;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j)
        largest = std::max(largest, s(i) * (1.0 + std::sin(soil.phi)) - s(j) * (1.0 - std::sin(soil.phi)) -
                                        2.0 * soil.c * std::cos(soil.phi));
  return largest;
}

// With associated flow the return is the point of the surface nearest in the energy norm: for every y inside,
// (y - r) . D^-1 (trial - r) <= 0. Checked for trials that return to faces, edges and corners.
TEST(MohrCoulomb, TheReturnIsTheNearestPoint) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0.0, 60e3);
  int returned = 0;
  for (const double c : {0.0, 8e3})
    for (const double phi : {20.0, 38.0}) {
      const MohrCoulombParameters soil = soil_of(c, phi, phi, 0.4 * c / std::tan(phi * degree));
      const auto model = MohrCoulombParameters::law().model(soil, {});
      const double G = soil.E / (2.0 * (1.0 + soil.nu));
      const double lame = soil.E * soil.nu / ((1.0 + soil.nu) * (1.0 - 2.0 * soil.nu));
      const Eigen::Matrix3d D = 2.0 * G * Eigen::Matrix3d::Identity() + Eigen::Matrix3d::Constant(lame);
      for (int n = 0; n < 400; ++n) {
        // All of the trial stress comes from the strain; the hoop stress takes each rank.
        const Eigen::Vector3d trial{normal(random) - 20e3, normal(random) - 20e3, normal(random) - 20e3};
        const Eigen::Vector3d strain = D.inverse() * trial;
        alignas(64) double f[11][batch_width] = {};
        for (std::size_t k = 0; k < batch_width; ++k)
          for (int i = 0; i < 3; ++i) f[6 + i][k] = strain(i);
        (void)model->update({batch_width, f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10]});
        const Eigen::Vector3d r{f[0][0], f[1][0], f[2][0]};
        ASSERT_LT(violation(soil, r), 1e-6) << trial.transpose();
        if (violation(soil, trial) <= 0.0) {
          ASSERT_LT((r - trial).norm(), 1e-6);
          continue;
        }
        ++returned;
        const Eigen::Vector3d gradient = D.inverse() * (trial - r);
        for (int m = 0; m < 50; ++m) {
          Eigen::Vector3d y{normal(random), normal(random), normal(random)};
          for (int halvings = 0; violation(soil, y) > 0.0 && halvings < 60; ++halvings)
            y = 0.5 * y - Eigen::Vector3d::Constant(30e3);  // towards compression, which is inside
          if (violation(soil, y) > 0.0) continue;
          ASSERT_LT((y - r).dot(gradient), 1e-6 * (1.0 + gradient.norm() * (y - r).norm()))
              << "c " << c << " phi " << phi << " trial " << trial.transpose() << " returned "
              << r.transpose();
        }
      }
    }
  EXPECT_GT(returned, 800);
}

// Turned in the plane, the same stress and strain give the same invariants.
TEST(MohrCoulomb, DoesNotKnowDirections) {
  const auto model = MohrCoulombParameters::law().model(soil_of(2e3, 30.0, 5.0, 0.0), {});
  struct Shared {
    const SoilModel* model;
    [[nodiscard]] double update(const Batch& batch) const { return model->update(batch); }
  };
  Specimen straight(Shared{model.get()}, {-30e3, -70e3, -40e3, 0.0}, 0.6);
  Specimen turned(Shared{model.get()}, {-50e3, -50e3, -40e3, 20e3}, 0.6);  // by 45 degrees
  for (int i = 0; i < 50; ++i) {
    straight.strain(1e-4, -2e-4, 5e-5, 0.0);
    turned.strain(-5e-5, -5e-5, 5e-5, 1.5e-4);
  }
  EXPECT_LT((principal(straight.stress()) - principal(turned.stress())).norm(), 1e-5);
}

}  // namespace
}  // namespace cpt::solver

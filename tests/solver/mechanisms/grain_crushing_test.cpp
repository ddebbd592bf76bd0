#include "solver/mechanisms/grain_crushing.hpp"

#include <gtest/gtest.h>

#include "solver/constitutive/critical_state_line.hpp"
#include "solver/constitutive/element_test.hpp"
#include "solver/constitutive/norsand.hpp"

namespace cpt::solver {
namespace {

constexpr GrainCrushing crushing{0.10, 200e3};

// Drained triaxial compression at a cell pressure far above the crushing pressure ends on the steeper branch.
TEST(GrainCrushing, EndsOnTheSteeperBranch) {
  NorSandParameters sand;
  sand.substep_tolerance = 1e-6;
  const double cell = 500e3, e_0 = 0.75;
  const NorSand law(sand, crushing);
  Specimen specimen(law, {-cell, -cell, -cell, 0.0}, e_0,
                    law.initial_image_pressure(-cell, -cell, -cell, 0.0, e_0));
  double radial = 0.0;
  for (int i = 0; i < 6000; ++i) {
    const auto found = drained_radial_strain(specimen, 3e-4, cell, radial);
    ASSERT_TRUE(found.has_value());
    radial = *found;
    specimen.strain(-radial, -3e-4, -radial, 0.0);
  }
  const CriticalStateLine line(sand, crushing);
  EXPECT_NEAR(specimen.e(), line.void_ratio(specimen.p()), 1e-3);
  EXPECT_GT(CriticalStateLine(sand).void_ratio(specimen.p()) - specimen.e(), 0.1);
}

TEST(GrainCrushing, TheLineIsContinuousAndItsSlopeConsistent) {
  const CriticalStateLine line(NorSandParameters{}, crushing);
  EXPECT_NEAR(line.void_ratio(200e3 * (1.0 - 1e-9)), line.void_ratio(200e3 * (1.0 + 1e-9)), 1e-8);
  for (const double p : {100e3, 150e3, 300e3, 900e3}) {
    const double numerical = (line.void_ratio(p * 0.9999) - line.void_ratio(p * 1.0001)) / 2e-4;
    EXPECT_NEAR(line.slope(p), numerical, 1e-6);
  }
}

// Below the crushing pressure nothing changes, bit for bit.
TEST(GrainCrushing, IsNothingBelowItsPressure) {
  const double p = 50e3, e = 0.75;
  const NorSand plain{NorSandParameters{}}, with(NorSandParameters{}, {0.10, 10e6});
  const double p_i = plain.initial_image_pressure(-p, -p, -p, 0.0, e);
  Specimen a(plain, {-p, -p, -p, 0.0}, e, p_i), b(with, {-p, -p, -p, 0.0}, e, p_i);
  for (int i = 0; i < 200; ++i) {
    a.strain(1e-4, -3e-4, 1e-4, 2e-5);
    b.strain(1e-4, -3e-4, 1e-4, 2e-5);
    ASSERT_EQ(a.stress().zz, b.stress().zz);
    ASSERT_EQ(a.h_0(), b.h_0());
  }
}

}  // namespace
}  // namespace cpt::solver

// Element tests of each material: what the command `element` shows.
#include "solver/constitutive/element_test.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::solver {
namespace {

TEST(ElementTest, ElasticOedometerAndTriaxial) {
  ElementTest test;
  test.material = Elastic{10e6, 0.25};
  test.max_axial_strain = 1e-2;
  test.steps = 10;
  test.path = ElementPath::oedometer;
  const ElementRow oedometer = run_element_test(test).rows.back();
  EXPECT_NEAR(oedometer.p - 100e3, 1e-2 * 10e6 / (3.0 * (1.0 - 2.0 * 0.25)), 1e-6);
  EXPECT_NEAR(oedometer.q, 1e-2 * 10e6 / 1.25, 1e-6);
  EXPECT_NEAR(oedometer.eps_v, 1e-2, 1e-15);
  EXPECT_TRUE(std::isnan(oedometer.psi));

  test.path = ElementPath::triaxial;
  const ElementRow triaxial = run_element_test(test).rows.back();
  EXPECT_NEAR(triaxial.q, 1e-2 * 10e6, 1e-4);
  EXPECT_NEAR(triaxial.eps_v, 1e-2 * (1.0 - 2.0 * 0.25), 1e-12);

  test.path = ElementPath::isotropic;
  const ElementRow isotropic = run_element_test(test).rows.back();
  EXPECT_EQ(isotropic.q, 0.0);
  EXPECT_NEAR(isotropic.p - 100e3, 3e-2 * 10e6 / 1.5, 1e-6);
}

TEST(ElementTest, ClayFailsAtTwiceItsStrengthDrainedAndUndrained) {
  for (const bool drained : {true, false}) {
    ElementTest test;
    test.material = TrescaParameters{};
    test.drained = drained;
    test.max_axial_strain = 0.10;
    const ElementResult result = run_element_test(test);
    ASSERT_EQ(result.problem, "");
    EXPECT_NEAR(result.rows.back().q, 55.8e3, 1e-3);
    EXPECT_NEAR(result.rows.front().e, 0.362 / 0.638, 1e-12);
    EXPECT_NEAR(result.rows.back().p, drained ? 100e3 + 55.8e3 / 3.0 : 100e3, 1e-3);
  }
}

TEST(ElementTest, StartsFromTheRelativeDensityUnlessToldOtherwise) {
  ElementTest test;
  EXPECT_NEAR(run_element_test(test).rows.front().e, 0.76832, 1e-12);
  test.e_0 = 0.65;
  test.h_0 = 60e3;
  const ElementRow first = run_element_test(test).rows.front();
  EXPECT_EQ(first.e, 0.65);
  EXPECT_EQ(first.h_0, 60e3);
}

TEST(ElementTest, StopsAtTheLargestStress) {
  ElementTest test;
  test.path = ElementPath::oedometer;
  test.sigma_a = 20e3;
  test.sigma_r = 10e3;
  test.max_axial_stress = 1e6;
  test.steps = 1000;
  const ElementResult result = run_element_test(test);
  const auto axial = [](const ElementRow& row) { return row.p + 2.0 / 3.0 * row.q; };
  EXPECT_GE(axial(result.rows.back()), 1e6);
  EXPECT_LT(axial(result.rows[result.rows.size() - 2]), 1e6);
}

// Volumetric strain and void ratio tell the same story.
TEST(ElementTest, VoidRatioAndVolumetricStrainAgree) {
  const ElementResult result = run_element_test(ElementTest{});
  for (const ElementRow& row : result.rows) EXPECT_NEAR(row.e, 1.76832 * std::exp(-row.eps_v) - 1.0, 1e-9);
}

TEST(ElementTest, EndsWhereNoVoidsAreLeft) {
  ElementTest test;
  test.path = ElementPath::isotropic;
  test.max_axial_strain = 0.5;
  const ElementResult result = run_element_test(test);
  EXPECT_NE(result.problem.find("no voids are left"), std::string::npos) << result.problem;
  ASSERT_GT(result.rows.size(), 2u);
  for (const ElementRow& row : result.rows) EXPECT_GT(row.e, 0.0);
}

TEST(ElementTest, SaysWhatIsWrong) {
  ElementTest test;
  test.sigma_r = 0.0;
  EXPECT_NE(run_element_test(test).problem, "");
  EXPECT_TRUE(run_element_test(test).rows.empty());
}

}  // namespace
}  // namespace cpt::solver

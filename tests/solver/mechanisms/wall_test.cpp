// The compliant wall between its limits, and wall friction in equilibrium.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/chamber.hpp"
#include "solver/soils/elastic.hpp"
#include "tests/solver/default_soils.hpp"
#include "tests/solver/mechanisms/mechanism_fixture.hpp"

namespace cpt::solver {
namespace {

TEST(CompliantWall, GapClosesThenStiffens) {
  const CompliantWall wall{1e-8, 2e-4};
  EXPECT_EQ(wall.stress(1e-4), 0.0);
  EXPECT_EQ(wall.stress(-1e-3), 0.0);
  EXPECT_NEAR(wall.stress(7e-4), 5e4, 1e-6);
}

TEST(CompliantWall, DisplacementFollowsTheNodes) {
  WallDisplacement displacement(1.0);
  const std::vector<double> z = {-1.0, -0.6, -0.25, 0.0};
  std::vector<double> v_r;
  for (const double at : z) v_r.push_back(2.0 + 3.0 * at);  // linear, so that interpolation is exact
  for (int i = 0; i < 10; ++i) displacement.add(z, v_r, 0.01);
  for (const double at : {-0.97, -0.5, -0.123, -0.004})
    EXPECT_NEAR(displacement.at(at), 0.1 * (2.0 + 3.0 * at), 1e-12);
}

// Between the constant-stress wall (infinite compliance) and the rigid one (none).
TEST(CompliantWall, LiesBetweenItsLimits) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.06);
  setup.chamber.radius = 0.12;  // where the wall matters soon
  const auto q_c = [](const solver::Setup& s) { return mean_q_c(run(s), 0.04, 0.06); };
  const double rigid = q_c(setup);
  solver::Setup flexible = setup, soft = setup, stiff = setup, between = setup;
  flexible.chamber.wall = Wall::flexible;
  soft.mechanisms.compliant_wall.compliance = 1e-5;
  stiff.mechanisms.compliant_wall.compliance = 1e-11;
  between.mechanisms.compliant_wall.compliance = 1e-8;
  const double least = q_c(flexible), middle = q_c(between);
  EXPECT_LT(least, 0.97 * rigid);
  EXPECT_NEAR(q_c(soft), least, 5e-3 * least);
  EXPECT_NEAR(q_c(stiff), rigid, 0.01 * rigid);
  EXPECT_GT(middle, 1.01 * least);
  EXPECT_LT(middle, 0.99 * rigid);
}

// Before the push: the nodal forces that friction on the wall leaves are far below those it adds.
TEST(WallFriction, StartsInEquilibrium) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.1);
  const auto largest_force = [&](double coefficient, bool with_wall) {
    setup.mechanisms.wall_friction.coefficient = coefficient;
    SoilModels soils = models_of(setup);
    soils.push_back(elastic_soil(setup.chamber.surcharge_E, setup.chamber.surcharge_nu));
    const InitialState state = initial_state(setup, soils);
    ModelSettings settings;
    settings.materials = static_cast<std::int32_t>(soils.size());
    settings.weight_ratio[0] = bulk(setup, default_sand).weight_ratio;
    Model model(Mesh(chamber_layout(setup)), state.points, state.material, std::move(soils), settings);
    model.compute_nodal_forces();
    ChamberBoundary chamber(setup, model.mesh());
    if (with_wall) chamber.apply_wall_stress(model);
    // Vertical force over mass times gravity, on the wall between top and bottom.
    double largest = 0.0;
    for (const std::int32_t n : model.mesh().wall_nodes()) {
      const double z = model.mesh().node_z(n);
      if (z < -0.1 && z > -0.9)
        largest = std::max(largest, std::abs(model.nodes().force.z[n]) / (model.nodes().mass[n] * gravity));
    }
    return largest;
  };
  const double without = largest_force(0.4, false), with = largest_force(0.4, true);
  EXPECT_LT(with, 0.1 * without);
}

}  // namespace
}  // namespace cpt::solver

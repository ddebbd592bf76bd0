// Larger cones. Without weight nothing has a length of its own but the cone (Buckingham 1914, Phys. Rev. 4,
// 345): in a chamber as many times as large a larger cone meets the same resistance as many times as deep, if
// mesh, zones, points and start grow with it. The surcharge is a traction here, as a layer's weight and
// inertia do not scale.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/presets.hpp"
#include "solver/simulate.hpp"

namespace cpt::solver {
namespace {

// A push to four radii with all lengths but the mesh's `larger` times those of a cone of 25.3 mm.
Outcome pushed(Profile profile, double larger) {
  solver::Setup setup = make_setup(profile, Preset::quick);
  setup.initial.self_weight = SelfWeight::none;
  setup.chamber.surcharge = SurchargeKind::traction;
  setup.layers = {{0.0, larger, profile == Profile::homogeneous_sand ? default_sand : default_clay}};
  if (profile == Profile::layered_sand_clay)
    setup.layers = {{0.0, 0.03 * larger, default_sand}, {0.03 * larger, larger, default_clay}};
  setup.penetrometer.diameter *= larger;
  setup.penetrometer.final_depth = 0.05 * larger;
  setup.penetrometer.sleeve_length *= larger;
  for (double* length : {&setup.chamber.radius, &setup.chamber.soil_height, &setup.chamber.surcharge_height,
                         &setup.numerics.bin_height})
    *length *= larger;
  Observer observer;
  Outcome outcome = simulate(setup, observer);
  EXPECT_EQ(outcome.status, Status::completed) << outcome.reason;
  return outcome;
}

TEST(ConeSize, TwiceTheConeInTwiceTheChamberGivesTheSameBits) {
  for (const Profile profile :
       {Profile::homogeneous_sand, Profile::homogeneous_clay, Profile::layered_sand_clay}) {
    const Outcome reference = pushed(profile, 1.0), twice = pushed(profile, 2.0);
    EXPECT_EQ(twice.steps, reference.steps);
    ASSERT_GT(reference.profile.q_c.size(), 40u);
    EXPECT_EQ(twice.profile.q_c, reference.profile.q_c);
    EXPECT_EQ(twice.profile.f_s, reference.profile.f_s);
  }
}

TEST(ConeSize, StandardConesMeetTheResistanceOfTheReference) {
  for (const Profile profile : {Profile::homogeneous_clay, Profile::layered_sand_clay}) {
    const Outcome reference = pushed(profile, 1.0);
    const std::vector<double>& q_c = reference.profile.q_c;
    for (const double area : {10e-4, 15e-4}) {
      const double larger = std::sqrt(4.0 * area / std::numbers::pi) / 0.0253;
      const Outcome outcome = pushed(profile, larger);
      EXPECT_EQ(outcome.material_points, reference.material_points);
      ASSERT_EQ(outcome.profile.q_c.size(), q_c.size());
      for (std::size_t k = 0; k < q_c.size(); ++k)
        EXPECT_NEAR(outcome.profile.q_c[k], q_c[k], 0.01 * q_c.back()) << area << " " << k;
    }
  }
}

}  // namespace
}  // namespace cpt::solver

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include "solver/presets.hpp"
#include "solver/quantities.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::solver {
namespace {

TEST(Problems, PresetsHaveNone) {
  for (const Profile profile : all_profiles())
    for (const Preset preset : all_presets()) {
      const auto found = problems(make_setup(profile, preset));
      EXPECT_TRUE(found.empty()) << to_string(profile) << " " << to_string(preset) << " " << found[0].message;
    }
}

TEST(Problems, NameTheQuantityOutOfRange) {
  for (const Quantity& q : all_quantities()) {
    if (!q.choices.empty() || q.integer) continue;
    for (const double value : {q.min - 0.001 * (q.max - q.min), q.max + 0.001 * (q.max - q.min), std::nan(""),
                               static_cast<double>(INFINITY)}) {
      solver::Setup setup = make_setup(Profile::layered_sand_clay, Preset::quick);
      q.set_value(setup, value);
      const auto found = problems(setup);
      ASSERT_EQ(found.size(), 1u) << q.name;
      EXPECT_EQ(found[0].quantity, q.name);
      EXPECT_NE(found[0].message.find(q.name), std::string::npos) << found[0].message;
    }
  }
}

struct Impossible {
  const char* quantity;
  const char* message;  // part of it
  std::function<void(solver::Setup&)> change;
};

TEST(Problems, ImpossibleSetups) {
  const std::vector<Impossible> table = {
      {"sand.e_min", "sand.e_max = 0.89", [](solver::Setup& s) { sand_of(s).e_min = 0.95; }},
      {"sand.e_min_star", "0.3100",
       [](solver::Setup& s) { sand_of(s).e_min = 0.3, sand_of(s).D_r = 0.983, sand_of(s).e_min_star = 0.4; }},
      {"sand.p_min_kPa", "sand.p_min_kPa = 4",
       [](solver::Setup& s) {
         sand_of(s).p_min = 4.0e3, s.initial.sigma_v0 = 3.0e3, s.initial.sigma_h0 = 3.0e3;
       }},
      {"sand.e_cs0", "must exceed",
       [](solver::Setup& s) {
         sand_of(s).lambda = 0.1, sand_of(s).e_cs0 = 0.5, sand_of(s).e_min_star = 0.48;
       }},
      {"initial.sigma_h0_kPa", "K_0 = 0.2", [](solver::Setup& s) { s.initial.sigma_h0 = 10.0e3; }},
      {"initial.sigma_h0_kPa", "K_0 = 6",
       [](solver::Setup& s) { s.initial.sigma_h0 = 300.0e3, clay_of(s).s_u = 900.0e3; }},
      {"initial.sigma_h0_kPa", "clay.s_u_kPa = 12", [](solver::Setup& s) { clay_of(s).s_u = 12.0e3; }},
      // Of 50 kPa on top its friction leaves about 36 at 0.23 m: 9 kPa of K_0 with 13 of friction.
      {"wall_friction.coefficient", "clay.s_u_kPa = 14",
       [](solver::Setup& s) { clay_of(s).s_u = 14.0e3, s.mechanisms.wall_friction.coefficient = 0.7; }},
      {"layers", "no layer", [](solver::Setup& s) { s.layers.clear(); }},
      {"layers", "starts at 0.01 m", [](solver::Setup& s) { s.layers.front().top = 0.01; }},
      {"layers", "starts at 0.23 m", [](solver::Setup& s) { s.layers.front().bottom = 0.22; }},
      {"layers", "no thickness", [](solver::Setup& s) { s.layers[1].bottom = s.layers[2].top = 0.23; }},
      {"layers", "chamber.soil_height_m = 1", [](solver::Setup& s) { s.layers.back().bottom = 0.9; }},
      {"layers", "starts at", [](solver::Setup& s) { s.layers[2].top = std::nan(""); }},
      {"chamber.radius_m", "penetrometer.diameter_m",
       [](solver::Setup& s) { s.chamber.radius = 0.1, s.penetrometer.diameter = 0.055; }},
      {"numerics.near_width_radius_m", "chamber.radius_m = 0.45",
       [](solver::Setup& s) { s.numerics.near_width_radius = 0.5; }},
      {"numerics.refinement", "is 2.5", [](solver::Setup& s) { s.numerics.refinement = 1.25; }},
      {"numerics.refinement", "is 32: the elements",
       [](solver::Setup& s) { s.numerics.refinement = 8.0, s.numerics.face_elements = 4; }},
      {"numerics.near_height_m", "numerics.point_density = 0.25",
       [](solver::Setup& s) { s.numerics.point_density = 0.25; }},
      {"penetrometer.final_depth_m", "0.0219 m", [](solver::Setup& s) { s.penetrometer.final_depth = 0.02; }},
      {"penetrometer.final_depth_m", "no room", [](solver::Setup& s) { s.penetrometer.final_depth = 0.88; }},
      {"numerics.zones", "no zone", [](solver::Setup& s) { s.numerics.zones.clear(); }},
      {"numerics.zones", "must exceed 0.01265",
       [](solver::Setup& s) { s.numerics.zones[0].outer_radius = 0.01; }},
      {"numerics.zones", "must exceed 0.08",
       [](solver::Setup& s) { s.numerics.zones[2].outer_radius = 0.08; }},
      {"numerics.zones", "must exceed",
       [](solver::Setup& s) { s.numerics.zones[3].outer_radius = std::nan(""); }},
      {"numerics.zones", "0 columns", [](solver::Setup& s) { s.numerics.zones[1].columns = 0; }},
      {"numerics.zones", "rows per metre",
       [](solver::Setup& s) { s.numerics.zones[1].rows_per_metre = std::nan(""); }},
      {"numerics.near_height_m", "empty", [](solver::Setup& s) { s.numerics.near_height = 0.003; }},
      {"numerics.above_height_m", "empty", [](solver::Setup& s) { s.numerics.above_height = 0.003; }},
      {"numerics.below_height_m", "penetrometer.final_depth_m = 0.33",
       [](solver::Setup& s) { s.numerics.below_height = 0.006; }},
      {"numerics.face_elements", "wide", [](solver::Setup& s) { s.numerics.face_elements = 8; }},
  };
  for (const Impossible& impossible : table) {
    solver::Setup setup = make_setup(Profile::layered_sand_clay, Preset::quick);
    impossible.change(setup);
    const auto found = problems(setup);
    ASSERT_FALSE(found.empty()) << impossible.quantity << " " << impossible.message;
    EXPECT_EQ(found[0].quantity, impossible.quantity) << found[0].message;
    EXPECT_NE(found[0].message.find(impossible.message), std::string::npos)
        << impossible.message << " is not in: " << found[0].message;
    EXPECT_EQ(found.size(), 1u) << found.back().message;
  }
}

// The stress ratio that NorSand bears is M_itc - chi_i psi_i in compression, M_i follows the Lode angle in
// extension.
TEST(Problems, BoundsOnK0OfSand) {
  const auto borne = [](double K_0, double D_r) {
    solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::quick);
    sand_of(setup).D_r = D_r;
    setup.initial.sigma_h0 = K_0 * setup.initial.sigma_v0;
    return problems(setup).empty();
  };
  // D_r = 36 %: psi about -0.13, so q/p' up to 1.17 + 2.7 * 0.13 = 1.5, K_0 from (3 - 1.5) / (3 + 2 * 1.5) =
  // 0.25.
  EXPECT_TRUE(borne(0.28, 0.36));
  EXPECT_FALSE(borne(0.22, 0.36));
  EXPECT_TRUE(borne(0.22, 0.80));   // dense sand bears more
  EXPECT_FALSE(borne(0.30, 0.01));  // loose sand little more than M_tc = 1.2
  EXPECT_TRUE(borne(2.5, 0.36));
  EXPECT_FALSE(borne(8.0, 0.36));
}

// What the refusal offers is taken, and little beyond it refused.
TEST(Problems, ARefusedK0NamesTheHorizontalStressesThatDo) {
  for (const Profile profile : {Profile::homogeneous_sand, Profile::homogeneous_clay}) {
    solver::Setup setup = make_setup(profile, Preset::quick);
    setup.initial.sigma_h0 = 8.0 * setup.initial.sigma_v0;
    const auto found = problems(setup);
    ASSERT_EQ(found.size(), 1u);
    const std::string& message = found[0].message;
    const std::string offer = "; initial.sigma_h0_kPa may be ";
    const std::size_t at = message.find(offer);
    ASSERT_NE(at, std::string::npos) << message;
    double least = 0.0, most = 0.0;
    ASSERT_EQ(std::sscanf(message.c_str() + at + offer.size(), "%lf to %lf", &least, &most), 2) << message;
    const auto borne = [&](double kPa) {
      setup.initial.sigma_h0 = kPa * 1e3;
      return problems(setup).empty();
    };
    EXPECT_LT(least, most);
    EXPECT_TRUE(borne(least)) << message;
    EXPECT_TRUE(borne(most)) << message;
    EXPECT_FALSE(borne(least - 0.2)) << message;
    EXPECT_FALSE(borne(most + 0.2)) << message;
  }
}

TEST(Problems, OnlySoilsOfTheProfileAreJudged) {
  solver::Setup setup = make_setup(Profile::homogeneous_clay, Preset::quick);
  sand_of(setup).e_min = 0.95;
  EXPECT_TRUE(problems(setup).empty());
  setup = make_setup(Profile::homogeneous_sand, Preset::quick);
  clay_of(setup).s_u = 1.0e3;
  EXPECT_TRUE(problems(setup).empty());
}

TEST(Problems, AChamberMayBeNarrowerThanTheZones) {
  for (const Preset preset : all_presets()) {
    solver::Setup setup = make_setup(Profile::homogeneous_sand, preset);
    for (const double radius : {0.30, 0.22, 0.15, 0.8}) {
      setup.chamber.radius = radius;
      EXPECT_TRUE(problems(setup).empty()) << to_string(preset) << " " << radius;
    }
  }
}

TEST(Problems, OfLengthsThatGrowWithTheConeSayWhatTheyAreThere) {
  solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::quick);
  setup.penetrometer.diameter = 2.0 * 0.0253;
  setup.numerics.near_width_radius = 0.24;
  const auto found = problems(setup);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(
      found[0].message,
      "numerics.near_width_radius_m = 0.24 (0.48 m at this cone) must be below chamber.radius_m = 0.45");
}

}  // namespace
}  // namespace cpt::solver

// Setups that name soils of their own, several of one law among them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/mechanisms/catalogue.hpp"
#include "solver/presets.hpp"
#include "solver/quantities.hpp"
#include "solver/simulate.hpp"
#include "solver/soils/law.hpp"

namespace cpt::solver {
namespace {

solver::Setup two_sands_and_a_clay() {
  solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::quick);
  setup.soils = {
      {"loose", NorSandParameters{}}, {"dense", NorSandParameters{}}, {"soft", TrescaParameters{}}};
  as<NorSandParameters>(setup.soils[1]).D_r = 0.8;
  setup.layers = {{0.0, 0.05, 0}, {0.05, 0.10, 2}, {0.10, 1.0, 1}};
  setup.penetrometer.final_depth = 0.03;
  return setup;
}

Outcome run(const solver::Setup& setup, int threads = 1) {
  Observer observer;
  return simulate(setup, observer, {threads});
}

TEST(SeveralSoils, HaveQuantitiesOfTheirOwn) {
  solver::Setup setup = two_sands_and_a_clay();
  EXPECT_TRUE(problems(setup).empty());
  find_quantity("dense.H", setup)->set_value(setup, 75.0);
  EXPECT_EQ(as<NorSandParameters>(setup.soils[1]).H, 75.0);
  EXPECT_EQ(as<NorSandParameters>(setup.soils[0]).H, 25.0);
  EXPECT_EQ(find_quantity("dense.H", setup), find_quantity("dense.H", two_sands_and_a_clay()));
  EXPECT_EQ(find_quantity("sand.H", setup), nullptr);
  EXPECT_EQ(find_quantity("dense.s_u_kPa", setup), nullptr);
  EXPECT_EQ(find_quantity("sand.H", solver::Setup{}), find_quantity("sand.H"));
}

TEST(SeveralSoils, AreInTheSettingsWhereTheyAreNotTheDefaults) {
  const std::string text = canonical_text(two_sands_and_a_clay());
  EXPECT_NE(text.find("soils = loose norsand\nsoils = dense norsand\nsoils = soft tresca\n"),
            std::string::npos);
  EXPECT_NE(text.find("dense.D_r_percent = 80\n"), std::string::npos);
  EXPECT_NE(text.find("layers = 0.05 to 0.1 soft\n"), std::string::npos);
  EXPECT_EQ(text.find("sand."), std::string::npos);
  EXPECT_EQ(canonical_text(solver::Setup{}).find("soils"), std::string::npos);
}

TEST(SeveralSoils, PushTheSameBitsOnAnyNumberOfThreads) {
  const Outcome one = run(two_sands_and_a_clay(), 1), three = run(two_sands_and_a_clay(), 3);
  ASSERT_EQ(one.status, Status::completed) << one.reason;
  EXPECT_EQ(one.profile.q_c, three.profile.q_c);
  EXPECT_EQ(one.profile.f_s, three.profile.f_s);
}

// Two soils of the same parameters are one, but that they may strain apart in the cells they share.
TEST(SeveralSoils, OfTheSameParametersAreOneSoil) {
  solver::Setup one = make_setup(Profile::homogeneous_sand, Preset::quick);
  one.penetrometer.final_depth = 0.025;
  one.layers = {{0.0, 0.03, default_sand}, {0.03, 1.0, default_sand}};
  solver::Setup two = one;
  two.soils = {{"upper", NorSandParameters{}}, {"lower", NorSandParameters{}}};
  two.layers = {{0.0, 0.03, 0}, {0.03, 1.0, 1}};
  const Outcome a = run(one), b = run(two);
  ASSERT_EQ(a.profile.q_c.size(), b.profile.q_c.size());
  for (std::size_t k = 0; k < a.profile.q_c.size(); ++k)
    EXPECT_NEAR(b.profile.q_c[k], a.profile.q_c[k], 3e-3 * std::abs(a.profile.q_c[k])) << a.profile.depth[k];
}

TEST(SeveralSoils, EveryLawPushes) {
  for (const Law* law : all_laws()) {
    solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::quick);
    setup.soils = {{"soil", law->defaults()}};
    setup.layers = {{0.0, 1.0, 0}};
    setup.penetrometer.final_depth = 0.026;
    ASSERT_TRUE(problems(setup).empty()) << law->name() << ": " << problems(setup).front().message;
    const Outcome outcome = run(setup);
    EXPECT_EQ(outcome.status, Status::completed) << law->name() << ": " << outcome.reason;
    EXPECT_GT(outcome.profile.q_c.back(), 1.5 * setup.initial.sigma_v0) << law->name();
  }
}

TEST(SeveralSoils, MechanismsActOnTheirLaws) {
  solver::Setup setup = two_sands_and_a_clay();
  const auto acts = [&](std::string_view name) { return applies(*find_mechanism(name), setup); };
  EXPECT_TRUE(acts("overconsolidation"));
  EXPECT_TRUE(acts("strain_softening"));
  EXPECT_TRUE(acts("interface_mixing"));
  setup.layers = {{0.0, 1.0, 2}};
  EXPECT_FALSE(acts("overconsolidation"));
  EXPECT_TRUE(acts("strain_softening"));
  EXPECT_FALSE(acts("interface_mixing"));
  EXPECT_FALSE(matters(*find_quantity("dense.H", setup), setup));
  EXPECT_FALSE(matters(*find_quantity("contact.friction_ratio", setup), setup));
  EXPECT_TRUE(matters(*find_quantity("contact.adhesion_ratio", setup), setup));
}

TEST(SeveralSoils, WhatIsWrongWithThemIsSaid) {
  solver::Setup setup = two_sands_and_a_clay();
  setup.soils[1].name = "loose";
  ASSERT_EQ(problems(setup).size(), 1U);
  EXPECT_EQ(problems(setup)[0].message, "two soils are called loose");
  setup = two_sands_and_a_clay();
  as<NorSandParameters>(setup.soils[1]).e_min = 0.95;
  ASSERT_FALSE(problems(setup).empty());
  EXPECT_EQ(problems(setup)[0].quantity, "dense.e_min");
  setup = two_sands_and_a_clay();
  for (int k = 0; k < 5; ++k) setup.soils.push_back({"more" + std::to_string(k), TrescaParameters{}});
  EXPECT_NE(problems(setup).at(0).message.find("8 soils are more than the 7"), std::string::npos);
  setup = two_sands_and_a_clay();
  setup.layers[1].soil = 9;
  EXPECT_EQ(problems(setup).at(0).quantity, "soils");
}

}  // namespace
}  // namespace cpt::solver

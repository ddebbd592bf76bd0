#include "solver/mechanisms/catalogue.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/solver/mechanisms/mechanism_fixture.hpp"

namespace cpt::solver {
namespace {

TEST(Catalogue, EveryMechanismIsOffByDefaultAndDescribesItself) {
  const solver::Setup defaults;
  std::set<std::string_view> names;
  for (const Mechanism& mechanism : all_mechanisms()) {
    EXPECT_TRUE(names.insert(mechanism.name).second) << mechanism.name;
    EXPECT_FALSE(is_on(mechanism, defaults)) << mechanism.name;
    for (const std::string_view text :
         {mechanism.title, mechanism.equation, mechanism.source, mechanism.signature})
      EXPECT_FALSE(text.empty()) << mechanism.name;
    ASSERT_FALSE(mechanism.parameters.empty());
    EXPECT_EQ(mechanism.parameters.front().quantity.get(defaults), 0.0) << mechanism.name;
    for (const MechanismParameter& parameter : mechanism.parameters) {
      const Quantity& quantity = parameter.quantity;
      EXPECT_EQ(quantity.name.substr(0, mechanism.name.size() + 1), std::string(mechanism.name) + ".");
      EXPECT_TRUE(is_mechanism_parameter(quantity.name));
      EXPECT_LE(parameter.prior_lower, parameter.prior_upper) << quantity.name;
      EXPECT_GE(parameter.prior_lower, quantity.min) << quantity.name;
      EXPECT_LE(parameter.prior_upper, quantity.max) << quantity.name;
      ASSERT_NE(find_quantity(quantity.name), nullptr) << quantity.name;
    }
  }
  EXPECT_GE(names.size(), 14U);
  EXPECT_FALSE(is_mechanism_parameter("sand.H"));
}

TEST(Catalogue, AMechanismThatIsOffLeavesNoTrace) {
  const solver::Setup defaults;
  const std::string text = canonical_text(defaults);
  for (const Mechanism& mechanism : all_mechanisms()) {
    EXPECT_EQ(text.find(mechanism.name), std::string::npos) << mechanism.name;
    solver::Setup on = defaults;
    const Quantity& strength = mechanism.parameters.front().quantity;
    strength.set_value(on, mechanism.parameters.front().prior_upper);
    EXPECT_TRUE(is_on(mechanism, on));
    EXPECT_NE(canonical_text(on).find(strength.name), std::string::npos) << mechanism.name;
  }
}

TEST(Catalogue, MechanismsAskForTheirSoil) {
  const solver::Setup sand = make_setup(Profile::homogeneous_sand, Preset::quick);
  const solver::Setup layered = make_setup(Profile::layered_sand_clay, Preset::quick);
  EXPECT_TRUE(applies(*find_mechanism("surface_compaction"), sand));
  EXPECT_FALSE(applies(*find_mechanism("strain_softening"), sand));
  EXPECT_FALSE(applies(*find_mechanism("interface_mixing"), sand));
  for (const Mechanism& mechanism : all_mechanisms())
    EXPECT_TRUE(applies(mechanism, layered)) << mechanism.name;
}

// Every mechanism at the strongest end of its prior still runs and changes the curve.
class EveryMechanism : public ::testing::TestWithParam<std::string_view> {};

TEST_P(EveryMechanism, RunsAndIsSeen) {
  const Mechanism& mechanism = *find_mechanism(GetParam());
  solver::Setup setup = quick(Profile::layered_sand_clay, 0.035);
  setup.layers = {{0.0, 0.024, default_clay}, {0.024, 0.056, default_sand}, {0.056, 1.0, default_clay}};
  const Outcome off = run(setup);
  for (const MechanismParameter& parameter : mechanism.parameters)
    parameter.quantity.set_value(setup, parameter.prior_upper);
  // What would lie below this short push is brought into it.
  if (GetParam() == "grain_crushing") setup.mechanisms.grain_crushing.pressure = 30e3;
  if (GetParam() == "density_lens") setup.mechanisms.density_lens.centre = 0.03;
  const Outcome on = run(setup);
  ASSERT_EQ(on.status, Status::completed) << on.reason;
  EXPECT_TRUE(on.profile.q_c != off.profile.q_c || on.profile.f_s != off.profile.f_s ||
              on.profile.depth != off.profile.depth);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryMechanism, ::testing::ValuesIn([] {
                           std::vector<std::string_view> names;
                           for (const Mechanism& mechanism : all_mechanisms())
                             names.push_back(mechanism.name);
                           return names;
                         }()),
                         [](const auto& param_info) { return std::string(param_info.param); });

}  // namespace
}  // namespace cpt::solver

#include "solver/quantities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "solver/mechanisms/catalogue.hpp"
#include "solver/presets.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::solver {
namespace {

std::vector<solver::Setup> all_setups() {
  std::vector<solver::Setup> setups;
  for (const Profile profile : all_profiles())
    for (const Preset preset : all_presets()) setups.push_back(make_setup(profile, preset));
  return setups;
}

/// Another valid value of the quantity.
double other_value(const Quantity& quantity, double value) {
  if (!quantity.choices.empty() || quantity.integer) return value < quantity.max ? value + 1.0 : value - 1.0;
  const double middle = (quantity.min + quantity.max) / 2.0;
  return value == middle ? quantity.min : middle;
}

Quantity quantity(std::string_view name) {
  const Quantity* found = find_quantity(name);
  if (found == nullptr) throw std::runtime_error(std::string(name));
  return *found;
}

// Counts the members of an aggregate: as many as it can be initialized with.
struct Anything {
  template <class T>
  operator T() const;  // NOLINT: implicit on purpose, never defined
};
template <class Aggregate, class... Members>
constexpr std::size_t member_count() {
  if constexpr (requires { Aggregate{Members{}..., Anything{}}; })
    return member_count<Aggregate, Members..., Anything>();
  else
    return sizeof...(Members);
}

TEST(Quantities, EveryInputOfTheSetupIsListed) {
  std::map<std::string, std::size_t> listed;
  std::size_t of_mechanisms = 0;
  for (const Quantity& q : all_quantities())
    if (is_mechanism_parameter(q.name))
      ++of_mechanisms;
    else
      ++listed[q.name.substr(0, q.name.find('.'))];
  // Their random fields with all parts.
  EXPECT_EQ(listed["sand"], member_count<NorSandParameters>() - 1 + member_count<RandomField>());
  EXPECT_EQ(listed["clay"], member_count<TrescaParameters>() - 1 + member_count<RandomField>());
  EXPECT_EQ(listed["contact"], member_count<Contact>());
  EXPECT_EQ(listed["chamber"], member_count<Chamber>());
  EXPECT_EQ(listed["initial"], member_count<InitialStress>());
  EXPECT_EQ(listed["penetrometer"], member_count<Penetrometer>());
  EXPECT_EQ(listed["numerics"],
            member_count<Numerics>() - 2);  // all but the zones and the cone of the lengths
  // All but the soils, the layers, the mechanisms, and another program with its inputs.
  EXPECT_EQ(listed.size() - solver::Setup{}.soils.size() + 5, member_count<solver::Setup>());
  EXPECT_EQ(all_mechanisms().size(), member_count<Mechanisms>());
  // Every field of a mechanism is a double; the final depth of the two trends is filled in by actual_setup.
  constexpr std::size_t filled_in = 2;
  EXPECT_EQ((of_mechanisms + filled_in) * sizeof(double), sizeof(Mechanisms));
}

TEST(Quantities, AreFoundByNameAndFullyDescribed) {
  std::set<std::string_view> names;
  for (const Quantity& q : all_quantities()) {
    EXPECT_TRUE(names.insert(q.name).second) << q.name << " is listed twice";
    EXPECT_EQ(find_quantity(q.name), &q);
    EXPECT_FALSE(q.symbol.empty()) << q.name;
    EXPECT_FALSE(q.meaning.empty()) << q.name;
    EXPECT_FALSE(q.source.empty()) << q.name;
    EXPECT_LT(q.min, q.max) << q.name;
    EXPECT_GT(q.scale, 0.0) << q.name;
  }
  EXPECT_EQ(find_quantity("sand"), nullptr);
  EXPECT_EQ(find_quantity(""), nullptr);
  EXPECT_EQ(find_quantity("sand.H "), nullptr);
}

TEST(Quantities, NamesCarryTheUnit) {
  const std::map<std::string_view, std::string_view> suffix_of = {
      {"kPa", "_kPa"},         {"deg", "_deg"},         {"%", "_percent"}, {"m", "_m"},
      {"m/s", "_m_per_s"},     {"kg/m3", "_kg_per_m3"}, {"mm", "_mm"},     {"mm/MPa", "_mm_per_MPa"},
      {"kPa/m", "_kPa_per_m"}, {"1/s", "_per_s"},       {"s", "_s"}};
  for (const Quantity& q : all_quantities()) {
    if (q.unit == "-")
      for (const auto& [unit, suffix] : suffix_of) EXPECT_FALSE(q.name.ends_with(suffix)) << q.name;
    else
      EXPECT_TRUE(q.name.ends_with(suffix_of.at(q.unit))) << q.name << " in " << q.unit;
  }
}

TEST(Quantities, StudyUnitsBecomeSI) {
  solver::Setup setup;
  quantity("clay.s_u_kPa").set_value(setup, 30.5);
  quantity("sand.phi_cs_deg").set_value(setup, 31.0);
  quantity("sand.D_r_percent").set_value(setup, 60.0);
  quantity("penetrometer.apex_deg").set_value(setup, 90.0);
  quantity("chamber.radius_m").set_value(setup, 0.3);
  quantity("numerics.face_elements").set_value(setup, 4.0);
  quantity("chamber.wall").set_value(setup, 0.0);
  EXPECT_DOUBLE_EQ(clay_of(setup).s_u, 30500.0);
  EXPECT_DOUBLE_EQ(sand_of(setup).phi_cs, 31.0 * std::acos(-1.0) / 180.0);
  EXPECT_DOUBLE_EQ(sand_of(setup).D_r, 0.6);
  EXPECT_DOUBLE_EQ(setup.penetrometer.apex, std::acos(-1.0) / 2.0);
  EXPECT_DOUBLE_EQ(setup.chamber.radius, 0.3);
  EXPECT_EQ(setup.numerics.face_elements, 4);
  EXPECT_EQ(setup.chamber.wall, Wall::flexible);
}

TEST(Quantities, ValuesComeBackBitForBit) {
  for (const solver::Setup& setup : all_setups())
    for (const Quantity& q : all_quantities()) {
      solver::Setup copy = setup;
      q.set_value(copy, q.value(setup));
      EXPECT_EQ(q.get(copy), q.get(setup)) << q.name;
      if (q.choices.empty()) {
        EXPECT_EQ(std::strtod(q.format(q.value(setup)).c_str(), nullptr), q.value(setup)) << q.name;
      }
    }
}

TEST(Quantities, AreWrittenAsAnEngineerWould) {
  const solver::Setup layered = make_setup(Profile::layered_sand_clay, Preset::paper);
  const auto text = [&](std::string_view name) {
    return quantity(name).format(quantity(name).value(layered));
  };
  EXPECT_EQ(text("sand.D_r_percent"), "29");  // 0.29 / 0.01 is 28.999999999999996
  EXPECT_EQ(text("sand.phi_cs_deg"), "30");
  EXPECT_EQ(text("penetrometer.apex_deg"), "60");
  EXPECT_EQ(text("clay.s_u_kPa"), "27.9");
  EXPECT_EQ(text("chamber.wall"), "rigid");
  EXPECT_EQ(text("numerics.face_elements"), "2");
  EXPECT_EQ(text("sand.p_min_kPa"), "0.5");
}

TEST(Quantities, ChoicesNameEveryAlternative) {
  for (const Quantity& q : all_quantities()) {
    solver::Setup setup;
    for (std::size_t i = 0; i < q.choices.size(); ++i) {
      q.set_value(setup, static_cast<double>(i));
      EXPECT_EQ(q.value(setup), static_cast<double>(i)) << q.name;
      EXPECT_EQ(q.format(static_cast<double>(i)), q.choices[i]) << q.name;
    }
  }
  const auto choices = [](std::string_view name) { return quantity(name).choices; };
  EXPECT_EQ(choices("chamber.wall"), (std::vector<std::string_view>{"flexible", "rigid"}));
  EXPECT_EQ(choices("sand.flow"), (std::vector<std::string_view>{"radial", "associated"}));
}

TEST(CanonicalText, ChangesWithEveryInput) {
  const solver::Setup setup = make_setup(Profile::layered_sand_clay, Preset::quick);
  std::set<std::string> texts = {canonical_text(setup)};
  const auto expect_new = [&](const solver::Setup& changed, std::string_view what) {
    EXPECT_TRUE(texts.insert(canonical_text(changed)).second) << what;
  };
  for (const Quantity& q : all_quantities()) {
    solver::Setup changed = setup;
    q.set_value(changed, other_value(q, q.value(setup)));
    expect_new(changed, q.name);
    if (!q.choices.empty() || q.integer) continue;
    changed = setup;
    q.set(changed, std::nextafter(q.get(setup), INFINITY));  // the smallest change there is
    expect_new(changed, q.name);
    changed = setup;
    q.set(changed, std::nextafter(q.get(setup), -INFINITY));
    expect_new(changed, q.name);
  }
  const auto expect_change = [&](const auto& change, std::string_view what) {
    solver::Setup changed = setup;
    change(changed);
    expect_new(changed, what);
  };
  expect_change([](solver::Setup& s) { s.layers[1].top = 0.24; }, "top of a layer");
  expect_change([](solver::Setup& s) { s.layers[1].bottom = 0.28; }, "bottom of a layer");
  expect_change([](solver::Setup& s) { s.layers[1].soil = default_sand; }, "soil of a layer");
  expect_change([](solver::Setup& s) { s.layers.pop_back(); }, "number of layers");
  expect_change([](solver::Setup& s) { s.numerics.zones[0].outer_radius = 0.031; }, "radius of a zone");
  expect_change([](solver::Setup& s) { s.numerics.zones[0].columns += 1; }, "columns of a zone");
  expect_change([](solver::Setup& s) { s.numerics.zones[0].rows_per_metre += 1; }, "rows of a zone");
  EXPECT_EQ(canonical_text(setup), canonical_text(make_setup(Profile::layered_sand_clay, Preset::quick)));
}

TEST(CanonicalText, SilentDefaultsLeaveNoTrace) {
  const solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::paper);
  const std::string text = canonical_text(setup);
  std::size_t silent = 0;
  for (const Quantity& q : all_quantities()) {
    EXPECT_EQ(text.find(q.name) == std::string::npos, q.silent_default.has_value()) << q.name;
    silent += q.silent_default ? 1 : 0;
  }
  EXPECT_GE(silent, 3U);
  EXPECT_TRUE(quantity("numerics.refinement").silent_default.has_value());
  EXPECT_FALSE(quantity("numerics.courant").silent_default.has_value());
  solver::Setup refined = setup;
  refined.numerics.refinement = 2.0;
  EXPECT_NE(canonical_text(refined).find("numerics.refinement = 2\n"), std::string::npos);
}

TEST(CanonicalText, IsALineAnInput) {
  const std::string text = canonical_text(make_setup(Profile::homogeneous_sand, Preset::paper));
  for (const char* line :
       {"sand.phi_cs_deg = 30\n", "clay.s_u_kPa = 27.9\n", "chamber.wall = rigid\n", "layers = 0 to 1 sand\n",
        "numerics.zones = to 0.06 columns 70 rows_per_metre 325\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
}

}  // namespace
}  // namespace cpt::solver

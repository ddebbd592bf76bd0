// Hints for misspelt names, and what the field calls quantities that have another name here.
#include "parameters/nearest_name.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "parameters/quantity_synonyms.hpp"
#include "solver/quantities.hpp"

namespace cpt::parameters {
namespace {

TEST(NearestQuantity, FindsWhatWasMeant) {
  const std::vector<std::pair<std::string_view, std::string_view>> table = {
      {"sand.lamda", "sand.lambda"},
      {"sand.labmda", "sand.lambda"},
      {"sand.phi_cs", "sand.phi_cs_deg"},
      {"sand.phi_cs_rad", "sand.phi_cs_deg"},
      {"phi_cs", "sand.phi_cs_deg"},
      {"sand.D_r", "sand.D_r_percent"},
      {"sand.d_r_pct", "sand.D_r_percent"},
      {"clay.su_kPa", "clay.s_u_kPa"},
      {"clay.s_u_MPa", "clay.s_u_kPa"},
      {"sand.s_u_kPa", "clay.s_u_kPa"},
      {"initial.sigma_h0", "initial.sigma_h0_kPa"},
      {"sigma_h0_kPa", "initial.sigma_h0_kPa"},
      {"chamber.radius", "chamber.radius_m"},
      {"chamber.radius_mm", "chamber.radius_m"},
      {"contact.friction", "contact.friction_ratio"},
      {"contact.adhesion", "contact.adhesion_ratio"},
      {"numerics.Courant", "numerics.courant"},
      {"courant", "numerics.courant"},
      {"sand.chi", "sand.chi_tc"},
      {"sand.h", "sand.H"},
      {"penetrometer.depth_m", "penetrometer.final_depth_m"},
      {"SAND.H", "sand.H"},
      {"clay.H", "sand.H"},
      // What the field calls them, with the group asked for where it has one.
      {"sand.relative_density", "sand.D_r_percent"},
      {"relative_density", "sand.D_r_percent"},
      {"sand.Dr", "sand.D_r_percent"},
      {"sand.friction_angle", "sand.phi_cs_deg"},
      {"friction_angle_deg", "sand.phi_cs_deg"},
      {"contact.friction_angle", "contact.friction_ratio"},
      {"clay.undrained_strength", "clay.s_u_kPa"},
      {"undrained_shear_strength_kPa", "clay.s_u_kPa"},
      {"clay.cu", "clay.s_u_kPa"},
      {"OCR", "sand.OCR"},
      {"initial.OCR", "sand.OCR"},
      {"K0", "initial.sigma_h0_kPa"},
      {"initial.K_0", "initial.sigma_h0_kPa"},
      {"vertical_stress", "initial.sigma_v0_kPa"},
      {"clay.poisson_ratio", "clay.nu"},
      {"sand.poisson_ratio", "sand.nu"},
      {"clay.shear_modulus", "clay.G_kPa"},
      {"hardening_modulus", "sand.H"},
      {"minimum_void_ratio", "sand.e_min"},
      {"penetrometer.penetration_rate", "penetrometer.speed_m_per_s"},
      {"apex_angle", "penetrometer.apex_deg"},
      {"mass_scaling", "numerics.mass_scaling"}};
  for (const auto& [misspelt, meant] : table) EXPECT_EQ(nearest_quantity(misspelt), meant) << misspelt;
  for (const solver::Quantity& q : solver::all_quantities()) EXPECT_EQ(nearest_quantity(q.name), q.name);
  std::set<std::pair<std::string_view, std::string_view>> seen;
  for (const Synonym& synonym : quantity_synonyms()) {
    EXPECT_NE(solver::find_quantity(synonym.quantity), nullptr) << synonym.quantity;
    EXPECT_EQ(squeezed(synonym.word), synonym.word);
    EXPECT_TRUE(seen.emplace(synonym.word, synonym.quantity).second) << synonym.word;
    const std::string_view group = synonym.quantity.substr(0, synonym.quantity.find('.'));
    EXPECT_EQ(nearest_quantity(std::string(group) + "." + std::string(synonym.word)), synonym.quantity);
  }
  EXPECT_EQ(nearest_quantity(""), "");
  EXPECT_EQ(nearest_quantity("temperature_of_the_room"), "");
  EXPECT_EQ(nearest_quantity(std::string(100000, 'a')), "");
}

TEST(NearestName, FindsWhatWasMeantAmongAnyNames) {
  const std::vector<std::string_view> names = {"baseline", "lower", "upper"};
  EXPECT_EQ(nearest_name("uper", names), "upper");
  EXPECT_EQ(nearest_name("Lower", names), "lower");
  EXPECT_EQ(nearest_name("base", names), "baseline");
  EXPECT_EQ(nearest_name("baselin", names), "baseline");
  EXPECT_EQ(nearest_name("xyz", names), "");
}

TEST(NearestName, KnowsTheSoilsOfASetup) {
  solver::Setup setup;
  setup.soils[0].name = "dense";
  EXPECT_EQ(nearest_quantity("dense.h", setup), "dense.H");
}

}  // namespace
}  // namespace cpt::parameters

#include "parameters/quantity_synonyms.hpp"

#include <array>
#include <cctype>

namespace cpt::parameters {

std::span<const Synonym> quantity_synonyms() {
  static constexpr auto list = std::to_array<Synonym>({
      {"relativedensity", "sand.D_r_percent"},
      {"densityindex", "sand.D_r_percent"},
      {"density", "sand.D_r_percent"},
      {"rd", "sand.D_r_percent"},
      {"voidratio", "sand.D_r_percent"},  // which follows from it
      {"voidratio", "clay.n_0"},
      {"initialvoidratio", "sand.D_r_percent"},
      {"e0", "sand.D_r_percent"},
      {"porosity", "clay.n_0"},
      {"frictionangle", "sand.phi_cs_deg"},
      {"frictionangle", "contact.friction_ratio"},
      {"phi", "sand.phi_cs_deg"},
      {"phicv", "sand.phi_cs_deg"},
      {"phicrit", "sand.phi_cs_deg"},
      {"phiprime", "sand.phi_cs_deg"},
      {"mtc", "sand.phi_cs_deg"},
      {"hardening", "sand.H"},
      {"dilatancy", "sand.chi_tc"},
      {"dilation", "sand.chi_tc"},
      {"dilationangle", "sand.chi_tc"},
      {"dilatancyangle", "sand.chi_tc"},
      {"gamma", "sand.e_cs0"},
      {"criticalvoidratio", "sand.e_cs0"},
      {"overconsolidation", "sand.OCR"},
      {"overconsolidationratio", "sand.OCR"},
      {"g0", "sand.G_ref"},
      {"gmax", "sand.G_ref"},
      {"shearmodulus", "sand.G_ref"},
      {"shearmodulus", "clay.G_kPa"},
      {"stiffness", "sand.G_ref"},
      {"stiffness", "clay.G_kPa"},
      {"poisson", "sand.nu"},
      {"poisson", "clay.nu"},
      {"poissonratio", "sand.nu"},
      {"poissonratio", "clay.nu"},
      {"poissonsratio", "sand.nu"},
      {"poissonsratio", "clay.nu"},
      {"specificgravity", "sand.rho_grains_kg_per_m3"},
      {"specificgravity", "clay.rho_grains_kg_per_m3"},
      {"gs", "sand.rho_grains_kg_per_m3"},
      {"gs", "clay.rho_grains_kg_per_m3"},
      {"undrainedstrength", "clay.s_u_kPa"},
      {"undrainedshearstrength", "clay.s_u_kPa"},
      {"shearstrength", "clay.s_u_kPa"},
      {"strength", "clay.s_u_kPa"},
      {"cohesion", "clay.s_u_kPa"},
      {"cu", "clay.s_u_kPa"},
      {"alpha", "contact.adhesion_ratio"},
      {"alpha", "penetrometer.apex_deg"},
      {"interfacefriction", "contact.friction_ratio"},
      {"roughness", "contact.friction_ratio"},
      {"delta", "contact.friction_ratio"},
      {"k0", "initial.sigma_h0_kPa"},  // over sigma_v0
      {"ko", "initial.sigma_h0_kPa"},
      {"earthpressurecoefficient", "initial.sigma_h0_kPa"},
      {"horizontalstress", "initial.sigma_h0_kPa"},
      {"lateralstress", "initial.sigma_h0_kPa"},
      {"sigmah", "initial.sigma_h0_kPa"},
      {"verticalstress", "initial.sigma_v0_kPa"},
      {"overburden", "initial.sigma_v0_kPa"},
      {"confiningpressure", "initial.sigma_v0_kPa"},
      {"sigmav", "initial.sigma_v0_kPa"},
      {"conediameter", "penetrometer.diameter_m"},
      {"coneangle", "penetrometer.apex_deg"},
      {"apexangle", "penetrometer.apex_deg"},
      {"penetrationrate", "penetrometer.speed_m_per_s"},
      {"penetrationspeed", "penetrometer.speed_m_per_s"},
      {"velocity", "penetrometer.speed_m_per_s"},
      {"rate", "penetrometer.speed_m_per_s"},
      {"penetrationdepth", "penetrometer.final_depth_m"},
      {"pushdepth", "penetrometer.final_depth_m"},
      {"depth", "penetrometer.final_depth_m"},
      {"depth", "previous_push.depth_m"},
      {"chamberdiameter", "chamber.radius_m"},
      {"chamberheight", "chamber.soil_height_m"},
      {"boundary", "chamber.wall"},
      {"boundarycondition", "chamber.wall"},
      {"cellsize", "numerics.near_height_m"},
      {"elementsize", "numerics.near_height_m"},
      {"meshsize", "numerics.near_height_m"},
      {"timestep", "numerics.courant"},
      {"cfl", "numerics.courant"},
      {"damping", "numerics.local_damping"},
      {"materialpoints", "numerics.point_density"},
      {"particlespercell", "numerics.point_density"},
      {"pointspercell", "numerics.point_density"},
  });
  return list;
}

std::string squeezed(std::string_view name) {
  std::string left;
  for (const char c : name)
    if (const auto byte = static_cast<unsigned char>(c); std::isalnum(byte) != 0)
      left += static_cast<char>(std::tolower(byte));
  return left;
}

}  // namespace cpt::parameters

#include "solver/presets.hpp"

#include <array>

namespace cpt::solver {
namespace {

constexpr std::array profiles = {Profile::homogeneous_sand, Profile::homogeneous_clay,
                                 Profile::layered_sand_clay};
constexpr std::array presets = {Preset::quick, Preset::standard, Preset::paper, Preset::fine};

void set_profile(Setup& setup, Profile profile) {
  const double bottom = setup.chamber.soil_height;
  switch (profile) {
    case Profile::homogeneous_sand:
      setup.layers = {{0.0, bottom, default_sand}};
      as<NorSandParameters>(setup.soils[default_sand]).D_r = 0.36;
      setup.penetrometer.final_depth = 0.53;  // past the window 0.5054 to 0.5255 m
      break;
    case Profile::homogeneous_clay:
      setup.layers = {{0.0, bottom, default_clay}};
      setup.penetrometer.final_depth = 0.53;
      break;
    case Profile::layered_sand_clay:
      // Layers of 40 mm (Yost et al. 2023, section 5). The depths of the interfaces are not given there; they
      // are inferred from its trough in the first embedded clay (0.2771 m) and peak in the first embedded
      // sand (0.3082 m).
      setup.layers = {{0.00, 0.23, default_sand}, {0.23, 0.27, default_clay},  {0.27, 0.31, default_sand},
                      {0.31, 0.35, default_clay}, {0.35, 0.39, default_sand},  {0.39, 0.43, default_clay},
                      {0.43, 0.47, default_sand}, {0.47, 0.51, default_clay},  {0.51, 0.55, default_sand},
                      {0.55, 0.59, default_clay}, {0.59, bottom, default_sand}};
      as<NorSandParameters>(setup.soils[default_sand]).D_r = 0.29;
      setup.penetrometer.final_depth = 0.33;  // past the peak in the first embedded sand
      break;
  }
}

void set_resolution(Setup& setup, Preset preset) {
  Numerics& numerics = setup.numerics;
  numerics.face_elements = 2;
  switch (preset) {
    case Preset::paper:  // 71 000 material points over 2 m: Yost et al. (2023), section 4.1
      // Printed as 0.31 m wide, the outermost zone is 0.21 m wide in a chamber of 0.45 m.
      numerics.zones = {{0.06, 70, 325.0}, {0.12, 25, 200.0}, {0.24, 35, 150.0}, {0.45, 20, 125.0}};
      setup.chamber.surcharge_height = 1.0;
      break;
    case Preset::fine:  // 123 000 over 2 m: cells at the cone half as wide and high as the paper's
      numerics.zones = {{0.06, 70, 650.0}, {0.12, 25, 200.0}, {0.24, 35, 200.0}, {0.45, 20, 200.0}};
      numerics.face_elements = 4;
      numerics.near_height = 0.0031625;
      numerics.near_width_radius = 0.04;
      numerics.coarse_rows_radius = 0.06;
      setup.chamber.surcharge_height = 1.0;
      break;
    case Preset::standard:  // 46 000 over 1.5 m, the penetrometer's place included
      numerics.zones = {{0.06, 62, 320.0}, {0.12, 22, 200.0}, {0.24, 32, 150.0}, {0.45, 18, 125.0}};
      setup.chamber.surcharge_height = 0.5;
      break;
    case Preset::quick:  // 13 000 over 1.5 m
      // Columns widen early and rows are joined early, to hold at least one column and row of points a cell.
      numerics.zones = {{0.03, 14, 250.0}, {0.08, 12, 200.0}, {0.20, 10, 165.0}, {0.45, 10, 125.0}};
      numerics.near_width_radius = 0.03;
      numerics.coarse_rows_radius = 0.08;
      numerics.far_width = 0.04;
      setup.chamber.surcharge_height = 0.5;
      break;
  }
}

}  // namespace

Setup make_setup(Profile profile, Preset preset) {
  Setup setup;
  set_profile(setup, profile);
  set_resolution(setup, preset);
  return setup;
}

std::string_view to_string(Profile profile) {
  switch (profile) {
    case Profile::homogeneous_sand:
      return "homogeneous_sand";
    case Profile::homogeneous_clay:
      return "homogeneous_clay";
    case Profile::layered_sand_clay:
      return "layered_sand_clay";
  }
  return "";
}

std::string_view to_string(Preset preset) {
  switch (preset) {
    case Preset::quick:
      return "quick";
    case Preset::standard:
      return "standard";
    case Preset::paper:
      return "paper";
    case Preset::fine:
      return "fine";
  }
  return "";
}

std::optional<Profile> profile_from_string(std::string_view name) {
  for (const Profile profile : profiles)
    if (to_string(profile) == name) return profile;
  return std::nullopt;
}

std::optional<Preset> preset_from_string(std::string_view name) {
  for (const Preset preset : presets)
    if (to_string(preset) == name) return preset;
  return std::nullopt;
}

std::span<const Profile> all_profiles() { return profiles; }
std::span<const Preset> all_presets() { return presets; }

}  // namespace cpt::solver

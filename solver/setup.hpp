// Every input of one realization of the solver, in SI units, as one plain struct.
//
// Sign conventions: tensors are tension-positive; sigma_v0, sigma_h0, p and q_c are compression-positive.
// Depth is measured from the soil's top, downward. Angles are radians, D_r is a fraction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/external_program.hpp"
#include "solver/mechanisms/mechanisms.hpp"
#include "solver/soils/soil.hpp"

namespace cpt::solver {

enum class Wall : std::uint8_t { flexible, rigid };           ///< radial boundary of the chamber
enum class SurchargeKind : std::uint8_t { traction, layer };  ///< how sigma_v0 is applied at the soil's top
enum class ShoulderNormal : std::uint8_t { shaft, bisector, face };
enum class SelfWeight : std::uint8_t { none, submerged, saturated };

/// One soil layer; layers are listed from the top and touch without gaps.
struct Layer {
  double top;        // [m] depth of the upper interface
  double bottom;     // [m] depth of the lower interface
  std::size_t soil;  // index into Setup::soils
};

struct Contact {
  double friction_ratio = 0.5;  // [-] contact friction angle over the soil's
  double adhesion_ratio = 0.5;  // [-] contact adhesion over the soil's strength without friction
  ShoulderNormal shoulder_normal = ShoulderNormal::bisector;
};

struct Chamber {
  double radius = 0.45;      // [m]
  double soil_height = 1.0;  // [m]
  Wall wall = Wall::rigid;
  SurchargeKind surcharge = SurchargeKind::layer;
  double surcharge_height = 1.0;    // [m]
  double surcharge_E = 1.0e6;       // [Pa] Young's modulus of the surcharge layer
  double surcharge_nu = 1.0 / 3.0;  // [-] Poisson's ratio of the surcharge layer
};

struct InitialStress {
  double sigma_v0 = 50.0e3;  // [Pa] vertical effective stress at the soil's top
  double sigma_h0 = 25.0e3;  // [Pa] horizontal effective stress at the soil's top; K_0 = sigma_h0 / sigma_v0
  SelfWeight self_weight = SelfWeight::submerged;
};

struct Penetrometer {
  double diameter = 0.0253;          // [m]
  double apex = 1.0471975511965976;  // [rad] apex angle (60 deg)
  double speed = 0.04;               // [m/s]
  double sleeve_length = 0.0948;     // [m] friction sleeve above the shoulder (f_s)
  double final_depth = 0.55;         // [m] depth of the tip at the end of the push
};

/// A radial zone of equally spaced material points.
struct PointZone {
  double outer_radius;    // [m]; the last zone reaches the chamber's wall whatever it says
  int columns;            // [-] columns of points across the zone
  double rows_per_metre;  // [1/m] rows of points per metre of height
};

/// Lengths are given for a cone of `for_diameter` and grow with the penetrometer's (refinement.hpp).
struct Numerics {
  double for_diameter = 0.0253;      // [m] the cone of Yost et al. (2023); no input
  int face_elements = 2;             // [-] elements over the cone radius
  double near_height = 0.006325;     // [m] cell height around the tip
  double near_width_radius = 0.06;   // [m] columns keep about the near width up to here, then widen
  double far_width = 0.025;          // [m] column width at the wall
  double width_growth = 1.15;        // [-] beyond the near width: a column's width over its inner neighbour's
  double coarse_rows_radius = 0.12;  // [m] beyond this radius rows are joined two by two
  double zone_below = 0.12;          // [m] moving zone: extent below the tip
  double zone_above = 0.12;          // [m] moving zone: extent above the shoulder
  double below_height = 0.030;       // [m] height of the rows of the compressing zone at the start
  double above_height = 0.0125;      // [m] height of the rows of the stretching zone at the start
  std::vector<PointZone> zones = {{0.06, 70, 325.0}, {0.12, 25, 200.0}, {0.24, 35, 150.0}, {0.45, 20, 125.0}};
  double refinement = 1.0;      // [-] all lengths of the mesh and the points' spacing over this
  double point_density = 1.0;   // [-] factor on the material points in a cell
  double point_shift = 0.0;     // [-] draws where the points lie about their grid (point_grid.hpp)
  double courant = 0.95;        // [-]
  double mass_scaling = 1.0e4;  // [-] on inertia only
  int step_levels = 4;          // [-] soft and large cells: steps of up to 2^step_levels (step_levels.hpp)
  double pic_fraction = 0.005;  // [-] 0 = FLIP, 1 = PIC of second order
  double local_damping = 0.0;   // [-] fraction of the out-of-balance force
  double bulk_viscosity =
      0.0;  // [-] b: linear bulk viscosity, a pressure of b rho c h times the rate of dilatation
  // Share of the quadrant's average stress given back to its points each step [-]. Not in sand: NorSand's
  // points would leave their own yield surface every step.
  double stress_smoothing_clay = 1.0;  // also of the surcharge layer
  double stress_smoothing_sand = 0.0;
  double start_distance = 0.0127;  // [m] travel over which the push gets up to its speed
  double bin_height = 0.0005;      // [m] depth bin over which q_c and f_s are averaged
};

struct Setup {
  std::vector<Soil> soils = {{"sand", NorSandParameters{}}, {"clay", TrescaParameters{}}};
  std::vector<Layer> layers = {{0.0, 1.0, default_sand}};
  Contact contact;
  Chamber chamber;
  InitialStress initial;
  Penetrometer penetrometer;
  Numerics numerics;
  Mechanisms mechanisms;
  /// Runs in place of the embedded solver, which all of the above is for; none: the embedded one.
  std::shared_ptr<const ExternalProgram> program = nullptr;
  std::vector<double> program_inputs = {};  // one for each of its inputs
};

/// True where some layer is of that soil.
[[nodiscard]] inline bool contains(const Setup& setup, std::size_t soil) {
  for (const Layer& layer : setup.layers)
    if (layer.soil == soil) return true;
  return false;
}

}  // namespace cpt::solver

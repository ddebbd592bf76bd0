// How the soils of one cell share its motion.
//
// A cell has one velocity field, but sand and undrained clay in it do not strain alike: one strain for both
// gives the stiff soil the pressure of the soft one's dilation and the soft one the reverse. The soils of a
// cell are taken as a laminate across the interface's normal n (Backus 1962; rank-one laminates, Milton 2002,
// ch. 9): soil k has the velocity gradient L_k = L + a_k n^T, where L is the cell's and the jumps a_k,
// weighted with the soils' shares of the volume, add up to zero, so that neither the cell's motion nor its
// volume changes. The jumps are those at which all soils carry the same traction on the interface at the end
// of the step by their elastic stiffness. Plastic flow parts the tractions again; what it leaves is closed in
// the next step, so that in the end each soil's share follows its own stiffness and its own plastic flow. As
// the traction is one, the work of the parts is that of the cell (Hill 1963).
#pragma once

#include <span>

#include "solver/material_points.hpp"

namespace cpt::solver {

/// Unit normal of the interface in a cell.
struct InterfaceNormal {
  double r = 0.0, z = 1.0;  // [-]
};

/// A velocity gradient in the r-z plane [1/s].
struct PlaneGradient {
  double rr = 0.0, rz = 0.0, zr = 0.0, zz = 0.0;  // dv_r/dr, dv_r/dz, dv_z/dr, dv_z/dz
};

/// One soil of a cell.
struct SoilInCell {
  double share = 0.0;                                     // [-] of the cell's volume
  double modulus = 0.0;                                   // [Pa] K + 4/3 G
  double shear_modulus = 0.0;                             // [Pa] G
  double s_rr = 0.0, s_zz = 0.0, s_tt = 0.0, s_rz = 0.0;  // [Pa] mean over its points, tension-positive
  PlaneGradient jump;                                     // found: a_k n^T
};

/// The rate of strain of a cell [1/s]; `hoop` completes the plane's part.
struct CellStrainRate {
  PlaneGradient plane;
  double hoop = 0.0;
};

/// Largest jump of a step [-], as a strain: where a soil hardly has stiffness left, closing the tractions at
/// once would ask for more.
inline constexpr double largest_jump = 0.04;

/// Finds the jumps of the soils of a cell for a step of dt [s]. Returns whether the largest jump was
/// exceeded; then all are scaled down alike.
bool share_motion(std::span<SoilInCell> soils, const InterfaceNormal& normal, const CellStrainRate& rate,
                  double dt);

}  // namespace cpt::solver

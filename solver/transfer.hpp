// The kernels between material points and cells, one bucket at a time.
//
// They are compiled once for each instruction set (transfer_kernels.cpp) and chosen at run time, so that one
// binary runs everywhere. Sums have a fixed order on one instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/material_points.hpp"
#include "solver/mesh.hpp"
#include "solver/mixed_cells.hpp"

namespace cpt::solver {

/// Sums of a cell over its material points. Quadrant q = (xi > 0) + 2 (eta > 0) is the share of a Gauss
/// point.
struct alignas(64) CellSums {
  double volume[4];  // [m3/rad] by quadrant
  double s_rr[4];    // [Pa m3/rad] volume times stress, by quadrant
  double s_zz[4];
  double s_tt[4];
  double s_rz[4];
  double p_r[4];                         // [kg m/s/rad] momentum at the cell's nodes, sum of N_k m v
  double material_mass[most_materials];  // [kg/rad]
  double p_z[4];
  // [kg/rad] sum of m f over 1, xi, eta, xi eta, xi2, eta2, xi2 eta, xi eta2, xi2 eta2: the cell's lumped and
  // consistent mass matrices are combinations of them.
  double moment[9];
  double unused[3];
};

/// The lumped mass at corner k of a cell, sum of N_k m [kg/rad].
[[nodiscard]] double corner_mass(const CellSums& sums, int k);

/// A field on a cell: c[0] + c[1] xi + c[2] eta + c[3] xi eta.
struct Bilinear {
  double c[4];
};

/// What moves the points of a cell during one step.
struct CellMotion {
  CellShape shape;               // at the start of the step
  Bilinear v_r, v_z;             // [m/s] nodal velocity that moves and strains the points
  Bilinear dv_r, dv_z;           // [m/s] its change over the step
  Bilinear smooth_r, smooth_z;   // [m/s] what the points' velocities are drawn to
  double divergence;             // [1/s] mean over the cell (B-bar)
  double dt;                     // [s]
  double pic_fraction;           // [-]
  double smoothing;              // [-] share of the quadrant's mean stress given back to the points
  bool mixed = false;            // the soil has a jump of its own; then there is no smoothing
  PlaneGradient jump;            // [1/s] of the velocity gradient
  const double* mean_stress[4];  // [Pa] of rr, zz, tt, rz: the mean of each quadrant
};

/// Strain increments of a bucket's points, aligned; as long as the largest bucket.
struct StrainScratch {
  double* d_rr;
  double* d_zz;
  double* d_tt;
  double* d_rz;
  double* left;  // 1 where a point has left its cell
};

struct TransferKernels {
  /// Grid to points: velocity, position, volume, strain increment, Jaumann rotation of the stress. `count`
  /// points, `padded` slots; dummies get zero strain. Returns the work of the old stress, sum of V s : d / 2.
  double (*move_points)(std::int32_t count, std::size_t padded, const PointFields& points,
                        const CellMotion& motion, const StrainScratch& strain);
  /// Points to grid at the cell's new shape: natural coordinates and sums, adding to `sums`. Points that left
  /// the cell are flagged in strain.left and not summed; `some_left` tells whether there are any. Returns the
  /// work of the new stress, sum of V s : d / 2.
  double (*sum_points)(std::int32_t count, std::size_t padded, const PointFields& points,
                       const CellShape& shape, const Cell& cell, const StrainScratch& strain,
                       std::int32_t material, CellSums& sums, bool& some_left);
};

/// The kernels for this machine's instruction set.
[[nodiscard]] const TransferKernels& transfer_kernels();

/// Adds one point at natural coordinates (xi, eta) to the sums.
void add_to_sums(CellSums& sums, const PointFields& points, std::size_t k, std::int32_t material);

/// Bilinear coefficients of nodal values in the order bottom left, bottom right, top right, top left.
[[nodiscard]] inline Bilinear bilinear(double bl, double br, double tr, double tl) {
  return {{0.25 * (bl + br + tr + tl), 0.25 * (-bl + br + tr - tl), 0.25 * (-bl - br + tr + tl),
           0.25 * (bl - br + tr - tl)}};
}

}  // namespace cpt::solver

// Cell sums to the forces, inertia and mean gradients at the cells' nodes, several cells at a time.
//
// Compiled once for each instruction set (cell_forces_kernel.cpp) and chosen at run time. Multiplications and
// additions are not contracted, so that all instruction sets give the same bits.
#pragma once

#include <cstdint>

#include "solver/transfer.hpp"

namespace cpt::solver {

/// Share of the velocity change that strains the points before it is filtered (Model::filter_velocities).
inline constexpr double unfiltered = 0.1;
/// Largest share of a cell's highest frequency, squared, that the filter leaves to waves along one of its
/// sides and to those along both.
inline constexpr double largest_of_one = 0.48, largest_of_both = 0.316;

/// What a cell gives to its nodes, and what its own points need of it.
struct alignas(64) CellForces {
  double f_r[4], f_z[4];        // [N/rad] at the cell's nodes
  double inertia[4];            // [kg/rad]
  double mean_r[4], mean_z[4];  // [1/m] cell means of N,r + N/r and N,z
  double time_step;             // [s] Courant number times the largest stable step; infinite if empty
  double viscous;               // [Pa] pressure of the bulk viscosity
  double unused[2];
  double s_rr[4], s_zz[4], s_tt[4], s_rz[4];  // [Pa] mean stress by quadrant
};

/// Constants of a run, as in ModelSettings.
struct CellForceSettings {
  double courant, mass_scaling, bulk_viscosity, gravity;
  double weight_ratio[most_materials];
  std::int32_t materials;
  bool partial_cells;
};

/// Cells, one entry each.
struct CellArrays {
  const CellSums* sums;
  const CellShape* shapes;
  const double* modulus;     // [Pa] largest P-wave modulus
  const double* divergence;  // [1/s] mean over the cell in the last step
  const double* least_step;  // [s] that has to be stable
  CellForces* forces;        // written
};

/// Computes the cells from `first` to before `end`, at most cells_at_once of them.
using CellForceKernel = void (*)(const CellForceSettings& settings, const CellArrays& cells,
                                 std::int32_t first, std::int32_t end);
inline constexpr std::int32_t cells_at_once = 8;

/// The kernel for this machine's instruction set.
[[nodiscard]] CellForceKernel cell_force_kernel();

}  // namespace cpt::solver

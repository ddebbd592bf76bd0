// The discrete model between two steps: mesh, material points, cell sums and nodal fields, and the three
// stages that connect them. Boundary conditions and contact act on the nodal fields between `accelerate` and
// `move_points`.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <vector>

#include "solver/cell_forces.hpp"
#include "solver/material_points.hpp"
#include "solver/mesh.hpp"
#include "solver/soils/law.hpp"
#include "solver/step_levels.hpp"
#include "solver/transfer.hpp"

namespace cpt::solver {

/// The soils, ready for a run, and the surcharge above them, each at its number; none where no point is of
/// it.
using SoilModels = std::vector<std::unique_ptr<const SoilModel>>;

/// Settings of the time integration that the stages need.
struct ModelSettings {
  double courant = 0.8;
  double mass_scaling = 1.0;
  std::int32_t materials = 1;      // soils and surcharge
  double longest_step = INFINITY;  // [s] of any cell
  int most_level = 0;              // [-] of the local time steps
  double pic_fraction = 0.0;
  double local_damping = 0.0;
  double bulk_viscosity = 0.0;
  double stress_smoothing[most_materials] =
      {};  // [-] share of the quadrant's average given back to the points
  double weight_ratio[most_materials] = {1, 1, 1, 1, 1, 1, 1, 1};  // [-] effective over total unit weight
  double gravity = 9.81;                                           // [m/s2]
  bool partial_cells =
      false;  // scale a cell by how far its points fill it (a free soil surface inside the mesh)
  int threads = 1;
};

/// A vector at each node.
struct NodalVector {
  std::vector<double> r, z;
};

/// Nodal fields, one entry a node. A node between two steps of its own keeps them, but its change is zero.
struct Nodes {
  std::vector<double> inertia;  // [kg/rad] mass times mass scaling, consistent with the Gauss integration
  std::vector<double> mass;     // [kg/rad] sum of N m over material points
  NodalVector velocity;         // [m/s] before `accelerate` at the start, then at the end of the step
  NodalVector change;           // [m/s] of it over the step
  NodalVector force;            // [N/rad] internal and body forces
  NodalVector own;              // [m/s] velocity that the points give back to the node at the end of the step
  NodalVector moving;           // [m/s] what moves and strains the points
  NodalVector smooth;           // [m/s] what the points' own velocities are drawn to
};

/// A component of a node's velocity that a boundary or a contact prescribes.
struct Hold {
  std::int32_t node;
  double n_r, n_z;  // [-] unit vector
  double velocity;  // [m/s] along it
  bool or_more;     // a contact that may open
};

/// What a cell's points give its corners of a change of velocity, sum of N_k m dv [kg m/s/rad].
struct CornerImpulse {
  double r[4], z[4];
};

class Model {
 public:
  Model(Mesh mesh, const std::vector<Point>& points, const std::vector<std::int32_t>& material_of,
        SoilModels soils, const ModelSettings& settings);

  /// The cells around a node are to be updated at every step, whatever steps their own stiffness bears.
  void follow_every_step(std::int32_t node);
  /// Stage 1: stresses and weights to nodal forces; masses and velocities to nodes. Where all cells meet, the
  /// time step of the next cycle and its levels too.
  void compute_nodal_forces();
  /// [s] Largest stable time step of any cell times the Courant number, from the stiffness where all cells
  /// met last, but settings().longest_step at most.
  [[nodiscard]] double stable_time_step() const { return time_step_; }
  [[nodiscard]] const StepLevels& levels() const { return levels_; }
  /// [s] of the node's own step.
  [[nodiscard]] double step_of_node(std::int32_t n, double dt) const {
    return dt * static_cast<double>(1 << levels_.of_node(n));
  }
  /// Stage 2: free acceleration of the nodes whose step begins, without boundaries.
  void accelerate(double dt);
  /// Sets the velocity at the end of the step of a node; used by boundaries and contact.
  void set_velocity(std::int32_t node, double v_r, double v_z);
  /// The velocity of a node that strains the soil keeps this component as well.
  void hold(const Hold& hold) { holds_.push_back(hold); }
  /// Stage 3: nodes to points, stress update, points back to the cells of the mesh, which the caller has
  /// moved to its position at the end of the step; in the cells whose step ends.
  void move_points(double dt);

  [[nodiscard]] Mesh& mesh() { return mesh_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const MaterialPoints& points() const { return points_; }
  [[nodiscard]] Nodes& nodes() { return nodes_; }
  [[nodiscard]] const Nodes& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<CellSums>& sums() const { return sums_; }
  [[nodiscard]] const ModelSettings& settings() const { return settings_; }

  /// What the next step reads before it writes it, where all cells meet. The model that reads has been made
  /// from the same setup.
  template <class Archive>
  void exchange(Archive& archive) {
    double depth = mesh_.tip_depth();
    archive("mesh.tip_depth", depth);
    if constexpr (Archive::reading) mesh_.move_tip_to(depth);
    points_.exchange(archive);
    archive("cells.sums", sums_);
    archive("cells.shapes", shapes_);
    archive("cells.modulus", modulus_);
    archive("cells.work", work_);
    archive("cells.divergence", divergence_);
    archive("buckets.modulus", bucket_modulus_);
    archive("cells.mixed_steps", mixed_steps_);
    archive("cells.limited_steps", limited_steps_);
    if constexpr (Archive::reading) make_scratch();
  }

  /// Cells without material points in the region that the points fill at the start [-].
  [[nodiscard]] int empty_cells() const;
  /// Work done by the stresses on the points so far [J/rad].
  [[nodiscard]] double internal_work() const;
  /// Points that a safeguard of their law holds, over all points of soil [-].
  [[nodiscard]] double safeguarded_share() const;
  /// Cells of several soils whose jump was limited, over all such cells, summed over the steps [-].
  [[nodiscard]] double limited_share() const;

 private:
  struct Leaver {
    std::int32_t bucket, slot;
  };

  void add_surface_loads(std::int32_t c, CellForces& forces) const;
  void assemble_node(std::int32_t n);
  void condense(std::initializer_list<std::vector<double>*> fields) const;
  void interpolate(std::initializer_list<NodalVector*> fields) const;
  [[nodiscard]] InterfaceNormal interface_normal(std::int32_t c) const;
  /// The soils of a cell of several, in the order of their numbers, each with its jump.
  const SoilInCell* share_cell_motion(std::int32_t c, const CellMotion& motion, int thread);
  void begin_cycle();
  void gather(const NodalVector& field);
  void filter_velocities();
  void add_changes();
  void move_cell(std::int32_t c, double dt, int thread, const Cell& cell, const CellShape& new_shape);
  void sum_all_points();
  void rehome_leavers();
  void split_cells();
  void make_scratch();
  [[nodiscard]] StrainScratch scratch(int thread);

  Mesh mesh_;
  MaterialPoints points_;
  SoilModels soils_;
  ModelSettings settings_;
  const TransferKernels& kernels_;
  const CellForceKernel compute_cell_forces_;

  std::vector<CellSums> sums_;
  std::vector<CellForces> forces_;
  std::vector<CellShape> shapes_;
  std::vector<double> modulus_;                      // [Pa] largest P-wave modulus in a cell
  std::vector<double> bucket_modulus_;               // [Pa] of each soil in each cell
  std::vector<std::int32_t> soils_in_;               // number of soils in a cell
  std::vector<InterfaceNormal> normals_;             // of cells with several
  std::vector<SoilInCell> sharing_;                  // scratch, most_materials for each thread
  std::vector<double> mixed_steps_, limited_steps_;  // [-] of a cell, smallest steps
  std::vector<double> work_;                         // [J/rad] by cell
  std::vector<double> divergence_;                   // [1/s] mean of a cell in the last step
  std::vector<char> filled_at_start_;
  StepLevels levels_;
  std::vector<char> every_step_;    // of a cell: see follow_every_step
  std::vector<double> stable_;      // [s] largest step of each cell
  std::vector<double> least_step_;  // [s] that a cell's inertia has to bear
  Nodes nodes_;
  NodalVector gathered_;
  NodalVector changed_[highest_level + 1];  // [m/s] since the step of the cells of each level began
  std::vector<double> p_r_, p_z_;           // [kg m/s/rad] nodal momentum of the points
  std::vector<Hold> holds_;                 // of this step
  std::vector<CornerImpulse> impulses_;
  double time_step_ = 0.0;
  std::int64_t steps_ = 0;

  std::vector<std::int32_t> split_;  // first cell of each thread
  std::vector<std::vector<Leaver>> leavers_;
  std::vector<double> scratch_;
  std::size_t scratch_stride_ = 0;
};

}  // namespace cpt::solver

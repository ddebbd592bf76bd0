// The chamber's boundaries: smooth axis and bottom; a wall that is rigid, holds its stress, or gives way.
#pragma once

#include <vector>

#include "solver/model.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

class ChamberBoundary {
 public:
  ChamberBoundary(const Setup& setup, const Mesh& mesh, const LeftBehind& left = {});

  /// Adds the stress of a wall that is not rigid, and the friction on it, to the nodal forces. Before
  /// `accelerate`.
  void apply_wall_stress(Model& model);
  /// Fixes axis and rigid wall in r, and the bottom in z. After `accelerate`. Returns the vertical impulse of
  /// bottom and wall on the soil [N s/rad].
  double fix_boundaries(Model& model, double dt);
  /// Mean radial stress [Pa] of the last step on the wall within one cone diameter above and below a depth
  /// [m]; compression-positive. After `fix_boundaries`.
  [[nodiscard]] double wall_stress(const Mesh& mesh, double depth) const;

  template <class Archive>
  void exchange(Archive& archive) {
    displacement_.exchange(archive);
  }

 private:
  void follow_wall(const Model& model, double dt);

  const Setup& setup_;
  LeftBehind left_;
  bool free_wall_, friction_;
  double wall_force_ = 0.0;       // [N/rad] upward, of this step
  std::vector<double> applied_;   // [N/rad] inward, on each wall node in this step
  std::vector<double> reaction_;  // [N/rad] inward, of a rigid wall's nodes in their last step
  WallDisplacement displacement_;
  std::vector<double> z_, v_r_;  // of the wall's nodes in the soil
};

}  // namespace cpt::solver

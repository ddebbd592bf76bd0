// The chamber's boundaries: smooth axis, smooth bottom, rigid or flexible wall.
#pragma once

#include <vector>

#include "solver/model.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

class ChamberBoundary {
 public:
  ChamberBoundary(const Setup& setup, const Mesh& mesh);

  /// Adds the constant radial stress of a flexible wall to the nodal forces. Before `accelerate`.
  void apply_wall_stress(Model& model) const;
  /// Fixes axis and wall in r, and the bottom in z. After `accelerate`. Returns the vertical impulse of the
  /// bottom on the soil [N s/rad].
  double fix_boundaries(Model& model) const;

 private:
  const Setup& setup_;
  bool flexible_;
};

}  // namespace cpt::solver

// An effect's prior as a mixture of normals: nodes over its parameters, each a curve and what the parameters
// around the node, and the emulator's error there, can add to it. What is linear between nodes is then
// integrated exactly, and evidence of several effects at once is linear algebra.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/curve_emulator.hpp"

namespace cpt::diagnosis {

struct EffectNodes {
  std::string name;
  MatrixXd places;                // nodes x dimensions, in the unit cube
  VectorXd weights;               // nodes; sum to 1
  MatrixXd curves;                // n x nodes [ln]
  std::vector<MatrixXd> spreads;  // of each node n x columns [ln]: times independent standard normals
  VectorXd steps;  // dimensions; the first columns' normals times this is the place less the node's
  [[nodiscard]] Index count() const { return weights.size(); }
  /// On some of the cells.
  [[nodiscard]] EffectNodes on_rows(const std::vector<Index>& rows) const;
};

/// How finely an effect is divided.
struct NodeGrid {
  /// [standard deviations] how far the curve halfway to the next node may lie off the straight line, in the
  /// metric: as many cells along each parameter as that takes.
  double bend = 1.0;
  int least_strengths = 3;          ///< cells along the first parameter
  int most_cells[3] = {12, 12, 6};  ///< along each parameter of an effect of one, two and three
  int most_error_columns = 3;       ///< of each of the emulator's errors: between its runs, and in other soil
  double strength_limit = 1.0;      ///< as GridOptions'
};
/// For a first look at all subsets.
inline constexpr NodeGrid coarse_grid = {3.0, 1, {3, 4, 2}, 1};
inline constexpr NodeGrid fine_grid = {};

/// A node in the middle of each cell of the grid; its normal has 0.4 cells for standard deviation (0.29, a
/// uniform one's, where there is one), so that the sum is even over the cube to 15 %. The
/// emulator's errors are those beyond the `scatter` (n x n) [ln^2] of noise and runs; `whitening` (n x n) is
/// the metric's.
[[nodiscard]] EffectNodes effect_nodes(const CurveEmulator& emulator, const MatrixXd& scatter,
                                       const MatrixXd& whitening, const NodeGrid& grid);

}  // namespace cpt::diagnosis

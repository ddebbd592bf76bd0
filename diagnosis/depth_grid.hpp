// The depth grid on which recording and simulation are compared: y = ln(q_c / Pa) in cells of equal height.
//
// Several soundings are laid end to end in one vector; row i of every vector and matrix of the diagnosis is
// cell i. A cell without a value is NaN; it is never filled in, only left out (complete_rows).
#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

namespace cpt::diagnosis {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Cell i of a sounding is [from + i height, from + (i + 1) height).
struct SoundingGrid {
  double from;    // [m] depth of the first cell's top
  double height;  // [m] of a cell, > 0
  int cells;      // > 0
};

/// One row of the joint vector.
struct Cell {
  int sounding;     // counted from 0
  double depth;     // [m] of its centre
  double height;    // [m]
  int channel = 0;  ///< among those compared
  /// Cells of one curve scatter together.
  [[nodiscard]] bool same_curve(const Cell& other) const {
    return sounding == other.sounding && channel == other.channel;
  }
};

/// The rows of all soundings, in each of them its channels one behind the other, each from its top down.
/// Throws std::invalid_argument for a grid without cells.
[[nodiscard]] std::vector<Cell> cells_of(const std::vector<SoundingGrid>& soundings, int channels = 1);

/// ln of the mean q_c in each cell, from a finer profile of depths [m] and q_c [Pa] in any order. NaN where a
/// cell holds no sample, or one that is not finite or not positive. Throws std::invalid_argument if the
/// lengths differ.
[[nodiscard]] VectorXd log_cell_means(const SoundingGrid& grid, std::span<const double> depth,
                                      std::span<const double> q_c);

/// The soundings' curves end to end.
[[nodiscard]] VectorXd concatenate(const std::vector<VectorXd>& curves);

/// The rows that are finite in every column of every matrix. Throws std::invalid_argument if the numbers of
/// rows differ; matrices without columns do not count.
[[nodiscard]] std::vector<Index> complete_rows(const std::vector<MatrixXd>& curves);

/// The rows of cells kept, in the order given.
[[nodiscard]] std::vector<Cell> select(const std::vector<Cell>& cells, const std::vector<Index>& rows);

}  // namespace cpt::diagnosis

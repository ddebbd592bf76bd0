#include "diagnosis/depth_grid.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "solver/lengths.hpp"

namespace cpt::diagnosis {

std::vector<Cell> cells_of(const std::vector<SoundingGrid>& soundings, int channels) {
  std::vector<Cell> cells;
  int sounding = 0;
  for (const SoundingGrid& grid : soundings) {
    if (!(grid.height > 0.0) || grid.cells <= 0)
      throw std::invalid_argument("a sounding's grid has no cells");
    for (int channel = 0; channel < channels; ++channel)
      for (int i = 0; i < grid.cells; ++i)
        cells.push_back({sounding, grid.from + (i + 0.5) * grid.height, grid.height, channel});
    ++sounding;
  }
  return cells;
}

VectorXd log_cell_means(const SoundingGrid& grid, std::span<const double> depth,
                        std::span<const double> q_c) {
  if (depth.size() != q_c.size()) throw std::invalid_argument("as many depths as values of q_c are needed");
  VectorXd sum = VectorXd::Zero(grid.cells);
  VectorXd samples = VectorXd::Zero(grid.cells);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    // A reading on a cell's upper end belongs to it, whatever the rounding.
    const double place = std::floor((depth[i] - grid.from) / grid.height + solver::length_rounding);
    if (!(place >= 0.0 && place < grid.cells)) continue;
    const auto cell = static_cast<Index>(place);
    // One bad sample spoils its cell: what is left of the cell is not its mean.
    sum(cell) += std::isfinite(q_c[i]) && q_c[i] > 0.0 ? q_c[i] : std::numeric_limits<double>::quiet_NaN();
    samples(cell) += 1.0;
  }
  return (sum.array() / samples.array()).log();  // 0 / 0 = NaN: no sample
}

VectorXd concatenate(const std::vector<VectorXd>& curves) {
  Index rows = 0;
  for (const VectorXd& curve : curves) rows += curve.size();
  VectorXd joint(rows);
  Index row = 0;
  for (const VectorXd& curve : curves) {
    joint.segment(row, curve.size()) = curve;
    row += curve.size();
  }
  return joint;
}

std::vector<Index> complete_rows(const std::vector<MatrixXd>& curves) {
  std::vector<Index> rows;
  Index count = -1;
  for (const MatrixXd& c : curves) {
    if (c.cols() == 0) continue;
    if (count >= 0 && c.rows() != count) throw std::invalid_argument("curves of different length");
    count = c.rows();
  }
  for (Index i = 0; i < count; ++i) {
    bool complete = true;
    for (const MatrixXd& c : curves) complete = complete && (c.cols() == 0 || c.row(i).allFinite());
    if (complete) rows.push_back(i);
  }
  return rows;
}

std::vector<Cell> select(const std::vector<Cell>& cells, const std::vector<Index>& rows) {
  std::vector<Cell> kept;
  for (const Index row : rows) kept.push_back(cells[static_cast<std::size_t>(row)]);
  return kept;
}

}  // namespace cpt::diagnosis

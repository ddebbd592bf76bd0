#include "diagnosis/several/effect_nodes.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/several/noise.hpp"

namespace cpt::diagnosis {
namespace {

double extent_of(const CurveEmulator& emulator, Index d, const NodeGrid& grid) {
  return d == 0 && emulator.vanishes_at_zero() ? grid.strength_limit : 1.0;
}

// Cells along parameter d, others in the middle and the strength at its greatest.
int cells_along(const CurveEmulator& emulator, const MatrixXd& components, Index d, const NodeGrid& grid) {
  constexpr int choices[] = {1, 2, 3, 4, 6, 8, 12};
  const int most = grid.most_cells[emulator.dimensions() - 1];
  for (const int cells : choices) {
    if (cells >= most) break;
    if (d == 0 && cells < grid.least_strengths) continue;
    MatrixXd places = MatrixXd::Constant(2 * cells + 1, emulator.dimensions(), 0.5);
    if (d > 0) places.col(0).setConstant(grid.strength_limit);
    places.col(d) = VectorXd::LinSpaced(2 * cells + 1, 0.0, extent_of(emulator, d, grid));
    const MatrixXd curves = components * emulator.scores(places);
    double bend = 0.0;
    for (int c = 0; c < cells; ++c)
      bend =
          std::max(bend, (0.5 * (curves.col(2 * c) + curves.col(2 * c + 2)) - curves.col(2 * c + 1)).norm());
    if (bend <= grid.bend) return cells;
  }
  return most;
}

std::vector<int> counts_of(const CurveEmulator& emulator, const MatrixXd& whitening, const NodeGrid& grid) {
  const MatrixXd components = whitening * emulator.components();
  std::vector<int> counts;
  for (Index d = 0; d < emulator.dimensions(); ++d)
    counts.push_back(cells_along(emulator, components, d, grid));
  return counts;
}

}  // namespace

EffectNodes EffectNodes::on_rows(const std::vector<Index>& rows) const {
  EffectNodes part = *this;
  part.curves = curves(rows, Eigen::all);
  for (MatrixXd& spread : part.spreads) spread = MatrixXd(spread(rows, Eigen::all));
  return part;
}

EffectNodes effect_nodes(const CurveEmulator& emulator, const MatrixXd& scatter, const MatrixXd& whitening,
                         const NodeGrid& grid) {
  const Index dimensions = emulator.dimensions();
  const std::vector<int> counts = counts_of(emulator, whitening, grid);
  VectorXd width(dimensions), deviation(dimensions);
  Index nodes = 1;
  for (Index d = 0; d < dimensions; ++d) {
    const int count = counts[static_cast<std::size_t>(d)];
    width(d) = extent_of(emulator, d, grid) / count;
    deviation(d) = count == 1 ? std::sqrt(1.0 / 12.0) : 0.4;
    nodes *= count;
  }
  EffectNodes made{emulator.name(),
                   MatrixXd(nodes, dimensions),
                   VectorXd::Constant(nodes, 1.0 / static_cast<double>(nodes)),
                   {},
                   {},
                   width.cwiseProduct(deviation)};
  for (Index i = 0; i < nodes; ++i)
    for (Index d = 0, rest = i; d < dimensions; ++d) {
      const Index count = counts[static_cast<std::size_t>(d)];
      made.places(i, d) = (static_cast<double>(rest % count) + 0.5) * width(d);
      rest /= count;
    }
  made.curves = emulator.components() * emulator.scores(made.places);
  // Differences over a cell, times the deviation in cells.
  std::vector<MatrixXd> slopes;
  for (Index d = 0; d < dimensions; ++d) {
    MatrixXd below = made.places, above = made.places;
    below.col(d).array() -= 0.5 * width(d);
    above.col(d).array() += 0.5 * width(d);
    slopes.emplace_back(emulator.components() * (emulator.scores(above) - emulator.scores(below)) *
                        deviation(d));
  }
  const MatrixXd between = beyond_scatter(emulator.left_out_residuals(), scatter, grid.most_error_columns);
  const MatrixXd elsewhere = beyond_scatter(emulator.joint_residuals(), scatter, grid.most_error_columns);
  const CurveEmulator::ErrorScales scale = emulator.error_scales(made.places);
  for (Index i = 0; i < nodes; ++i) {
    MatrixXd spread(made.curves.rows(), dimensions + between.cols() + elsewhere.cols());
    for (Index d = 0; d < dimensions; ++d) spread.col(d) = slopes[static_cast<std::size_t>(d)].col(i);
    spread.middleCols(dimensions, between.cols()) = std::sqrt(scale.left_out(i)) * between;
    spread.rightCols(elsewhere.cols()) = std::sqrt(scale.joint(i)) * elsewhere;
    made.spreads.push_back(std::move(spread));
  }
  return made;
}

}  // namespace cpt::diagnosis

#include "parameters/all_realizations.hpp"

#include <algorithm>

namespace cpt::parameters {

std::vector<Realization> all_realizations(const Study& study) {
  std::vector<Realization> realizations = {{1, -1, Side::baseline}};
  const auto add = [&](int row, Side side) {
    realizations.push_back({static_cast<int>(realizations.size()) + 1, row, side});
  };
  for (int i = 0; i < static_cast<int>(study.rows.size()); ++i) {
    const Row& row = study.rows[static_cast<std::size_t>(i)];
    if (row.lower != row.baseline) add(i, Side::lower);
    if (row.upper != row.baseline) add(i, Side::upper);
  }
  for (int i = 0; i < static_cast<int>(study.points.size()); ++i)
    realizations.push_back({static_cast<int>(realizations.size()) + 1, -1,
                            study.points[static_cast<std::size_t>(i)].repeat ? Side::repeat : Side::point,
                            i});
  return realizations;
}

std::vector<const solver::Quantity*> varied_quantities(const Study& study) {
  std::vector<const solver::Quantity*> varied;
  const auto add = [&](const solver::Quantity* quantity) {
    if (std::ranges::find(varied, quantity) == varied.end()) varied.push_back(quantity);
  };
  for (const Row& row : study.rows) add(row.quantity);
  for (const DesignPoint& point : study.points)
    for (const Change& change : point.changes) add(change.quantity);
  return varied;
}

int realization_of(std::span<const Realization> realizations, int row, Side side) {
  for (const Realization& realization : realizations)
    if (realization.row == row && realization.side == side) return realization.id;
  return realizations.front().id;
}

}  // namespace cpt::parameters

#include "diagnosis/departure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cpt::diagnosis {

Departure departure_on(const std::vector<Cell>& cells, const VectorXd& recorded, const VectorXd& refitted,
                       const Mismatch& interval) {
  Departure on{0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0.0};
  double count = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    if (interval.sounding >= 0 && cell.sounding != interval.sounding) continue;
    if (cell.depth < interval.from || cell.depth > interval.to) continue;
    const auto row = static_cast<Index>(i);
    const double above = 100.0 * std::expm1(recorded(row) - refitted(row));
    on.percent += above;
    on.difference += std::exp(recorded(row)) - std::exp(refitted(row));
    on.least = std::min(on.least, above);
    on.greatest = std::max(on.greatest, above);
    ++count;
  }
  if (count == 0.0) return Departure{std::nan(""), std::nan(""), std::nan(""), std::nan("")};
  on.percent /= count;
  on.difference /= count;
  return on;
}

}  // namespace cpt::diagnosis

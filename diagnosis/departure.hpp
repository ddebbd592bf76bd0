// How far a recording lies from the refitted simulation on an interval.
#pragma once

#include "diagnosis/locate.hpp"

namespace cpt::diagnosis {

/// Over the cells of an interval; NaN where no cell lies in it. The step of a Mismatch says what is missing
/// beside moving parameters; this is what a figure shows, and its sign may be another.
struct Departure {
  double percent;          // [%] recorded over refitted q_c, less 100: mean of the cells
  double least, greatest;  // [%] of a cell
  double difference;       // [Pa] recorded less refitted q_c: mean of the cells
};

/// `recorded` and `refitted` (n) [ln q_c].
[[nodiscard]] Departure departure_on(const std::vector<Cell>& cells, const VectorXd& recorded,
                                     const VectorXd& refitted, const Mismatch& interval);

}  // namespace cpt::diagnosis

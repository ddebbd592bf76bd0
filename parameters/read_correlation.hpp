// The section [correlation] of a study: rank correlations between rows that have distributions.
#pragma once

#include <vector>

#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "parameters/study.hpp"

namespace cpt::parameters {

/// Pairs of rows, each once; none after an error. They must be rows of the design, which must be one that
/// draws them together (propagation), and make a matrix that is positive definite; where it is not, the hint
/// is the nearest one.
[[nodiscard]] std::vector<RankCorrelation> read_correlations(const Value& root, const std::vector<Row>& rows,
                                                             const Design& design, ErrorList& errors);

}  // namespace cpt::parameters

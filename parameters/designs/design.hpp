// The runs of a study's [design]. A design lives in the unit cube; one transform takes it to the rows'
// bounds.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "parameters/designs/kind.hpp"
#include "parameters/realization.hpp"
#include "parameters/study.hpp"

namespace cpt::parameters {

/// The one list of designs; first one_at_a_time, which adds no run.
[[nodiscard]] std::span<const DesignKind> all_designs();
[[nodiscard]] std::vector<std::string_view> design_kinds();           ///< their names
[[nodiscard]] const DesignKind& design_named(std::string_view name);  ///< throws std::out_of_range

/// Runs that the design asks for, before any is made.
[[nodiscard]] long run_count(const Design& design);

/// Runs x Design::rows: where each run lies between the lower (0) and the upper (1) bound of each row, as it
/// is run: a choice is at 0 or 1, a whole number where the nearest one is, which is what estimators must
/// know. Of a row with a distribution, in a design that samples, the probability that its value was drawn
/// with. NaN: left at its baseline. No rows for one_at_a_time.
[[nodiscard]] Eigen::MatrixXd design_places(const Study& study);

/// Correlation of the normal scores of the design's rows, in their order (distributions/copula.hpp).
[[nodiscard]] Eigen::MatrixXd score_correlations(const std::vector<RankCorrelation>& pairs,
                                                 const Design& design);

/// How many values a row takes between its bounds, equally spaced: two of a choice, the whole numbers; 0 for
/// any number.
[[nodiscard]] int values_of(const Row& row);

/// Value of a row at a place of the unit interval, in study units: linear from lower to upper and the nearest
/// whole number where it must be one; a choice is lower below 0.5, upper from 0.5 on.
[[nodiscard]] double value_at(const Row& row, double place);

/// The same of a design whose places are probabilities: the quantile of a row with a distribution, the
/// nearest whole number where it must be one; of any other row its value_at.
[[nodiscard]] double value_of_probability(const Row& row, double probability);

/// The design's runs as points, named "morris 3.2" (trajectory 3, its second run), "pairs 1.4", "sobol 7.A"
/// or "latin hypercube 5". What the study has a realization of already (with equal settings) is left out.
[[nodiscard]] std::vector<DesignPoint> design_points(const Study& study);

/// The realization of each run, in the order of design_places; indices into `realizations`, which are those
/// of the study with its design's points.
[[nodiscard]] std::vector<std::size_t> design_realizations(const Study& study,
                                                           std::span<const Realization> realizations);

}  // namespace cpt::parameters

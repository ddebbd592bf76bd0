// The numbers of a calibration as tables.
#pragma once

#include "reports/calibration/input.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::reports::calibrated {

/// A row an unknown: prior and posterior mean, standard deviation and quantiles, R-hat, effective sizes.
[[nodiscard]] results::Table posterior_table(const CalibrationReport& report);
/// The same for the eye: what stands on the terminal.
[[nodiscard]] results::Table short_posterior_table(const CalibrationReport& report);
/// A row a draw, a column an unknown.
[[nodiscard]] results::Table draws_table(const CalibrationReport& report);
/// Spearman's rank correlation of the inputs: a row and a column each.
[[nodiscard]] results::Table correlation_table(const CalibrationReport& report);
/// A row a cell of a channel and sounding: recorded, simulated, predicted and discrepancy.
[[nodiscard]] results::Table bands_table(const CalibrationReport& report);

/// A row an unknown: chi-square's probability, and whether the ECDF stays within the band.
[[nodiscard]] results::Table uniformity_table(const RankReport& report);
/// A row a recording and unknown: truth and rank.
[[nodiscard]] results::Table ranks_table(const RankReport& report);

}  // namespace cpt::reports::calibrated

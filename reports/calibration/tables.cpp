#include "reports/calibration/tables.hpp"

#include <cmath>

namespace cpt::reports::calibrated {
namespace {

using diagnosis::CalibratedBand;
using diagnosis::CalibratedUnknown;
using diagnosis::Spread;
using Eigen::Index;
using results::Cell;
using results::number_cell;
using results::Table;

void append(std::vector<Cell>& row, const Spread& spread) {
  for (const double value : {spread.mean, spread.deviation, spread.lower, spread.median, spread.upper})
    row.push_back(number_cell(value));
}

}  // namespace

Table posterior_table(const CalibrationReport& report) {
  Table table{{"unknown", "unit", "prior_mean", "prior_sd", "prior_05", "prior_50", "prior_95", "mean", "sd",
               "q05", "q50", "q95", "sd_over_prior_sd", "r_hat", "bulk_ess", "tail_ess"},
              {}};
  for (const CalibratedUnknown& unknown : report.posterior.unknowns) {
    std::vector<Cell> row{unknown.name, unknown.unit};
    append(row, unknown.prior);
    append(row, unknown.posterior);
    for (const double value : {unknown.left(), unknown.convergence.r_hat, unknown.convergence.bulk_size,
                               unknown.convergence.tail_size})
      row.push_back(number_cell(value));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table short_posterior_table(const CalibrationReport& report) {
  Table table{{"unknown", "unit", "prior_mean", "prior_sd", "mean", "sd", "q05", "q95", "r_hat", "ess"}, {}};
  for (const CalibratedUnknown& unknown : report.posterior.unknowns) {
    std::vector<Cell> row{unknown.name, unknown.unit};
    for (const double value :
         {unknown.prior.mean, unknown.prior.deviation, unknown.posterior.mean, unknown.posterior.deviation,
          unknown.posterior.lower, unknown.posterior.upper, unknown.convergence.r_hat})
      row.push_back(number_cell(value));
    const double size = unknown.convergence.least_size();
    row.push_back(std::isfinite(size) ? Cell(static_cast<std::int64_t>(size)) : Cell{});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table draws_table(const CalibrationReport& report) {
  Table table{{"draw"}, {}};
  for (const CalibratedUnknown& unknown : report.posterior.unknowns)
    table.columns.push_back(unknown.is_input ? unknown.name : unknown.name + " percent");
  const Eigen::MatrixXd& draws = report.posterior.draws;
  for (Index i = 0; i < draws.rows(); ++i) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.emplace_back(static_cast<std::int64_t>(i + 1));
    for (Index j = 0; j < draws.cols(); ++j) row.push_back(number_cell(draws(i, j)));
  }
  return table;
}

Table correlation_table(const CalibrationReport& report) {
  Table table{{"input"}, {}};
  for (const ReportedInput& input : report.inputs) table.columns.push_back(input.name);
  for (std::size_t i = 0; i < report.inputs.size(); ++i) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.emplace_back(report.inputs[i].name);
    for (std::size_t j = 0; j < report.inputs.size(); ++j)
      row.push_back(number_cell(report.posterior.correlation(static_cast<Index>(i), static_cast<Index>(j))));
  }
  return table;
}

Table bands_table(const CalibrationReport& report) {
  Table table{{"channel", "sounding", "depth_m", "recorded_kPa", "simulated_mean_kPa", "simulated_05_kPa",
               "simulated_95_kPa", "predicted_05_kPa", "predicted_95_kPa", "discrepancy_mean_percent",
               "discrepancy_05_percent", "discrepancy_95_percent"},
              {}};
  for (std::size_t c = 0; c < report.posterior.bands.size(); ++c)
    for (const CalibratedBand& band : report.posterior.bands[c]) {
      std::vector<Cell> row{report.channels[c].name,
                            report.soundings[static_cast<std::size_t>(band.cell.sounding)]};
      for (const double value : {band.cell.depth, band.recorded, band.simulation.mean, band.simulation.lower,
                                 band.simulation.upper, band.predicted.lower, band.predicted.upper,
                                 band.discrepancy.mean, band.discrepancy.lower, band.discrepancy.upper})
        row.push_back(number_cell(value));
      table.rows.push_back(std::move(row));
    }
  return table;
}

Table uniformity_table(const RankReport& report) {
  using namespace diagnosis;
  Table table{{"unknown", "recordings", "mean_rank", "chi_square_p", "within_95_band"}, {}};
  const RankCheck& check = report.check;
  const auto cases = static_cast<int>(check.cases.size());
  const EcdfDifference band = simultaneous_band(cases, check.draws, 0.95, report.seed);
  for (std::size_t j = 0; j < check.unknowns.size(); ++j) {
    const Eigen::VectorXi ranks = check.ranks.col(static_cast<Index>(j));
    const bool within = stays_within(ecdf_difference(ranks, check.draws, band.at), band);
    table.rows.push_back({check.unknowns[j], std::int64_t{cases}, ranks.cast<double>().mean(),
                          uniformity(ranks, check.draws, rank_bins), std::string(within ? "yes" : "no")});
  }
  return table;
}

Table ranks_table(const RankReport& report) {
  Table table{{"recording", "unknown", "truth", "rank", "draws", "converged"}, {}};
  const diagnosis::RankCheck& check = report.check;
  for (std::size_t i = 0; i < check.cases.size(); ++i)
    for (std::size_t j = 0; j < check.unknowns.size(); ++j) {
      const auto row = static_cast<Index>(i), column = static_cast<Index>(j);
      table.rows.push_back({check.cases[i], check.unknowns[j], number_cell(check.truths(row, column)),
                            std::int64_t{check.ranks(row, column)}, std::int64_t{check.draws},
                            std::string(check.converged[i] ? "yes" : "no")});
    }
  return table;
}

}  // namespace cpt::reports::calibrated

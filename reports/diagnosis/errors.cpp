#include "reports/diagnosis/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/diagnosis/words.hpp"

namespace cpt::reports::diagnosed {

VectorXd percent_above(const VectorXd& recorded, const VectorXd& simulated) {
  return (recorded - simulated).unaryExpr([](double x) { return percent_of(x); });
}

diagnosis::Departure departure(const DiagnosisInput& input, const diagnosis::Mismatch& interval) {
  return diagnosis::departure_on(input.diagnosis.compared.cells, input.recorded,
                                 input.diagnosis.null.recalibrated.curve, interval);
}

double rmse(const VectorXd& a, const VectorXd& b) {
  double sum = 0.0;
  int count = 0;
  for (Index i = 0; i < a.size(); ++i) {
    const double away = a(i) - b(i);
    if (!std::isfinite(away)) continue;
    sum += away * away;
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : std::numeric_limits<double>::quiet_NaN();
}

std::optional<VectorXd> solver_in_cells(const DiagnosisInput& input) {
  if (std::ranges::none_of(input.soundings, [](const Sounding& s) { return s.solver.has_value(); }))
    return std::nullopt;
  VectorXd curve = VectorXd::Constant(input.recorded.size(), std::numeric_limits<double>::quiet_NaN());
  for (Index i = 0; i < curve.size(); ++i) {
    const diagnosis::Cell& cell = input.diagnosis.compared.cells[static_cast<std::size_t>(i)];
    const Sounding& sounding = input.soundings[static_cast<std::size_t>(cell.sounding)];
    if (sounding.solver)
      curve(i) = diagnosis::log_cell_means({cell.depth - 0.5 * cell.height, cell.height, 1},
                                           sounding.solver->depth, sounding.solver->q_c)(0);
  }
  return curve;
}

VectorXd noise_deviation(const DiagnosisInput& input) {
  const diagnosis::Compared& d = input.diagnosis.compared;
  const double measurement = d.measurement.deviation * d.measurement.deviation;
  VectorXd variance = VectorXd::Constant(input.recorded.size(), measurement);
  if (d.numerical && d.numerical->covariance.rows() == variance.size())
    variance += input.noise.numerical_shares * d.numerical->covariance.diagonal();
  return variance.cwiseMax(0.0).cwiseSqrt();
}

}  // namespace cpt::reports::diagnosed

#include "parameters/calibration/trend.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "solver/constitutive/critical_state_line.hpp"

namespace cpt::calibration {

std::optional<HardeningTrend> hardening_trend(const std::vector<HardeningFit>& fits, TrendIn in) {
  std::vector<HardeningFit> sound;
  for (const HardeningFit& fit : fits)
    if (fit.problem.empty()) sound.push_back(fit);
  const Eigen::Index columns = in == TrendIn::psi ? 2 : 3;
  const auto rows = static_cast<Eigen::Index>(sound.size());
  if (rows <= columns) return std::nullopt;

  Eigen::MatrixXd states(rows, columns);
  Eigen::VectorXd H(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const HardeningFit& fit = sound[static_cast<std::size_t>(i)];
    states(i, 0) = 1.0;
    states(i, 1) = fit.psi_0;
    if (columns == 3) states(i, 2) = std::log(fit.p_0 / solver::reference_pressure);
    H(i) = fit.H;
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(states);
  if (qr.rank() < columns) return std::nullopt;
  const Eigen::VectorXd x = qr.solve(H);
  const double spread = (H.array() - H.mean()).square().sum();
  const double rest = (H - states * x).squaredNorm();
  return HardeningTrend{x(0), x(1), columns == 3 ? x(2) : 0.0, spread > 0.0 ? 1.0 - rest / spread : 1.0,
                        static_cast<int>(rows)};
}

}  // namespace cpt::calibration

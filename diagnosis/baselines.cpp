#include "diagnosis/baselines.hpp"

#include <cmath>

#include "diagnosis/quadrature.hpp"

namespace cpt::diagnosis {

LeastSquares least_squares(const Prepared& prepared) {
  constexpr int nodes[] = {41, 11, 7};
  const auto mechanisms = static_cast<Index>(prepared.emulators.size());
  const VectorXd& recorded = prepared.problem.recorded;
  const auto n = static_cast<double>(recorded.size());
  const Whitener independent(MatrixXd(MatrixXd::Identity(recorded.size(), recorded.size())));
  const auto fit = [&](const VectorXd& y) {
    return recalibrate(prepared.null.parameters, y, independent).rmse;
  };

  LeastSquares result;
  result.rmse.resize(mechanisms + 1);
  VectorXd bic(mechanisms + 1);
  const auto criterion = [&](double rmse, Index parameters) {
    return 2.0 * n * std::log(std::max(rmse, 1e-9)) + static_cast<double>(parameters) * std::log(n);
  };
  const Index soil = prepared.null.parameters.parameters() + 1;  // and the error's size
  for (Index k = 0; k < mechanisms; ++k) {
    const CurveEmulator& emulator = prepared.emulators[static_cast<std::size_t>(k)];
    const Index d = emulator.dimensions();
    const MatrixXd points = box_rule(VectorXd::Zero(d), VectorXd::Ones(d), nodes[d - 1]).nodes;
    const MatrixXd curves = emulator.components() * emulator.scores(points);
    double least = fit(recorded);
    for (Index i = 0; i < curves.cols(); ++i) least = std::min(least, fit(recorded - curves.col(i)));
    result.rmse(k) = least;
    bic(k) = criterion(least, soil + d);
  }
  result.rmse(mechanisms) = fit(recorded);
  bic(mechanisms) = criterion(result.rmse(mechanisms), soil);
  result.bic_weights = (-0.5 * (bic.array() - bic.minCoeff())).exp();
  result.bic_weights /= result.bic_weights.sum();
  Index best = 0;
  result.bic_weights.maxCoeff(&best);
  result.best_bic = static_cast<std::size_t>(best);
  best = 0;
  if (mechanisms > 0) result.rmse.head(mechanisms).minCoeff(&best);
  result.best_rmse = static_cast<std::size_t>(best);
  return result;
}

}  // namespace cpt::diagnosis

#include "validation/concealed/baselines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/quadrature.hpp"

namespace cpt::validation::concealed {
namespace {

using diagnosis::box_rule, diagnosis::CurveEmulator, diagnosis::Index, diagnosis::MatrixXd,
    diagnosis::Prepared, diagnosis::recalibrate, diagnosis::VectorXd, diagnosis::Whitener;

// Least of `rmse_at` over the mechanism's parameters: on a grid of the whole unit box, then on one of the
// same number of nodes about the best.
template <class Function>
double least_over_box(Index dimensions, const Function& rmse_at) {
  constexpr int nodes[] = {15, 6, 4};
  VectorXd lower = VectorXd::Zero(dimensions), upper = VectorXd::Ones(dimensions);
  double least = std::numeric_limits<double>::infinity();
  for (int grid = 0; grid < 2; ++grid) {
    const int n = nodes[dimensions - 1];
    const MatrixXd points = box_rule(lower, upper, n).nodes;
    VectorXd best = points.row(0);
    for (Index i = 0; i < points.rows(); ++i) {
      const double rmse = rmse_at(points.row(i));
      if (rmse < least) {
        least = rmse;
        best = points.row(i);
      }
    }
    lower = (best.array() - 1.0 / n).max(0.0);
    upper = (best.array() + 1.0 / n).min(1.0);
  }
  return least;
}

}  // namespace

LeastSquares least_squares(const Prepared& prepared) {
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
  result.rmse(mechanisms) = fit(recorded);
  const Index soil = prepared.null.parameters.parameters() + 1;  // and the error's size
  for (Index k = 0; k < mechanisms; ++k) {
    const CurveEmulator& emulator = prepared.emulators[static_cast<std::size_t>(k)];
    const double best = least_over_box(emulator.dimensions(), [&](const auto& place) {
      return fit(recorded - emulator.components() * emulator.scores(MatrixXd(place)));
    });
    result.rmse(k) = std::min(result.rmse(mechanisms), best);
    bic(k) = criterion(result.rmse(k), soil + emulator.dimensions());
  }
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

}  // namespace cpt::validation::concealed

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

void set_weights(std::vector<LeastSquares::Fit>& fits, double cells) {
  VectorXd bic(static_cast<Index>(fits.size()));
  std::ranges::transform(fits, bic.begin(), [&](const LeastSquares::Fit& fit) {
    return 2.0 * cells * std::log(std::max(fit.rmse, 1e-9)) +
           static_cast<double>(fit.parameters) * std::log(cells);
  });
  VectorXd weights = (-0.5 * (bic.array() - bic.minCoeff())).exp();
  weights /= weights.sum();
  for (std::size_t k = 0; k < fits.size(); ++k) fits[k].bic_weight = weights(static_cast<Index>(k));
}

}  // namespace

const LeastSquares::Fit& LeastSquares::least_rmse() const {
  const auto mechanisms_end = fits.size() > 1 ? fits.end() - 1 : fits.end();
  return *std::ranges::min_element(fits.begin(), mechanisms_end, {}, &Fit::rmse);
}

const LeastSquares::Fit& LeastSquares::greatest_weight() const {
  return *std::ranges::max_element(fits, {}, &Fit::bic_weight);
}

LeastSquares least_squares(const Prepared& prepared) {
  const VectorXd& recorded = prepared.problem.recorded;
  const Whitener independent(MatrixXd(MatrixXd::Identity(recorded.size(), recorded.size())));
  const auto rmse_of = [&](const VectorXd& y) {
    return recalibrate(prepared.null.parameters, y, independent).rmse;
  };
  const Index soil = prepared.null.parameters.parameters() + 1;  // and the error's size
  const double null = rmse_of(recorded);
  LeastSquares found;
  for (const CurveEmulator& emulator : prepared.emulators) {
    const double best = least_over_box(emulator.dimensions(), [&](const auto& place) {
      return rmse_of(recorded - emulator.components() * emulator.scores(MatrixXd(place)));
    });
    found.fits.push_back({emulator.name(), soil + emulator.dimensions(), std::min(null, best), 0.0});
  }
  found.fits.push_back({diagnosis::nothing_is_missing, soil, null, 0.0});
  set_weights(found.fits, static_cast<double>(recorded.size()));
  return found;
}

}  // namespace cpt::validation::concealed

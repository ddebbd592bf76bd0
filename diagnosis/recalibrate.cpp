#include <algorithm>
#include <cmath>

#include "diagnosis/parameters_prior.hpp"

namespace cpt::diagnosis {
namespace {

// Minimizes x^T A x / 2 - g^T x in lower <= x <= upper, A positive definite, by coordinate descent.
VectorXd box_minimum(const MatrixXd& A, const VectorXd& g, const VectorXd& lower, const VectorXd& upper) {
  VectorXd x = VectorXd::Zero(g.size());
  for (int sweep = 0; sweep < 1000; ++sweep) {
    double moved = 0.0;
    for (Index j = 0; j < x.size(); ++j) {
      const double to = std::clamp(x(j) + (g(j) - A.row(j).dot(x)) / A(j, j), lower(j), upper(j));
      moved = std::max(moved, std::abs(to - x(j)));
      x(j) = to;
    }
    if (moved < 1e-9) break;
  }
  return x;
}

// `free` is the box of each parameter; a closed one (lower = upper) is held.
VectorXd minimize(const ResponseSurface& model, const VectorXd& y, const Whitener& sigma, VectorXd t,
                  const VectorXd& lower, const VectorXd& upper) {
  VectorXd rest = sigma.whiten(y - model.predict(t));
  for (int iteration = 0; iteration < 50; ++iteration) {
    const MatrixXd J = sigma.whiten(model.jacobian(t));
    MatrixXd A = J.transpose() * J;
    A.diagonal().array() += 1e-6 * (1.0 + A.trace() / static_cast<double>(A.rows()));
    VectorXd step = box_minimum(A, J.transpose() * rest, lower - t, upper - t);
    bool better = false;
    for (int halving = 0; halving < 12 && !better; ++halving, step *= 0.5) {
      const VectorXd trial_rest = sigma.whiten(y - model.predict(t + step));
      better = trial_rest.squaredNorm() < rest.squaredNorm();
      if (!better) continue;
      t += step;
      rest = trial_rest;
    }
    if (!better || step.cwiseAbs().maxCoeff() < 1e-6) break;
  }
  return t;
}

}  // namespace

Recalibration recalibrate(const ResponseSurface& model, const VectorXd& y, const Whitener& sigma) {
  const Index p = model.parameters();
  Recalibration result;
  result.place = model.baseline_place();
  if (p > 0) {
    VectorXd lower = VectorXd::Zero(p), upper = VectorXd::Ones(p);
    result.place = minimize(model, y, sigma, result.place, lower, upper);
    bool choices = false;
    for (Index j = 0; j < p; ++j) {
      if (!model.two_valued(j)) continue;
      result.place(j) = lower(j) = upper(j) = result.place(j) < 0.5 ? 0.0 : 1.0;
      choices = true;
    }
    if (choices) result.place = minimize(model, y, sigma, result.place, lower, upper);
  }
  const MatrixXd J = sigma.whiten(model.jacobian(result.place));
  const MatrixXd information = J.transpose() * J + 12.0 * MatrixXd::Identity(p, p);
  result.deviation = information.inverse().diagonal().cwiseSqrt();
  result.curve = model.predict(result.place);
  result.rmse = std::sqrt((y - result.curve).squaredNorm() / static_cast<double>(y.size()));
  return result;
}

}  // namespace cpt::diagnosis

#include "diagnosis/several/soil_scaling.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::diagnosis {
namespace {

// One curve's joint runs: what the effect does at the baseline's soil, and what is left of the runs.
struct Runs {
  MatrixXd effect, rest;  // cells x runs
  const MatrixXd& soil;   // runs x p
};

// c from all runs but `left_out` (none: -1).
VectorXd coefficients(const Runs& runs, double penalty, Index left_out) {
  const Index p = runs.soil.cols();
  MatrixXd normal = MatrixXd::Zero(p, p);
  VectorXd right = VectorXd::Zero(p);
  for (Index k = 0; k < runs.soil.rows(); ++k) {
    if (k == left_out) continue;
    const VectorXd s = runs.soil.row(k).transpose();
    normal += runs.effect.col(k).squaredNorm() * s * s.transpose();
    right += runs.effect.col(k).dot(runs.rest.col(k)) * s;
  }
  normal.diagonal().array() += penalty;
  return normal.ldlt().solve(right);
}

MatrixXd left_out_residuals(const Runs& runs, double penalty) {
  MatrixXd residuals = runs.rest;
  for (Index k = 0; k < runs.soil.rows(); ++k)
    residuals.col(k) -= runs.soil.row(k).dot(coefficients(runs, penalty, k)) * runs.effect.col(k);
  return residuals;
}

}  // namespace

SoilScaling::SoilScaling(const std::vector<Cell>& cells, const MechanismEffect& effect,
                         const CurveEmulator& emulator)
    : emulator_(&emulator), left_out_(emulator.joint_residuals()) {
  const Index joint = effect.joint_soil.rows(), p = effect.joint_soil.cols();
  if (joint < 2 || p == 0 || left_out_.cols() != joint) return;
  const MatrixXd here = emulator.components() * emulator.scores(effect.joint_design);
  const auto n = static_cast<Index>(cells.size());
  for (Index top = 0, bottom = 0; top < n; top = bottom) {
    const auto cell = [&](Index i) { return cells[static_cast<std::size_t>(i)]; };
    while (bottom < n && cell(bottom).same_curve(cell(top))) ++bottom;
    const Index count = bottom - top;
    const Runs runs{here.middleRows(top, count), left_out_.middleRows(top, count), effect.joint_soil};
    double least = runs.rest.squaredNorm();  // the same effect in all soil
    const double power = runs.effect.squaredNorm() / static_cast<double>(joint);
    Part part{top, count, VectorXd::Zero(p)};
    if (!(power > 0.0)) continue;
    for (int step = 0; step <= 8; ++step) {
      const double penalty = power * std::pow(10.0, 1.0 - 0.5 * step);
      const MatrixXd residuals = left_out_residuals(runs, penalty);
      if (!(residuals.squaredNorm() < least)) continue;
      least = residuals.squaredNorm();
      left_out_.middleRows(top, count) = residuals;
      part.c = coefficients(runs, penalty, -1);
    }
    parts_.push_back(std::move(part));
  }
}

CurveEmulator SoilScaling::at(const VectorXd& s) const {
  constexpr double least = 0.1;
  VectorXd factors = VectorXd::Ones(emulator_->components().rows());
  for (const Part& part : parts_)
    factors.segment(part.top, part.count).setConstant(std::max(least, 1.0 + part.c.dot(s)));
  return emulator_->scaled(factors, left_out_);
}

}  // namespace cpt::diagnosis

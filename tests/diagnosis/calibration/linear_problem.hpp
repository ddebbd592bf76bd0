// A calibration whose emulator is linear: with known deviations its posterior is normal and known.
#pragma once

#include <cmath>

#include "diagnosis/calibration/calibration_model.hpp"

namespace cpt::diagnosis {

inline const MatrixXd linear_effects = (MatrixXd(2, 2) << 0.5, 0.1, 0.0, 0.2).finished();
inline constexpr double linear_variance = 1e-3;  // of each score

/// Two inputs with correlated normal scores that are their values, one channel of two components on 20 cells.
inline CalibrationProblem linear_problem(double discrepancy, double noise) {
  constexpr Index n = 20;
  CalibrationProblem problem;
  problem.soundings = {"first"};
  const auto same = [](double value) { return value; };
  problem.inputs = {{"a", "kPa", same, same, -1e9, 1e9}, {"b", "-", same, same, -1e9, 1e9}};
  problem.correlation = (MatrixXd(2, 2) << 1.0, 0.4, 0.4, 1.0).finished();
  CalibrationChannel channel;
  channel.name = "q_c";
  channel.logarithmic = true;
  channel.shapes.resize(n, 2);
  for (Index i = 0; i < n; ++i) {
    channel.cells.push_back({0, 0.0525 + 0.005 * static_cast<double>(i), 0.005});
    channel.shapes.row(i) << 1.0 / std::sqrt(20.0), (static_cast<double>(i) - 9.5) / 25.8;
  }
  channel.mean = VectorXd::Constant(n, 3.0);
  channel.recorded = channel.mean;
  channel.left_out = 1e-5 * MatrixXd::Identity(n, n);
  channel.scores = [](const Eigen::RowVectorXd& place) {
    return ScorePrediction{linear_effects * place.transpose(), VectorXd::Constant(2, linear_variance)};
  };
  channel.discrepancy = discrepancy;
  channel.length = 0.1;
  channel.noise = noise;
  problem.channels = {channel};
  return problem;
}

/// A recording of a truth with the problem's noise.
inline VectorXd linear_recording(const CalibrationProblem& problem, double a, double b, std::uint64_t seed) {
  const CalibrationChannel& channel = problem.channels.front();
  Random random(seed, 0);
  return channel.mean + channel.shapes * (linear_effects * Eigen::Vector2d(a, b)) +
         channel.noise * random.normals(channel.mean.size());
}

}  // namespace cpt::diagnosis

// How good an emulator is at runs that it has not seen.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <string>

#include "results/emulator/output_emulator.hpp"

namespace cpt::results {

inline constexpr double normal_95 = 1.959963984540054;  ///< 97.5 % point of the standard normal distribution

/// An output whose Q2 is below is refused: more than a tenth of the variance is missed.
inline constexpr double least_emulator_q2 = 0.9;
inline constexpr int validation_folds = 10;  ///< as many as there are runs, where they are fewer

struct Validation {
  int runs = 0;           ///< each held out once
  double q2 = 0.0;        ///< 1 - squared errors over squared deviations from the mean of all runs
  double rmse = 0.0;      ///< root of the mean squared error, in the output's unit
  double coverage = 0.0;  ///< share of the values that lie in their 95 % intervals
  double coverage_lower = 0.0, coverage_upper = 0.0;  ///< its 95 % interval (wilson), as of `runs` trials
  [[nodiscard]] bool refused() const { return !(q2 >= least_emulator_q2); }
};

/// 1 - sum of squared errors over the sum of squared deviations of each value from its mean over the runs
/// (values x runs): 1 is perfect, 0 as good as the mean; Q2 of Marrel, Iooss, Laurent & Roustant (2009),
/// Reliability Engineering & System Safety 94, 742-751, eq. 14, over all values of a curve together.
[[nodiscard]] double predictivity(const Eigen::MatrixXd& outputs, const Eigen::MatrixXd& predicted);

/// Interval of a share of `trials` (Wilson 1927, Journal of the American Statistical Association 22,
/// 209-212), with 95 %. The values of one curve are no independent trials: runs are.
struct Share {
  double lower, upper;
};
[[nodiscard]] Share wilson(double share, int trials);

/// Cross-validation: run i is held out in fold i mod 10 and predicted by an emulator that is fitted to the
/// others from the beginning: components, lengths, nugget, trend. Only whether it is logarithmic is given.
/// Folds that cannot be fitted throw std::invalid_argument.
[[nodiscard]] Validation cross_validation(const Eigen::MatrixXd& design, const Eigen::MatrixXd& outputs,
                                          bool logarithmic, const OutputEmulator::Options& options = {});

/// Of an emulator at other runs than its own.
[[nodiscard]] Validation validation_at(const OutputEmulator& emulator, const Eigen::MatrixXd& design,
                                       const Eigen::MatrixXd& outputs);

}  // namespace cpt::results

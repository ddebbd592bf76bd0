// All parameters of NorSand that laboratory tests tell, at once: least squares over all curves.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "parameters/calibration/first_estimates.hpp"
#include "parameters/calibration/fit_parameters.hpp"
#include "parameters/calibration/simulated_tests.hpp"

namespace cpt::calibration {

struct ParameterFit {
  const FitParameter* parameter;
  double given;              ///< what follows in study units: before the fit
  double first = not_given;  ///< by hand (first_estimates.hpp); NaN where the tests tell none that way
  double value;              ///< the fit's, or `given` where the tests do not tell it
  bool told = false;
  /// On the parameter's scale: of ln(value) where that is fitted. NaN where it is not told, and so are the
  /// ends of the interval that holds the truth with 95 %, in study units.
  double standard_deviation = not_given;
  double low = not_given, high = not_given;
  std::string remark = {};  ///< why it is not told, or what is odd about it; empty if all is well
};

/// Residuals of one channel over all tests, on its scale.
struct ChannelScatter {
  int readings = 0;
  double scatter = not_given;  ///< standard deviation of one reading; NaN without readings
  bool estimated = false;  ///< from the residuals, not assumed, as it is for fewer than 2 degrees of freedom
  double autocorrelation = 0.0;  ///< of neighbouring residuals
  double inflation = 1.0;        ///< of variances, (1 + r) / (1 - r) where r is above what chance gives
};

struct JointFit {
  solver::NorSandParameters sand;  ///< with all that is told in place
  FirstEstimates first;
  std::vector<ParameterFit> parameters;  ///< those asked for, in the law's order
  Eigen::MatrixXd correlation;           ///< Pearson's, of those told, in their order, on their scales
  std::array<ChannelScatter, channel_count> channels;
  int degrees_of_freedom = 0;
  int simulations = 0;  ///< of all tests
  /// Root mean square residual of each observation's test and channel, on the channel's scale; tests by rows.
  Eigen::MatrixXd misfit;
  std::string problem;  ///< why there is no fit; empty if there is one
};

/// The free parameters that minimize sum(((simulated - measured) / scatter)^2) over all readings
/// (simulated_tests.hpp), in their valid ranges: Levenberg-Marquardt (More 1978; MINPACK as Eigen has it) on
/// logits of the place in the range, from the first estimates or, if these lie farther off, from `sand`.
///
/// The scatter of each channel is estimated in turns with the fit: sum of squares over readings less the
/// degrees of freedom that the fit took of them, the trace of the channel's part of the hat matrix
/// (restricted maximum likelihood; Searle, Casella & McCulloch 1992, Variance Components, ch. 6).
/// Covariance s^2 (J^T J)^-1 with J at the minimum (Seber & Wild 1989, Nonlinear Regression, ch. 5), 95 %
/// intervals with Student's t. Where neighbouring residuals of a channel go together (r > 2 / sqrt(n)) they
/// count for fewer readings, (1 - r) / (1 + r) of them (Bayley & Hammersley 1946).
///
/// A parameter whose interval is wider than half of its valid range, on its scale, is not told by these
/// tests: it is kept as given, the widest one first, and the others are fitted again. Their intervals hold
/// for the given values of what is not told. The same tests give the same bits.
[[nodiscard]] JointFit fit_jointly(const LaboratoryTests& tests, const solver::NorSandParameters& sand,
                                   std::span<const FitParameter* const> free);

}  // namespace cpt::calibration

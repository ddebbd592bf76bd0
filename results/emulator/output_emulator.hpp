// An output of the runs, a number or a curve, between the runs that were made: principal components, and for
// the score of each a Gaussian process (Higdon, Gattiker, Williams & Rightley 2008, Journal of the American
// Statistical Association 103, 570-583). What the components leave out is noise.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "results/emulator/gaussian_process.hpp"
#include "results/emulator/principal_components.hpp"

namespace cpt::results {

/// What an output is expected to be at each point; values x points, in the output's unit.
struct OutputPrediction {
  Eigen::MatrixXd value;         ///< expected value of a run
  Eigen::MatrixXd error;         ///< standard error of a run there: of the emulator, with the runs' own noise
  Eigen::MatrixXd lower, upper;  ///< 95 % interval of a run there
};

class OutputEmulator {
 public:
  struct Options {
    double variance_left = 1e-4;  ///< share of the curves' variance that the components may leave out
    Eigen::Index most_components = 8;
    KernelSearch search = {};
  };

  /// `design`: runs x inputs, in the unit cube; `outputs`: values x runs. `logarithmic`: works on ln(output),
  /// which must be positive. Trends are quadratic where the runs suffice (trend_for). Throws
  /// std::invalid_argument as GaussianProcess and for outputs that do not vary.
  [[nodiscard]] static OutputEmulator fit(const Eigen::MatrixXd& design, const Eigen::MatrixXd& outputs,
                                          bool logarithmic, const Options& options);
  [[nodiscard]] static OutputEmulator fit(const Eigen::MatrixXd& design, const Eigen::MatrixXd& outputs,
                                          bool logarithmic);
  /// The better of the two by left_out_q2; the logarithm only where all outputs are positive.
  [[nodiscard]] static OutputEmulator fit(const Eigen::MatrixXd& design, const Eigen::MatrixXd& outputs);

  /// From its parts, as they were stored. Throws std::invalid_argument for parts that do not agree.
  OutputEmulator(PrincipalComponents components, std::vector<GaussianProcess> processes, bool logarithmic);

  [[nodiscard]] Eigen::Index inputs() const { return processes_.front().inputs(); }
  [[nodiscard]] Eigen::Index values() const { return components_.mean.size(); }
  [[nodiscard]] bool logarithmic() const { return logarithmic_; }
  [[nodiscard]] const PrincipalComponents& components() const { return components_; }
  [[nodiscard]] const std::vector<GaussianProcess>& processes() const { return processes_; }

  /// `points`: points x inputs, in the unit cube.
  [[nodiscard]] OutputPrediction predict(const Eigen::MatrixXd& points) const;

  // Before exp() where it is logarithmic; the components are independent of each other.
  [[nodiscard]] Eigen::MatrixXd score_means(const Eigen::MatrixXd& points) const;  ///< components x points
  [[nodiscard]] Eigen::MatrixXd score_variances(const Eigen::MatrixXd& points) const;  ///< the same, no noise
  /// Of one point each component's mean, and its variance with the scatter of runs.
  struct ScoresAtPoint {
    Eigen::VectorXd mean, variance;
  };
  [[nodiscard]] ScoresAtPoint scores_at(const Eigen::RowVectorXd& point) const;
  [[nodiscard]] Eigen::VectorXd noise() const;  ///< variance of a run's own noise at each value

  /// 1 - squared errors over squared deviations from the mean, in the output's unit, each run predicted from
  /// all others with the same kernels and shapes; `outputs` are those it was fitted to.
  [[nodiscard]] double left_out_q2(const Eigen::MatrixXd& outputs) const;

 private:
  PrincipalComponents components_;
  std::vector<GaussianProcess> processes_;  // one a component
  bool logarithmic_;
};

}  // namespace cpt::results

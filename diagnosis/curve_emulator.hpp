// A mechanism's effect on the curve, delta y(phi) = y(phi) - y_baseline, between the runs that were made.
//
// Principal components of the runs' curves; for each component's score a Gaussian process with a polynomial
// trend (universal kriging) in phi, the mechanism's parameters scaled to the unit cube. Lengths and nugget of
// each process maximize the leave-one-out predictive density (Sundararajan and Keerthi 2001), which for a
// kriging with trend comes from the inverse of one bordered matrix (Dubrule 1983).
#pragma once

#include <string>

#include "diagnosis/depth_grid.hpp"

namespace cpt::diagnosis {

/// The runs of one mechanism with the soil parameters of the baseline, and its seed, mesh and time steps.
struct MechanismEffect {
  std::string name;
  std::vector<std::string> parameters;  ///< 1 to 3; the first is the strength where vanishes_at_zero
  MatrixXd design;                      // runs x parameters, in the unit cube
  MatrixXd delta;                       // n x runs [ln q_c] y - y_baseline
  bool vanishes_at_zero = true;         ///< delta = 0 where the first coordinate is 0
  // With other soil parameters, to see how far the mechanism acts alike in other soil; or none.
  MatrixXd joint_design = {};  // joint runs x parameters, in the unit cube
  MatrixXd joint_delta = {};  // n x joint runs [ln q_c] y - what the soil's parameters alone would make of it
  MatrixXd joint_soil = {};   // joint runs x p [-] the soil's places t less the baseline's
};

class CurveEmulator {
 public:
  struct Options {
    double variance_left = 1e-6;  ///< share of the curves' variance that may be left to the error
    int most_components = 8;
    int error_rank = 3;
  };

  /// Throws std::invalid_argument for shapes that do not agree, a design outside the cube, or fewer than
  /// 4 runs for each parameter.
  explicit CurveEmulator(const MechanismEffect& effect);
  CurveEmulator(const MechanismEffect& effect, const Options& options);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<std::string>& parameters() const { return parameters_; }
  [[nodiscard]] Index dimensions() const { return static_cast<Index>(parameters_.size()); }
  [[nodiscard]] bool vanishes_at_zero() const { return vanishes_at_zero_; }

  /// Mean of delta y (n) at phi in the unit cube.
  [[nodiscard]] VectorXd mean(const VectorXd& phi) const;
  /// Its covariance there: error_scale(phi) times error_covariance().
  [[nodiscard]] MatrixXd covariance(const VectorXd& phi) const;

  /// Mean curves are components() (n x c) times scores(points x dimensions) (c x points).
  [[nodiscard]] const MatrixXd& components() const { return components_; }
  [[nodiscard]] MatrixXd scores(const MatrixXd& points) const;
  /// Size of the error at each point, one shape everywhere: the kriging variance over its mean in
  /// leave-one-out, least near the runs and at no strength; and, for the joint runs' share, the effect's
  /// square over theirs.
  [[nodiscard]] VectorXd error_scale(const MatrixXd& points) const;
  /// Second moments of the leave-one-out residuals and of the joint runs' residuals, each low rank plus
  /// diagonal, added (n x n) [ln^2].
  [[nodiscard]] const MatrixXd& error_covariance() const { return error_; }
  /// The leave-one-out residuals (n x runs).
  [[nodiscard]] const MatrixXd& left_out_residuals() const { return left_out_; }
  /// What the joint runs lie off the emulator (n x joint runs).
  [[nodiscard]] const MatrixXd& joint_residuals() const { return joint_left_; }
  /// Size of the error at each point over the leave-one-out residuals' variance, and over the joint runs':
  /// the kriging variance over its mean in leave-one-out; the effect's square over theirs.
  struct ErrorScales {
    VectorXd left_out, joint;  // points
  };
  [[nodiscard]] ErrorScales error_scales(const MatrixXd& points) const;

  /// The effect times a factor in each cell (n), with these residuals of the joint runs (n x joint runs).
  [[nodiscard]] CurveEmulator scaled(const VectorXd& factors, const MatrixXd& joint_residuals) const;
  /// The emulator on some of its cells.
  [[nodiscard]] CurveEmulator rows(const std::vector<Index>& kept) const;

 private:
  // One score's process: y(phi) = h(phi) b + Z(phi), solved through B = [K H; H^T 0]^-1.
  struct Process {
    VectorXd lengths;  // of the unit cube, each dimension
    MatrixXd inverse;  // B
    VectorXd weights;  // B (y, 0)
    double variance;   // of Z
  };

  void fit(const VectorXd& values, Process& process) const;
  [[nodiscard]] bool factor(const VectorXd& lengths, double nugget, const VectorXd& values, Process& process,
                            double& score) const;
  [[nodiscard]] MatrixXd border(const Process& process, const MatrixXd& points) const;

  std::string name_;
  std::vector<std::string> parameters_;
  bool vanishes_at_zero_;
  Index runs_;       // without the anchors at no strength, which come last
  MatrixXd design_;  // (runs + anchors) x dimensions
  MatrixXd trend_;   // H at the design
  bool quadratic_;   // trend
  MatrixXd components_;
  std::vector<Process> processes_;
  double left_out_variance_ = 0.0;  // mean over runs, all scores together
  double left_out_share_ = 1.0;     // of the error's trace; the rest is the joint runs'
  double joint_power_ = 1.0;        // mean square of the joint runs' scores
  MatrixXd left_out_, joint_left_, error_;
};

}  // namespace cpt::diagnosis

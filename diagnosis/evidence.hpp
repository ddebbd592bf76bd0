// How probable each mechanism makes the recording, the soil parameters and its own parameters integrated out.
//
//   Z_k = integral over phi in the unit cube of N(r; Delta_k(phi), M + E_k(phi)),   r = recorded - null mean,
//
// the prior of phi being uniform on the cube. The grid covers the cube, so that several modes (a lens at this
// depth or that) all count, and is laid anew around what carries weight until that fills it.
#pragma once

#include "diagnosis/curve_emulator.hpp"
#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {

/// ln N(r; Delta(phi), M + E(phi)) at many phi. One simultaneous diagonalization of M and the shape of E
/// makes every point cost O(n).
class MechanismLikelihood {
 public:
  MechanismLikelihood(const CurveEmulator& emulator, const Whitener& null);

  /// At each row of points (points x dimensions), for one residual (n).
  [[nodiscard]] VectorXd log_density(const MatrixXd& points, const VectorXd& residual) const;
  [[nodiscard]] const CurveEmulator& emulator() const { return emulator_; }

 private:
  CurveEmulator emulator_;
  Whitener null_;
  MatrixXd rotation_;    // V^T, for V^T L^-1 E L^-T V = diag(relative_)
  VectorXd relative_;    // error over null variance
  MatrixXd components_;  // V^T L^-1 times the emulator's
};

struct GridOptions {
  int nodes[3] = {101, 33, 15};  ///< in each direction, for 1, 2 and 3 parameters
  int refinements = 4;           ///< at the most
  double strength_limit = 1.0;   ///< the prior's range of the strength, where there is one: [0, limit]
};

/// A mechanism's evidence and the posterior of its parameters.
struct MechanismEvidence {
  std::string name;
  double log_evidence;       // ln of a density in ln q_c
  VectorXd mean, deviation;  // of phi
  VectorXd mode;             // the grid's best node
  VectorXd lower, upper;     // 90 % intervals of each parameter alone
  MatrixXd nodes;            // points x dimensions, the last grid
  VectorXd probability;      // of each node; sums to 1
};

[[nodiscard]] MechanismEvidence mechanism_evidence(const MechanismLikelihood& likelihood,
                                                   const VectorXd& residual, const GridOptions& options = {});

/// Two mechanisms at once, their curves added.
struct PairEvidence {
  std::string first, second;
  double log_evidence;
  VectorXd first_mode, second_mode;
};

/// As above with the covariance M + E_1 + E_2, the errors at their leave-one-out size everywhere.
[[nodiscard]] PairEvidence pair_evidence(const CurveEmulator& first, const CurveEmulator& second,
                                         const MatrixXd& null_covariance, const VectorXd& residual,
                                         const GridOptions& options = {});

/// pi_k Z_k / sum, from ln Z_k and pi_k >= 0.
[[nodiscard]] VectorXd probabilities(const VectorXd& log_evidence, const VectorXd& prior);

}  // namespace cpt::diagnosis

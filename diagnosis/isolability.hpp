// Which mechanisms this recording, or another measurement, could tell apart.
//
//   D_ij = min over phi_j of |M^-1/2 (Delta_i - Delta_j(phi_j))|
//
// in standard deviations: the best imitation of i by j, the soil parameters free to help (they are in M). Two
// with D below 2 to 3 are one answer, whatever their probabilities.
#pragma once

#include "diagnosis/curve_emulator.hpp"
#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {

/// What can be measured and how each mechanism of the catalogue would show in it, all in the same order: the
/// push at hand, another sounding, another stress, f_s, ...
struct Observation {
  std::string name;
  MatrixXd covariance;                    // M of this observation
  std::vector<CurveEmulator> mechanisms;  // the same parameters phi as in the others
};

/// An imitation of one mechanism by another.
struct Imitation {
  double distance;  // [-] D_ij
  VectorXd phi;     // of the imitating mechanism
};

/// D between mechanism i at phi_i and mechanism j over several observations at once (errors independent
/// between them; squares add up). Best of a grid, then a compass search to 1e-4 of the cube.
[[nodiscard]] Imitation imitate(const std::vector<const Observation*>& observations, std::size_t i,
                                const VectorXd& phi_i, std::size_t j);

/// D_i0: how strong mechanism i at phi_i stands out of the null [standard deviations].
[[nodiscard]] double strength(const std::vector<const Observation*>& observations, std::size_t i,
                              const VectorXd& phi_i);

/// Of all k mechanisms at their own phi [standard deviations].
struct Isolability {
  MatrixXd between;   // k x k, D_ij; row i is the truth, column j the imitator
  VectorXd strength;  // k, D_i0
};

[[nodiscard]] Isolability isolability(const Observation& observation, const std::vector<VectorXd>& phi);

/// The next measurement that tells a set of mechanisms apart best.
struct NextMeasurement {
  std::string name;
  double least_distance;  ///< between any two of the set, with what was measured already
};

/// Candidates by their least D_ij over i != j of the `set`, together with the present observation, the best
/// first. `phi` as above.
[[nodiscard]] std::vector<NextMeasurement> next_measurements(const Observation& present,
                                                             const std::vector<Observation>& candidates,
                                                             const std::vector<std::size_t>& set,
                                                             const std::vector<VectorXd>& phi);

}  // namespace cpt::diagnosis

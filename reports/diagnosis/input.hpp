// What the report of a diagnosis is made from: the diagnosis, and what people need to read it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/diagnose.hpp"
#include "solver/mechanisms/mechanism.hpp"

namespace cpt::reports::diagnosed {

using diagnosis::Explanation;
using diagnosis::Index;
using diagnosis::MatrixXd;
using diagnosis::VectorXd;

/// q_c over depth, as fine as it was recorded or simulated.
struct Curve {
  std::vector<double> depth;  // [m] not falling
  std::vector<double> q_c;    // [Pa] NaN where there is none
};

/// A sounding. The recalibrated null and the mechanism's emulated curve are the diagnosis's own, in cells.
struct Sounding {
  std::string name;
  Curve recorded;
  Curve baseline;               ///< the simulation, before anything was fitted
  std::optional<Curve> solver;  ///< the fitted mechanism and parameters, run in the full solver
};

/// A parameter of the study, which the null may move between its bounds.
struct StudyParameter {
  const solver::Quantity* quantity;
  double baseline, lower, upper;  // [study units]

  [[nodiscard]] bool is_choice() const { return !quantity->choices.empty(); }
};

/// Where the noise model comes from.
struct NoiseFacts {
  bool measurement_given = false;  ///< else from the recording's high-pass part
  int repeats = 0;                 ///< of the baseline
  double numerical_shares = 1.0;   ///< of the repeats' covariance
  int joint_runs = 0;              ///< behind the response surface's products and error
};

struct SourceFile {
  std::string what, path, sha256;  ///< "recording", ...; the hash may be empty
};

struct Provenance {
  std::string program_version, solver_version;
  std::vector<std::uint64_t> seeds;
  std::vector<SourceFile> files;
  int solver_runs = 0;
  double wall_s = 0.0;  // [s] of everything
};

struct DiagnosisInput {
  std::string name;   ///< of the files: NAME-diagnosis.md
  std::string title;  ///< of the page
  std::vector<Sounding> soundings;
  std::vector<StudyParameter> parameters;  ///< in the order of the problem's
  /// In the order of the problem's. Their parameters are those that are varied, in the order of phi.
  std::vector<solver::Mechanism> mechanisms;
  diagnosis::Options options;  ///< that the diagnosis was made with
  diagnosis::Diagnosis diagnosis;
  VectorXd recorded, baseline;  // [ln q_c] of the problem, on the diagnosis's cells
  NoiseFacts noise;
  Provenance provenance;
};

/// Throws std::invalid_argument, with what is wrong, if the parts do not belong together.
void check(const DiagnosisInput& input);

/// The mechanism's title, "nothing is missing" or "none of these".
[[nodiscard]] std::string title_of(const DiagnosisInput& input, Explanation explanation);
/// The same by its name; the name itself if it is unknown.
[[nodiscard]] std::string title_of(const DiagnosisInput& input, const std::string& name);

/// Place in [0, 1] of the baseline between a study parameter's bounds.
[[nodiscard]] double baseline_place(const StudyParameter& parameter);
/// A place between the bounds in study units; a whole number is not rounded.
[[nodiscard]] double study_value(const StudyParameter& parameter, double place);
/// The same for people, without the unit; of a choice the name of the nearer end.
[[nodiscard]] std::string value_text(const StudyParameter& parameter, double place);

/// Mechanisms that the recording does not tell from the best one: the rest of the answer's set, the most
/// probable first, at most as many as the figures have colours for.
[[nodiscard]] std::vector<std::size_t> rivals(const DiagnosisInput& input);

}  // namespace cpt::reports::diagnosed

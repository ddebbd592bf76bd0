// What a concealed case holds: drawn blind, sealed, opened only when the answer is written.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "diagnosis/design.hpp"
#include "solver/simulate.hpp"
#include "validation/concealed/outside_effect.hpp"
#include "validation/concealed/plan.hpp"

namespace cpt::validation::concealed {

/// A mechanism at a place in its prior.
struct Part {
  solver::Mechanism mechanism;
  diagnosis::VectorXd place;  ///< of its varied parameters, in the unit cube
};

/// What differs between the truth's run and the analysis beside the physics, for one sounding.
struct Numerics {
  double point_shift;  // [-]
  double courant;      // [-] over the study's
  double near_height;  // [-] over the study's
  std::uint64_t noise_seed;
};

struct Truth {
  int id;  ///< of the case, from 1
  std::vector<Part> parts;
  std::optional<OutsideEffect> outside;
  diagnosis::VectorXd soil;         ///< places of the study's rows between their bounds; an end for choices
  std::vector<Numerics> soundings;  ///< one for each that the case has
  [[nodiscard]] std::string kind() const;  ///< "nothing", "single", "pair" or "outside"
};

/// The cases of a plan in random order. Mechanisms and outside effects come equally often, their parameters
/// uniform in their priors, the soil's uniform between the bounds; material points, mesh and Courant number
/// lie outside what the analysis uses. Impossible combinations are drawn again. The same seed gives the same.
[[nodiscard]] std::vector<Truth> draw_truths(const Plan& plan, const parameters::Study& study,
                                             std::uint64_t seed);

/// Name of the case: "case-007".
[[nodiscard]] std::string case_name(int id);

/// The study that makes the recordings of one sounding: the baseline with what is known, and a point for each
/// case that has this sounding. Its database is in the sealed folder.
[[nodiscard]] parameters::Study truth_study(const Plan& plan, const parameters::Study& study,
                                            const std::vector<Truth>& truths, std::size_t sounding);

/// The recording as text: "depth_m,q_c_MPa,f_s_kPa" and a line each millimetre, the run's channels with the
/// outside effect on q_c and noise of the plan's size, f_s as much noisier as the list of channels says, and
/// correlation length (AR(1)).
[[nodiscard]] std::string recording_text(const Plan& plan, const Truth& truth, std::size_t sounding,
                                         const solver::DepthProfile& profile);

/// The request of a case, to stand in the cases folder beside its recordings.
[[nodiscard]] std::string request_text(const Plan& plan, const parameters::Study& study, const Truth& truth);
/// File names of request and recordings in the cases folder.
[[nodiscard]] std::string request_file(int id);
[[nodiscard]] std::string recording_file(int id, std::size_t sounding);

[[nodiscard]] nlohmann::json to_json(const Truth& truth);
/// Throws std::invalid_argument for what is not a truth of the plan.
[[nodiscard]] Truth truth_from_json(const nlohmann::json& json, const Plan& plan);

/// SHA-256 of salt and truth: tells nothing without the salt, and fits no other truth.
[[nodiscard]] std::string seal_of(const std::string& salt, const Truth& truth);

}  // namespace cpt::validation::concealed

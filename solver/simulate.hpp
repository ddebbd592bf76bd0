// One realization: options in, summary out.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "solver/channels.hpp"
#include "solver/push_state.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

class MaterialPoints;

/// How a realization ended. The solver itself never returns `crashed` or `rank_lost`: the campaign does.
enum class Status {
  completed,
  did_not_converge,
  energy_drift,
  time_limit,
  invalid_parameters,
  crashed,
  rank_lost
};
[[nodiscard]] std::string_view to_string(Status status);

/// What the run conserved and how it behaved (solver/audit.hpp says how each is computed).
struct Audit {
  double mass_error = 0.0;         // [-] relative change of the total mass of the material points
  double momentum_error = 0.0;     // [-] vertical impulse balance, relative to the penetrometer's impulse
  double energy_error = 0.0;       // [-] energy balance, relative to the penetrometer's work
  double kinetic_fraction = 0.0;   // [-] largest kinetic energy over the penetrometer's work, after the start
  int max_empty_cells = 0;         // [-]
  double limited_share = 0.0;      // [-] cells of several soils that could not share their motion in one step
  double safeguarded_share = 0.0;  // [-] largest share of the points whose state a safeguard of the law held
  double min_time_step = 0.0;      // [s]
  double max_time_step = 0.0;      // [s]
};

struct Outcome {
  Status status = Status::invalid_parameters;
  std::string reason;    ///< one sentence; empty if completed
  DepthProfile profile;  ///< as far as the push came
  Audit audit;
  std::int64_t steps = 0;
  std::int64_t material_points = 0;
  double wall_seconds = 0.0;  ///< the only field, with those derived from it, that differs between equal runs
};

/// Where a running realization is.
struct Progress {
  double depth;        // [m] tip
  double final_depth;  // [m]
  std::int64_t steps;
  std::int64_t material_points;
  double wall_seconds;
};

/// Callbacks of a run; the base does nothing.
class Observer {
 public:
  virtual ~Observer() = default;
  /// After the first few steps, then about ten times a second.
  virtual void progress(const Progress&) {}
  /// Polled as often as `progress`; true ends the run with Status::time_limit and this reason.
  virtual bool stop_requested(std::string& /*reason*/) { return false; }

  /// Polled after `stop_requested`; true asks for the state of the push as it is now, a few megabytes.
  virtual bool state_wanted() { return false; }
  /// The state that was asked for, as Execution::resume takes it.
  virtual void keep_state(PushState /*state*/) {}

  /// Depth of the tip [m] from which the observer wants to look at the material points; asked at the start
  /// and after each look. Infinity: never again.
  [[nodiscard]] virtual double next_look() const { return std::numeric_limits<double>::infinity(); }
  /// A look at the material points (solver/point_states.hpp), after the first step that brings the tip to
  /// the wanted depth; before the first step if it is there already.
  virtual void look(double /*depth*/, const MaterialPoints&) {}
};

/// How to run, none of which changes a bit of the result.
struct Execution {
  int threads = 1;
  double wall_limit_seconds = std::numeric_limits<double>::infinity();  ///< of the push, pauses left out
  const PushState* resume = nullptr;  ///< an earlier state of the same setup's push to go on from
};

/// Pushes the cone to its final depth. Never throws for physics: bad input, divergence and limits are
/// outcomes. Throws StateMismatch if the state to go on from is not one of this setup's, std::bad_alloc if
/// memory runs out.
[[nodiscard]] Outcome simulate(const Setup& setup, Observer& observer, const Execution& execution = {});

/// Version of the numerics; changes whenever the same setup may give other bits.
[[nodiscard]] std::string_view solver_version();

}  // namespace cpt::solver

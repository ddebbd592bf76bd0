// Conservation audit of a run, and the guard against states that no longer mean anything.
#pragma once

#include <string>

#include "solver/model.hpp"
#include "solver/penetrometer.hpp"
#include "solver/simulate.hpp"

namespace cpt::solver {

/// Adds up impulses and work over the steps.
///
/// Momentum: change of the points' vertical momentum against the impulses of weight, bottom and penetrometer.
/// Not exact, because nodal inertia follows the Gauss points and nodal velocity the material points. Energy:
/// work of the penetrometer and of the weight against internal work of the points, kinetic energy and
/// sliding.
class Auditor {
 public:
  /// The cone's first impact, up to `start` [m] of travel, is left out of the kinetic energy.
  Auditor(const Model& model, double start);

  /// After each step. `bottom_impulse` [N s/rad] from ChamberBoundary::fix_boundaries.
  void add_step(const PenetrometerLoad& load, double bottom_impulse, double speed, double dt);

  /// Every some steps: empty if all is well, else what is wrong; fills `status`.
  [[nodiscard]] std::string check(const Model& model, double travel, Status& status);

  [[nodiscard]] Audit summary(const Model& model) const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive("audit.impulse", impulse_);
    archive("audit.penetrometer_impulse", penetrometer_impulse_);
    archive("audit.penetrometer_work", penetrometer_work_);
    archive("audit.sliding", sliding_);
    archive("audit.kinetic", kinetic_);
    archive("audit.kinetic_fraction", audit_.kinetic_fraction);
    archive("audit.max_empty_cells", audit_.max_empty_cells);
    archive("audit.safeguarded_share", audit_.safeguarded_share);
    archive("audit.checks", checks_);
    archive("audit.min_time_step", audit_.min_time_step);
    archive("audit.max_time_step", audit_.max_time_step);
  }

 private:
  Audit audit_;
  double start_;                                       // [m]
  double initial_mass_, initial_momentum_;             // over the full circumference
  double initial_weight_energy_;                       // [J] potential energy of the effective weight
  double weight_;                                      // [N] effective
  double impulse_ = 0.0, penetrometer_impulse_ = 0.0;  // [N s]
  double penetrometer_work_ = 0.0, sliding_ = 0.0;     // [J]
  double kinetic_ = 0.0;                               // [J] at the last check
  std::int64_t checks_ = 0;
};

}  // namespace cpt::solver

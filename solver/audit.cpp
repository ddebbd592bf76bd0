#include "solver/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cpt::solver {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr int checks_between_counts = 10;  // every point is evaluated

struct Totals {
  double mass = 0.0, momentum = 0.0, kinetic = 0.0, weight_energy = 0.0, weight = 0.0;
};

// Sums over the material points, over the full circumference; inertia includes the mass scaling.
Totals totals(const Model& model) {
  Totals t;
  const MaterialPoints& points = model.points();
  const ModelSettings& s = model.settings();
  for (std::int32_t b = 0; b < points.bucket_count(); ++b) {
    const Bucket& bucket = points.bucket(b);
    const PointFields p = points.fields(bucket);
    const double g = s.gravity * s.weight_ratio[b % s.materials];
    for (std::int32_t k = 0; k < bucket.count; ++k) {
      const double m = two_pi * p.mass[k];
      t.mass += m;
      t.momentum += m * s.mass_scaling * p.v_z[k];
      t.kinetic += 0.5 * m * s.mass_scaling * (p.v_r[k] * p.v_r[k] + p.v_z[k] * p.v_z[k]);
      t.weight += m * g;
      t.weight_energy += m * g * p.z[k];
    }
  }
  return t;
}

}  // namespace

Auditor::Auditor(const Model& model, double start) : start_(start) {
  const Totals t = totals(model);
  initial_mass_ = t.mass;
  initial_momentum_ = t.momentum;
  initial_weight_energy_ = t.weight_energy;
  weight_ = t.weight;
  audit_.min_time_step = INFINITY;
}

void Auditor::add_step(const PenetrometerLoad& load, double bottom_impulse, double speed, double dt) {
  const double upward = load.cone_force + load.shaft_force;
  impulse_ += two_pi * bottom_impulse - (weight_ + upward) * dt;
  penetrometer_impulse_ += upward * dt;
  penetrometer_work_ += upward * speed * dt;
  sliding_ += load.dissipation;
  audit_.min_time_step = std::min(audit_.min_time_step, dt);
  audit_.max_time_step = std::max(audit_.max_time_step, dt);
}

std::string Auditor::check(const Model& model, double travel, Status& status) {
  const Totals t = totals(model);
  kinetic_ = t.kinetic;
  const int empty = model.empty_cells();
  audit_.max_empty_cells = std::max(audit_.max_empty_cells, empty);
  if (checks_++ % checks_between_counts == 0)
    audit_.safeguarded_share = std::max(audit_.safeguarded_share, model.safeguarded_share());
  status = Status::did_not_converge;
  if (!std::isfinite(t.kinetic) || !std::isfinite(t.weight_energy))
    return fmt::format("a velocity or position became non-finite after {:.1f} mm of travel", travel * 1e3);
  if (std::abs(t.mass - initial_mass_) > 1e-9 * initial_mass_)
    return fmt::format("mass changed by {:.3g} of the total", (t.mass - initial_mass_) / initial_mass_);
  const auto cells = static_cast<double>(model.mesh().cells().size());
  if (empty > 0.02 * cells) return fmt::format("{} of {} cells lost all their material points", empty, cells);
  // Skip the start, where the cone's first impact is most of the energy there is.
  if (travel > start_ && penetrometer_work_ > 0.0) {
    const double fraction = t.kinetic / penetrometer_work_;
    audit_.kinetic_fraction = std::max(audit_.kinetic_fraction, fraction);
    status = Status::energy_drift;
    if (fraction > 0.5)
      return fmt::format("kinetic energy reached {:.2f} of the penetrometer's work after {:.1f} mm", fraction,
                         travel * 1e3);
  }
  status = Status::completed;
  return {};
}

Audit Auditor::summary(const Model& model) const {
  Audit audit = audit_;
  const Totals t = totals(model);
  audit.limited_share = model.limited_share();
  audit.mass_error = std::abs(t.mass - initial_mass_) / initial_mass_;
  if (penetrometer_impulse_ > 0.0)
    audit.momentum_error = std::abs(t.momentum - initial_momentum_ - impulse_) / penetrometer_impulse_;
  if (penetrometer_work_ > 0.0) {
    const double stored = t.kinetic + two_pi * model.internal_work() + sliding_;
    const double weight = initial_weight_energy_ - t.weight_energy;
    audit.energy_error = (penetrometer_work_ + weight - stored) / penetrometer_work_;
  }
  return audit;
}

}  // namespace cpt::solver

#include "solver/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <new>

#include "solver/actual_setup.hpp"
#include "solver/audit.hpp"
#include "solver/chamber.hpp"
#include "solver/first_push.hpp"
#include "solver/initial_state.hpp"
#include "solver/mechanisms/reading.hpp"
#include "solver/model.hpp"
#include "solver/penetrometer.hpp"
#include "solver/push_watch.hpp"
#include "solver/quantities.hpp"
#include "solver/recorder.hpp"
#include "solver/soils/elastic.hpp"

namespace cpt::solver {
namespace {

constexpr int steps_between_checks = 100;
constexpr double farthest_in_a_step = 0.1;  // [-] travel over the height of a cell at the tip

SoilModels make_soils(const Setup& setup) {
  SoilModels soils;
  for (std::size_t k = 0; k < setup.soils.size(); ++k) {
    const Soil& soil = setup.soils[k];
    soils.push_back(contains(setup, k) ? law_of(soil).model(soil.parameters, setup.mechanisms) : nullptr);
  }
  soils.push_back(elastic_soil(setup.chamber.surcharge_E, setup.chamber.surcharge_nu));
  return soils;
}

ModelSettings make_settings(const Setup& setup, int threads) {
  ModelSettings s;
  const Numerics& numerics = setup.numerics;
  s.courant = numerics.courant;
  s.mass_scaling = numerics.mass_scaling;
  s.longest_step = farthest_in_a_step * numerics.near_height / setup.penetrometer.speed;
  s.most_level = numerics.step_levels;
  s.pic_fraction = numerics.pic_fraction;
  s.local_damping = numerics.local_damping;
  s.bulk_viscosity = numerics.bulk_viscosity;
  const std::size_t surcharge = setup.soils.size();
  for (std::size_t k = 0; k < surcharge; ++k) {
    const bool as_sand = law_of(setup.soils[k]).treated_as() == TreatedAs::sand;
    s.stress_smoothing[k] = as_sand ? numerics.stress_smoothing_sand : numerics.stress_smoothing_clay;
    s.weight_ratio[k] = bulk(setup, k).weight_ratio;
  }
  s.stress_smoothing[surcharge] = numerics.stress_smoothing_clay;
  s.materials = static_cast<std::int32_t>(surcharge + 1);
  s.gravity = gravity;
  s.partial_cells = setup.chamber.surcharge == SurchargeKind::traction;
  s.threads = threads;
  return s;
}

Model make_model(const Setup& setup, const LeftBehind& left, int threads) {
  SoilModels soils = make_soils(setup);
  const InitialState start = initial_state(setup, soils, left);
  Model model(Mesh(chamber_layout(setup)), start.points, start.material, std::move(soils),
              make_settings(setup, threads));
  if (setup.mechanisms.compliant_wall.on())  // its spring may be stiffer than the soil
    for (const std::int32_t n : model.mesh().wall_nodes()) model.follow_every_step(n);
  return model;
}

Outcome invalid(const std::vector<Problem>& found) {
  Outcome outcome;
  outcome.status = Status::invalid_parameters;
  for (const Problem& problem : found) {
    if (!outcome.reason.empty()) outcome.reason += "; ";
    outcome.reason += problem.quantity + ": " + problem.message;
  }
  return outcome;
}

// [m/s] of the penetrometer at a time after the start [s]; a sudden start would ring through the chamber.
double speed_at(const Setup& setup, double time) {
  const double speed = setup.penetrometer.speed;
  const double rise = 2.0 * setup.numerics.start_distance / speed;
  if (time >= rise) return speed;
  const double x = time / rise;
  return speed * x * x * (3.0 - 2.0 * x);
}

// What came before a push.
struct Before {
  int pushes = 0;
  double wall_seconds = 0.0;
  LeftBehind left;

  template <class Archive>
  void exchange(Archive& archive) {
    archive("before.pushes", pushes);
    archive("before.wall_seconds", wall_seconds);
    archive("before.sigma_v_ratio", left.sigma_v_ratio);
    if constexpr (Archive::reading) {
      left.sigma_h_ratio = archive.find("before.sigma_h_ratio");
      left.void_ratio_change = archive.find("before.void_ratio_change");
    } else {
      archive("before.sigma_h_ratio", left.sigma_h_ratio);
      archive("before.void_ratio_change", left.void_ratio_change);
    }
  }
};

// One push into the soil of `setup` as those before it changed it; q_c is the force over `nominal_area` [m2].
// Goes on from execution.resume, if there is one.
Outcome push(const Setup& setup, Before before, double nominal_area, Observer& observer,
             const Execution& execution) {
  PushWatch watch(observer, execution, setup.penetrometer.final_depth, before.wall_seconds);
  Model model = make_model(setup, before.left, execution.threads);
  ChamberBoundary chamber(setup, model.mesh(), before.left);
  PenetrometerContact penetrometer(setup);
  Recorder recorder(setup.numerics.bin_height, setup.penetrometer.final_depth, nominal_area);
  // 20 mm of a cone of 25.3 mm, as much further as a cone is larger
  Auditor auditor(model, 0.02 * (setup.penetrometer.diameter / Numerics{}.for_diameter));

  Outcome outcome;
  outcome.status = Status::completed;
  outcome.material_points = model.points().size();
  const double final_depth = setup.penetrometer.final_depth;
  const double first_depth = model.mesh().tip_depth();
  double depth = first_depth, time = 0.0, first_step = 0.0;
  std::int64_t next_check = steps_between_checks;
  const auto exchange = [&](auto& archive) {
    before.exchange(archive);
    model.exchange(archive);
    chamber.exchange(archive);
    recorder.exchange(archive);
    auditor.exchange(archive);
    archive("push.depth", depth);
    archive("push.time", time);
    archive("push.steps", outcome.steps);
    archive("push.first_step", first_step);
    archive("push.next_check", next_check);
  };
  const std::function<PushState()> state = [&] {
    StateWriter writer;
    exchange(writer);
    writer("push.wall_seconds", watch.wall_seconds());
    return writer.take();
  };
  if (execution.resume != nullptr) {
    StateReader reader(*execution.resume);
    exchange(reader);
    double seconds = 0.0;
    reader("push.wall_seconds", seconds);
    watch.go_on_from(seconds);
  }

  double next_look = observer.next_look();
  const auto look = [&] {
    observer.look(depth, model.points());
    next_look = observer.next_look();
  };
  if (depth >= next_look) look();

  // What looks at the points or ends the push waits until all cells meet.
  const auto all_meet = [&model] { return model.levels().all_meet(); };
  while (!all_meet() || (depth < final_depth && outcome.status == Status::completed)) {
    model.compute_nodal_forces();
    chamber.apply_wall_stress(model);
    const double dt = model.stable_time_step();
    if (outcome.steps == 0) first_step = dt;
    if (!(dt > 1e-3 * first_step)) {
      outcome.status = Status::did_not_converge;
      outcome.reason =
          fmt::format("the stable time step fell to {:.3g} s at {:.1f} mm depth", dt, depth * 1e3);
      break;
    }
    time += dt;
    const double speed = speed_at(setup, time);
    model.accelerate(dt);
    const double bottom_impulse = chamber.fix_boundaries(model, dt);
    const PenetrometerLoad load = penetrometer.apply_contact(model, speed, dt);
    model.mesh().move_tip_to(depth + speed * dt);
    model.move_points(dt);

    recorder.add(depth + 0.5 * speed * dt, {load, chamber.wall_stress(model.mesh(), depth)}, dt);
    auditor.add_step(load, bottom_impulse, speed, dt);
    depth += speed * dt;
    ++outcome.steps;
    if (!all_meet()) continue;
    if (depth >= next_look) look();

    if (outcome.steps >= next_check) {
      next_check = outcome.steps + steps_between_checks;
      outcome.reason = auditor.check(model, depth - first_depth, outcome.status);
    }
    watch.after_step(depth, outcome, state);
  }

  outcome.profile = as_recorded(recorder.profile(), setup);
  outcome.audit = auditor.summary(model);
  for (const double q_c : outcome.profile.q_c)
    if (!std::isfinite(q_c) && outcome.status == Status::completed) {
      outcome.status = Status::did_not_converge;
      outcome.reason = "the tip resistance became non-finite";
    }
  outcome.wall_seconds = watch.wall_seconds();
  return outcome;
}

}  // namespace

std::string_view to_string(Status status) {
  switch (status) {
    case Status::completed:
      return "completed";
    case Status::did_not_converge:
      return "did_not_converge";
    case Status::energy_drift:
      return "energy_drift";
    case Status::time_limit:
      return "time_limit";
    case Status::invalid_parameters:
      return "invalid_parameters";
    case Status::crashed:
      return "crashed";
    case Status::rank_lost:
      return "rank_lost";
  }
  return "unknown";
}

std::string_view solver_version() { return "0.7"; }

Outcome simulate(const Setup& setup, Observer& observer, const Execution& execution) {
  std::vector<Problem> found = problems(setup);
  if (!found.empty()) return invalid(found);
  Setup actual = actual_setup(setup);
  found = problems(actual);
  if (!found.empty()) return invalid(found);
  const double nominal_area = PenetrometerContact(setup).projected_area();
  try {
    Before before;
    Execution rest = execution;
    if (execution.resume != nullptr) {
      StateReader reader(*execution.resume);
      before.exchange(reader);
    }
    if (actual.mechanisms.previous_push.on()) {
      if (before.pushes == 0) {
        FirstPush first(actual, observer);
        const Outcome outcome = push(first.setup(), before, nominal_area, first, execution);
        if (outcome.status != Status::completed) return outcome;
        before = {1, outcome.wall_seconds, first.left_behind()};
        rest.resume = nullptr;
      }
      actual.initial.sigma_v0 *= before.left.sigma_v_ratio;
      actual.initial.sigma_h0 *= before.left.sigma_v_ratio;
    }
    return push(actual, before, nominal_area, observer, rest);
  } catch (const StateMismatch&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    Outcome outcome;
    outcome.status = Status::did_not_converge;
    outcome.reason = error.what();
    return outcome;
  }
}

}  // namespace cpt::solver

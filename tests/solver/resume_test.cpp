// A push that goes on from a stored state ends with the same bits as one that was never stopped.
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "solver/presets.hpp"
#include "solver/simulate.hpp"

namespace cpt::solver {
namespace {

// Keeps every state it can get: one at the start and one a millimetre, on however fast a machine, since it
// lingers there for longer than the solver lets pass between two polls.
struct Keeper : Observer {
  std::vector<PushState> states;
  double next = 0.0;  // [m]
  bool state_wanted() override { return true; }
  void keep_state(PushState state) override { states.push_back(std::move(state)); }
  [[nodiscard]] double next_look() const override { return next; }
  void look(double depth, const MaterialPoints&) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(110));
    next = depth + 0.001;
  }
};

// Keeps the state of its first poll and ends the run there.
struct Stopper : Keeper {
  bool stop_requested(std::string&) override { return true; }
};

struct Case {
  const char* name;
  Setup (*setup)();
};

Setup shallow(Profile profile) {
  Setup setup = make_setup(profile, Preset::quick);
  setup.penetrometer.final_depth = 0.03;
  return setup;
}

Setup thin_layers() {
  Setup setup = shallow(Profile::layered_sand_clay);
  setup.layers = {{0.0, 0.03, default_sand}, {0.03, 0.06, default_clay}, {0.06, 1.0, default_sand}};
  return setup;
}

const Case cases[] = {
    {"sand", [] { return shallow(Profile::homogeneous_sand); }},
    {"clay", [] { return shallow(Profile::homogeneous_clay); }},
    {"layers", thin_layers},
    {"traction_on_flexible_wall",
     [] {
       Setup setup = shallow(Profile::homogeneous_clay);
       setup.chamber.wall = Wall::flexible;
       setup.chamber.surcharge = SurchargeKind::traction;
       return setup;
     }},
    {"sand_with_mechanisms",
     [] {
       Setup setup = shallow(Profile::homogeneous_sand);
       setup.mechanisms.compliant_wall.compliance = 3e-8;
       setup.mechanisms.wall_friction.coefficient = 0.3;
       setup.mechanisms.grain_crushing.slope = 0.2;
       setup.mechanisms.surface_compaction.increase = 0.2;
       return setup;
     }},
    {"clay_with_mechanisms",
     [] {
       Setup setup = shallow(Profile::homogeneous_clay);
       setup.mechanisms.strain_softening.loss = 0.5;
       setup.mechanisms.rate_dependence.mu = 0.1;
       setup.mechanisms.clay_crust.increase = 0.5;
       setup.numerics.bulk_viscosity = 0.1;
       return setup;
     }},
    {"second_push",
     [] {
       Setup setup = shallow(Profile::homogeneous_sand);
       setup.penetrometer.final_depth = 0.026;
       setup.mechanisms.previous_push.share = 1.0;
       return setup;
     }},
};

void expect_same_bits(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(a.status, b.status) << b.reason;
  EXPECT_EQ(a.profile.depth, b.profile.depth);
  EXPECT_EQ(a.profile.q_c, b.profile.q_c);
  EXPECT_EQ(a.profile.f_s, b.profile.f_s);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.material_points, b.material_points);
  EXPECT_EQ(a.audit.mass_error, b.audit.mass_error);
  EXPECT_EQ(a.audit.momentum_error, b.audit.momentum_error);
  EXPECT_EQ(a.audit.energy_error, b.audit.energy_error);
  EXPECT_EQ(a.audit.kinetic_fraction, b.audit.kinetic_fraction);
  EXPECT_EQ(a.audit.max_empty_cells, b.audit.max_empty_cells);
  EXPECT_EQ(a.audit.min_time_step, b.audit.min_time_step);
  EXPECT_EQ(a.audit.max_time_step, b.audit.max_time_step);
}

class Resumed : public testing::TestWithParam<Case> {};

TEST_P(Resumed, EndsWithTheSameBitsOnAnyNumberOfThreads) {
  const solver::Setup setup = GetParam().setup();
  Keeper keeper;
  const Outcome whole = simulate(setup, keeper);
  ASSERT_EQ(whole.status, Status::completed) << whole.reason;
  ASSERT_GE(keeper.states.size(), 2U);
  Observer observer;
  int threads = 0;
  for (const std::size_t k : {std::size_t{0}, keeper.states.size() / 2, keeper.states.size() - 1}) {
    SCOPED_TRACE("state " + std::to_string(k) + " of " + std::to_string(keeper.states.size()));
    expect_same_bits(whole, simulate(setup, observer, {.threads = ++threads, .resume = &keeper.states[k]}));
  }
}

TEST_P(Resumed, EndsWithTheSameBitsHoweverOftenItIsStopped) {
  const solver::Setup setup = GetParam().setup();
  Observer observer;
  const Outcome whole = simulate(setup, observer);
  PushState state;
  double last_depth = 0.0, last_seconds = 0.0;
  for (int stop = 0; stop < 4; ++stop) {
    Stopper stopper;
    const Outcome part =
        simulate(setup, stopper, {.threads = 1 + stop % 2, .resume = stop > 0 ? &state : nullptr});
    if (part.status == Status::completed) break;
    ASSERT_EQ(part.status, Status::time_limit);
    ASSERT_EQ(stopper.states.size(), 1U);
    state = std::move(stopper.states.front());
    // Each part goes on where the last one ended, and wall time adds up.
    EXPECT_TRUE(state.at("push.depth").front() > last_depth || state.at("before.pushes").front() > 0);
    EXPECT_GT(part.wall_seconds, last_seconds);
    last_depth = state.at("push.depth").front();
    last_seconds = part.wall_seconds;
  }
  ASSERT_FALSE(state.empty());
  expect_same_bits(whole, simulate(setup, observer, {.resume = &state}));
}

INSTANTIATE_TEST_SUITE_P(Pushes, Resumed, testing::ValuesIn(cases),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(Resume, TakesNoStateThatDoesNotFit) {
  const solver::Setup sand = shallow(Profile::homogeneous_sand);
  Stopper stopper;
  static_cast<void>(simulate(sand, stopper));
  ASSERT_EQ(stopper.states.size(), 1U);
  const PushState good = stopper.states.front();
  const auto refused = [](const solver::Setup& setup, const PushState& state) {
    Observer observer;
    EXPECT_THROW(static_cast<void>(simulate(setup, observer, {.resume = &state})), StateMismatch);
  };
  for (const auto& [name, values] : good) {
    SCOPED_TRACE(name);
    PushState without = good;
    without.erase(name);
    refused(sand, without);
    if (name.starts_with("before.")) continue;  // of any length
    PushState longer = good;
    longer[name].push_back(0.0);
    refused(sand, longer);
  }
  PushState broken = good;
  broken["points.counts"].front() += 1.0;
  refused(sand, broken);
  solver::Setup finer = sand;
  finer.numerics.near_height *= 0.8;
  refused(finer, good);
}

}  // namespace
}  // namespace cpt::solver

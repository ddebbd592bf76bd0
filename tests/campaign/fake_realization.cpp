// Stands in for the solver in tests of the campaign: a smooth curve made from all inputs, in a fraction of a
// second, or one of the ways in which a realization can go wrong.
//
// CPT_FAKE holds rules "QUANTITY=VALUE:BEHAVIOUR", separated by ';': the behaviour of realizations whose
// input has that value; "*:BEHAVIOUR" means all. CPT_FAKE_SECONDS is how long one takes (0.05),
// CPT_TEST_HASTE how many times shorter that is made (1). CPT_FAKE_LOG names a file to which each start
// appends "process-id settings-hash".
#include <fcntl.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "campaign/descriptors.hpp"
#include "campaign/messages.hpp"
#include "campaign/realization_child.hpp"
#include "results/ledger/provenance.hpp"
#include "solver/quantities.hpp"
#include "tests/solver/default_soils.hpp"

namespace {

using namespace cpt;
using Clock = std::chrono::steady_clock;

constexpr std::int64_t all_steps = 1000;
constexpr std::int64_t material_points = 500;

std::string environment(const char* name, const char* otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

std::string behaviour_of(const solver::Setup& setup) {
  std::istringstream rules(environment("CPT_FAKE", ""));
  for (std::string rule; std::getline(rules, rule, ';');) {
    const auto colon = rule.rfind(':');
    const std::string condition = rule.substr(0, colon);
    if (condition == "*") return rule.substr(colon + 1);
    const auto equals = condition.find('=');
    const solver::Quantity* quantity = solver::find_quantity(condition.substr(0, equals));
    if (quantity == nullptr) throw std::invalid_argument("CPT_FAKE: unknown quantity in " + rule);
    if (quantity->format(quantity->value(setup)) == condition.substr(equals + 1))
      return rule.substr(colon + 1);
  }
  return "curve";
}

void log_start(const solver::Setup& setup) {
  const std::string file = environment("CPT_FAKE_LOG", "");
  if (file.empty()) return;
  const std::string line = std::to_string(::getpid()) + " " + results::settings_hash(setup) + "\n";
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (::write(descriptor, line.data(), line.size()) < 0) throw std::runtime_error("cannot write " + file);
  ::close(descriptor);
}

// A law with soil parameters, mechanisms and a little numerical noise, for tests of the diagnosis ("law").
solver::DepthProfile lawful_curve(const solver::Setup& setup) {
  const solver::Mechanisms& m = setup.mechanisms;
  const double noise = 0.004 * std::sin(1e3 * setup.numerics.point_shift + 40.0 * setup.numerics.courant);
  solver::DepthProfile profile;
  for (double depth = 0.02; depth < setup.penetrometer.final_depth; depth += 0.001) {
    const double y = 1.5 * (solver::sand_of(setup).D_r - 0.36) + 0.4 * (setup.contact.friction_ratio - 0.5) +
                     0.9 * m.surface_compaction.at(depth) + m.density_lens.at(depth) -
                     0.8 * m.wall_friction.coefficient * depth - m.cushion_transfer.loss +
                     noise * std::cos(60.0 * depth);
    profile.depth.push_back(depth);
    profile.q_c.push_back(4.0e6 * std::sqrt(depth) * std::exp(y));
    profile.f_s.push_back(1.0e4 * depth);
  }
  return profile;
}

solver::DepthProfile curve(const solver::Setup& setup) {
  double strength = 0.0;
  double weight = 1.0;
  for (const solver::Quantity& quantity : solver::all_quantities())
    strength += std::log1p(std::abs(quantity.value(setup))) * (weight += 0.37);
  solver::DepthProfile profile;
  for (double depth = 0.02; depth < setup.penetrometer.final_depth; depth += 0.002) {
    profile.depth.push_back(depth);
    profile.q_c.push_back(strength * 1.0e3 * std::sqrt(depth) * (1.0 + 0.01 * std::sin(300.0 * depth)));
    profile.f_s.push_back(strength * 10.0 * depth);
  }
  return profile;
}

void misbehave(const std::string& behaviour, solver::Observer& observer) {
  if (behaviour == "segfault") {
    ::signal(SIGSEGV, SIG_DFL);  // also under a sanitizer, which would catch it
    ::raise(SIGSEGV);
  }
  if (behaviour == "wait")
    for (std::string reason;
         ::access(environment("CPT_FAKE_GATE", "").c_str(), F_OK) != 0 && !observer.stop_requested(reason);)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  if (behaviour == "out_of_memory") ::raise(SIGKILL);
  if (behaviour == "throw") throw std::runtime_error("the fake throws");
  if (behaviour == "exit_3") std::_Exit(3);
  if (behaviour == "garbage") {
    const std::string garbage(200, 'x');
    static_cast<void>(::send(campaign::channel_descriptor, garbage.data(), garbage.size(), 0));
    ::pause();
  }
  if (behaviour == "half_message") {
    const campaign::Bytes bytes = campaign::frame(campaign::OutcomeReport{1, {}});
    static_cast<void>(::send(campaign::channel_descriptor, bytes.data(), bytes.size() / 2, 0));
    std::_Exit(0);
  }
  if (behaviour == "hang") {
    ::signal(SIGTERM, SIG_IGN);
    for (;;) ::pause();
  }
}

solver::Outcome fake(const solver::Setup& setup, solver::Observer& observer, const solver::Execution&) {
  log_start(setup);
  const std::string behaviour = behaviour_of(setup);
  const auto start = Clock::now();
  const double duration =
      std::stod(environment("CPT_FAKE_SECONDS", "0.05")) / std::stod(environment("CPT_TEST_HASTE", "1"));
  solver::Outcome outcome;
  outcome.material_points = material_points;
  for (double fraction = 0.0; fraction < 1.0;) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    fraction = std::min(elapsed / duration, 1.0);
    outcome.steps = static_cast<std::int64_t>(static_cast<double>(all_steps) * fraction);
    const double final_depth = setup.penetrometer.final_depth;
    observer.progress({fraction * final_depth, final_depth, outcome.steps, material_points, elapsed});
    misbehave(behaviour, observer);  // after the first report
    if (behaviour != "deaf" && observer.stop_requested(outcome.reason)) {
      outcome.status = solver::Status::time_limit;
      return outcome;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  outcome.status = solver::Status::completed;
  outcome.profile = behaviour == "law" ? lawful_curve(setup) : curve(setup);
  if (behaviour == "not_finite") outcome.profile.q_c.back() = std::numeric_limits<double>::quiet_NaN();
  if (behaviour == "one_bit") outcome.profile.q_c.at(2) = std::nextafter(outcome.profile.q_c.at(2), 0.0);
  if (behaviour == "energy_drift") {
    outcome.status = solver::Status::energy_drift;
    outcome.reason = "the fake drifts";
  }
  outcome.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (behaviour == "crash_at_exit") std::atexit([] { ::raise(SIGABRT); });
  return outcome;
}

}  // namespace

int main() { return cpt::campaign::serve_realization(fake); }

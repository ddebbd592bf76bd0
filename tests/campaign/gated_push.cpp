// The solver itself, held at a depth until it is told to go on, for tests that must find a push under way on
// however fast or busy a machine.
//
// CPT_GATE_DEPTH_m is the depth of the tip at which every push waits, CPT_GATE the file whose being there
// lets it go on; a push that is asked to end goes on too. CPT_GATE_LOG names a file to which each arrival at
// the gate appends the process's id. Without these it is the solver and nothing else.
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include "campaign/realization_child.hpp"
#include "solver/simulate.hpp"

namespace {

using namespace cpt;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

void log_arrival() {
  const std::string file = environment("CPT_GATE_LOG");
  if (file.empty()) return;
  const std::string line = std::to_string(::getpid()) + "\n";
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (::write(descriptor, line.data(), line.size()) < 0) throw std::runtime_error("cannot write " + file);
  ::close(descriptor);
}

// Passes everything on to the campaign's own observer.
class Gate final : public solver::Observer {
 public:
  explicit Gate(solver::Observer& inner) : inner_(inner) {
    const std::string depth = environment("CPT_GATE_DEPTH_m");
    if (!depth.empty()) depth_ = std::stod(depth);
  }

  void progress(const solver::Progress& progress) override { inner_.progress(progress); }
  bool stop_requested(std::string& reason) override { return inner_.stop_requested(reason); }
  bool state_wanted() override { return inner_.state_wanted(); }
  void keep_state(solver::PushState state) override { inner_.keep_state(std::move(state)); }

  [[nodiscard]] double next_look() const override { return depth_; }
  void look(double, const solver::MaterialPoints&) override {
    depth_ = std::numeric_limits<double>::infinity();
    log_arrival();
    std::string reason;
    while (::access(environment("CPT_GATE").c_str(), F_OK) != 0 && !inner_.stop_requested(reason))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    // For longer than the solver lets pass between two polls, so that it is asked before it has gone on far.
    std::this_thread::sleep_for(std::chrono::milliseconds(110));
  }

 private:
  solver::Observer& inner_;
  double depth_ = std::numeric_limits<double>::infinity();  // [m]
};

solver::Outcome gated(const solver::Setup& setup, solver::Observer& observer,
                      const solver::Execution& execution) {
  Gate gate(observer);
  return solver::simulate(setup, gate, execution);
}

}  // namespace

int main() { return cpt::campaign::serve_realization(gated); }

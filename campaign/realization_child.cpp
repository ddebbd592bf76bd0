#include "campaign/realization_child.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "campaign/clock.hpp"
#include "campaign/external/run_program.hpp"
#include "campaign/order_server.hpp"
#include "results/push/checkpoint.hpp"

namespace cpt::campaign {
namespace {

// Passes progress on a few times a second and keeps checkpoints.
class Reporter final : public solver::Observer {
 public:
  explicit Reporter(const Order& order)
      : order_(order), realization_(order.realization), last_kept_(monotonic_seconds()) {}

  /// What to say once the push goes on from a kept state, if that state is of use to it.
  void say_when_running(std::string remark) { remark_ = std::move(remark); }

  void progress(const solver::Progress& progress) override {
    if (!remark_.empty()) send_remark(realization_, std::exchange(remark_, {}));
    const double now = monotonic_seconds();
    if (now < next_) return;
    next_ = now + 0.25;
    send_progress({realization_, progress});
  }

  bool stop_requested(std::string& reason) override {
    if (!told_to_end()) return false;
    reason = "asked to end";
    return true;
  }

  bool state_wanted() override {
    if (order_.checkpoint.empty() || unwritable_) return false;
    return told_to_end() || monotonic_seconds() > last_kept_ + order_.checkpoint_seconds;
  }

  void keep_state(solver::PushState state) override {
    last_kept_ = monotonic_seconds();
    try {
      results::write_checkpoint(order_.checkpoint, order_.setup, state);
    } catch (const results::Error& problem) {
      unwritable_ = true;
      send_remark(realization_, fmt::format("no checkpoints: {}", problem.what()));
    }
  }

 private:
  const Order& order_;
  int realization_;
  std::string remark_;
  double next_ = 0.0;  // [s] when progress is due
  double last_kept_;   // [s]
  bool unwritable_ = false;
};

// The state to go on from, if there is a good one.
std::optional<solver::PushState> kept_state(const Order& order) {
  if (order.checkpoint.empty()) return std::nullopt;
  try {
    return results::read_checkpoint(order.checkpoint, order.setup);
  } catch (const results::Error& problem) {
    send_remark(order.realization,
                fmt::format("starts afresh; its checkpoint is of no use: {}", problem.what()));
    return std::nullopt;
  }
}

solver::Outcome run(const Order& order, const Simulate& simulate) {
  Reporter reporter(order);
  solver::Execution execution{order.threads, order.wall_limit_seconds};
  if (const std::optional<solver::PushState> state = kept_state(order)) {
    execution.resume = &*state;
    try {
      if (const auto depth = state->find("push.depth"); depth != state->end() && !depth->second.empty())
        reporter.say_when_running(
            fmt::format("goes on from its checkpoint at {:.1f} mm depth", depth->second.front() * 1e3));
      return simulate(order.setup, reporter, execution);
    } catch (const solver::StateMismatch& problem) {
      send_remark(order.realization, fmt::format("starts afresh; its checkpoint is of no use: {}: {}",
                                                 order.checkpoint, problem.what()));
      execution.resume = nullptr;
      reporter.say_when_running({});
    }
  }
  return simulate(order.setup, reporter, execution);
}

}  // namespace

int serve_realization(const Simulate& simulate) {
  return serve_order([&](const Order& order) {
    return order.setup.program ? run_ordered_program(order) : run(order, simulate);
  });
}

}  // namespace cpt::campaign

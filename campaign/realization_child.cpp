#include "campaign/realization_child.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "campaign/clock.hpp"
#include "campaign/descriptors.hpp"
#include "campaign/external/run_program.hpp"
#include "campaign/messages.hpp"
#include "campaign/stop_signals.hpp"
#include "results/push/checkpoint.hpp"

namespace cpt::campaign {
namespace {

volatile sig_atomic_t termination_asked = 0;
void ask_termination(int) { termination_asked = 1; }

// False if the parent is gone.
bool send_rest(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(channel_descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

// A parent that died before the call of prctl has closed its end of the socket.
bool parent_lives() {
  std::byte byte{};
  return ::recv(channel_descriptor, &byte, 1, MSG_PEEK | MSG_DONTWAIT) != 0;
}

std::optional<Order> receive_order() {
  FrameReader reader;
  std::array<std::byte, 4096> bytes;
  for (;;) {
    const ssize_t size = ::recv(channel_descriptor, bytes.data(), bytes.size(), 0);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return std::nullopt;
    reader.feed(std::span(bytes).first(static_cast<std::size_t>(size)));
    if (std::optional<Message> message = reader.next()) {
      Order* order = std::get_if<Order>(&*message);
      return order != nullptr && parent_lives() ? std::optional(std::move(*order)) : std::nullopt;
    }
  }
}

bool send_remark(int realization, std::string text) {
  return send_rest(frame(Remark{realization, std::move(text)}));
}

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
    const Bytes bytes = frame(ProgressReport{realization_, progress});
    // If the parent does not listen just now, this progress is left out rather than waited for.
    const ssize_t sent = ::send(channel_descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) send_rest(std::span(bytes).subspan(static_cast<std::size_t>(sent)));
  }

  bool stop_requested(std::string& reason) override {
    if (termination_asked == 0) return false;
    reason = "asked to end";
    return true;
  }

  bool state_wanted() override {
    if (order_.checkpoint.empty() || unwritable_) return false;
    return termination_asked != 0 || monotonic_seconds() > last_kept_ + order_.checkpoint_seconds;
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

// A program outlives its starter, so that this process stays to end it when its own parent has gone.
solver::Outcome run_external(const Order& order) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (!parent_lives()) ask_termination(SIGTERM);
  return run_program(order, {[] { return termination_asked != 0; },
                             [&](std::string text) { send_remark(order.realization, std::move(text)); }});
}

}  // namespace

int serve_realization(const Simulate& simulate) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  struct sigaction action {};
  action.sa_handler = ask_termination;
  for (const int signal : stop_signals) ::sigaction(signal, &action, nullptr);
  ::signal(SIGXFSZ, SIG_IGN);  // a checkpoint beyond the limit of file sizes is an error like others

  OutcomeReport report;
  try {
    const std::optional<Order> order = receive_order();
    if (!order) {
      std::fputs("no order to run a realization; this command is started by campaign itself\n", stderr);
      return 2;
    }
    report.realization = order->realization;
    ::prctl(PR_SET_NAME, ("realization " + std::to_string(order->realization)).c_str());  // for top and ps
    report.outcome = order->setup.program ? run_external(*order) : run(*order, simulate);
    report.interrupted = termination_asked != 0 && report.outcome.status == solver::Status::time_limit;
  } catch (const std::bad_alloc&) {
    std::fputs("out of memory\n", stderr);
    return 1;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
  return send_rest(frame(report)) ? 0 : 1;
}

}  // namespace cpt::campaign

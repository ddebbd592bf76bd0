#include "campaign/realization_child.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>

#include "campaign/clock.hpp"
#include "campaign/descriptors.hpp"
#include "campaign/messages.hpp"

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

// Passes progress on a few times a second.
class Reporter final : public solver::Observer {
 public:
  explicit Reporter(int realization) : realization_(realization) {}

  void progress(const solver::Progress& progress) override {
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

 private:
  int realization_;
  double next_ = 0.0;
};

}  // namespace

int serve_realization(const Simulate& simulate) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  struct sigaction action {};
  action.sa_handler = ask_termination;
  ::sigaction(SIGTERM, &action, nullptr);

  OutcomeReport report;
  try {
    const std::optional<Order> order = receive_order();
    if (!order) {
      std::fputs("no order to run a realization; this command is started by campaign itself\n", stderr);
      return 2;
    }
    report.realization = order->realization;
    ::prctl(PR_SET_NAME, ("realization " + std::to_string(order->realization)).c_str());  // for top and ps
    Reporter reporter(order->realization);
    report.outcome = simulate(order->setup, reporter, {order->threads, order->wall_limit_seconds});
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
  return send_rest(frame(report)) ? 0 : 1;
}

}  // namespace cpt::campaign

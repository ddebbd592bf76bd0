#include "campaign/order_server.hpp"

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
#include <utility>

#include "campaign/descriptors.hpp"
#include "campaign/stop_signals.hpp"

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

}  // namespace

bool told_to_end() { return termination_asked != 0; }

bool send_remark(int realization, std::string text) {
  return send_rest(frame(Remark{realization, std::move(text)}));
}

void send_progress(const ProgressReport& report) {
  const Bytes bytes = frame(report);
  const ssize_t sent = ::send(channel_descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent > 0) send_rest(std::span(bytes).subspan(static_cast<std::size_t>(sent)));
}

void outlive_parent_to_end() {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (!parent_lives()) ask_termination(SIGTERM);
}

int serve_order(const std::function<solver::Outcome(const Order&)>& run) {
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
    report.outcome = run(*order);
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

#include "campaign/stop_signals.hpp"

#include <signal.h>

namespace cpt::campaign {
namespace {

constexpr int caught[] = {SIGINT, SIGTERM, SIGHUP};
volatile sig_atomic_t received_signal = 0;
void remember(int signal) { received_signal = signal; }

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

StopSignals::StopSignals() {
  received_signal = 0;
  for (const int signal : caught) handle(signal, remember);
  handle(SIGPIPE, SIG_IGN);
}

StopSignals::~StopSignals() {
  for (const int signal : caught) handle(signal, SIG_DFL);
  handle(SIGPIPE, SIG_DFL);
}

int StopSignals::received() { return received_signal; }

}  // namespace cpt::campaign

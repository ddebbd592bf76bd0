#include "campaign/stop_signals.hpp"

namespace cpt::campaign {
namespace {

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
  for (const int signal : stop_signals) handle(signal, remember);
}

StopSignals::~StopSignals() {
  for (const int signal : stop_signals) handle(signal, SIG_DFL);
}

int StopSignals::received() { return received_signal; }

}  // namespace cpt::campaign

#include "campaign/worker.hpp"

#include "campaign/clock.hpp"
#include "campaign/cores.hpp"
#include "campaign/stop_signals.hpp"

namespace cpt::campaign {
namespace {

constexpr double heartbeat_interval = 2.0;  // [s]

bool is_interrupted(const Message& message) {
  const auto* report = std::get_if<OutcomeReport>(&message);
  return report != nullptr && report->interrupted;
}

// Lets realizations keep their states where nobody waits for their outcomes any more.
void end_all(Executor& executor) {
  executor.ask_all_to_end();
  Napping napping;
  const double until = monotonic_seconds() + stop_grace;
  for (double now = monotonic_seconds(); executor.running() > 0 && now < until; now = monotonic_seconds())
    executor.nap(napping.next(!executor.service(now).empty(), now, 0.05));
}

}  // namespace

int own_slots(const Transport& transport, const RunOptions& options) {
  const int cores = use_allowed_cores(transport.size() > 1);
  if (options.slots > 0) return options.slots;
  return share_of_cores(cores, transport.ranks_on_node(), transport.rank_on_node());
}

void serve_master(Transport& transport, const RunOptions& options) {
  ProcessExecutor executor(options.realization_command);
  serve_master(transport, executor, options);
}

void serve_master(Transport& transport, Executor& executor, const RunOptions& options) {
  Napping napping;
  const int slots = own_slots(transport, options);
  transport.send(master, Hello{transport.node(), slots});
  double last_word = monotonic_seconds();
  std::optional<double> leave_by;  // [s] once told to stop
  bool left = false;

  while (!transport.orphaned()) {
    const double now = monotonic_seconds();
    bool busy = false;
    bool told_to_stop = StopSignals::received() != 0;
    while (std::optional<Received> received = transport.poll()) {
      busy = true;
      if (std::holds_alternative<Dismissed>(received->message)) return end_all(executor);
      told_to_stop = told_to_stop || std::holds_alternative<Stop>(received->message);
      if (const Order* order = std::get_if<Order>(&received->message); order && !leave_by)
        executor.start(*order, now);
    }
    for (const Message& message : executor.service(now)) {
      busy = true;
      if (leave_by && is_interrupted(message)) continue;  // its leaving tells the master
      transport.send(master, message);
      last_word = now;
    }
    if (told_to_stop && !leave_by) {
      executor.ask_all_to_end();
      leave_by = now + stop_grace;
    }
    if (leave_by && !left && (executor.running() == 0 || now > *leave_by)) {
      // The master gives this rank's work to others; leaving the job itself would take all of it down.
      executor.kill_all();
      transport.send(master, Leaving{});
      left = true;
    }
    if (now > last_word + heartbeat_interval) {
      // A whole offer, so that the next campaign of the same job finds its workers too.
      transport.send(master, Hello{transport.node(), slots});
      last_word = now;
    }
    executor.nap(napping.next(busy, now, transport.longest_nap()));
  }
  end_all(executor);
}

}  // namespace cpt::campaign

#include "campaign/worker.hpp"

#include "campaign/clock.hpp"
#include "campaign/cores.hpp"
#include "campaign/executor.hpp"
#include "campaign/stop_signals.hpp"

namespace cpt::campaign {
namespace {

constexpr int master = 0;
constexpr double heartbeat_interval = 2.0;  // [s]

}  // namespace

int own_slots(const Transport& transport, const RunOptions& options) {
  const int cores = use_allowed_cores(transport.size() > 1);
  if (options.slots > 0) return options.slots;
  return share_of_cores(cores, transport.ranks_on_node(), transport.rank_on_node());
}

void serve_master(Transport& transport, const RunOptions& options) {
  Executor executor(options.realization_command);
  Napping napping(transport.longest_nap());
  const int slots = own_slots(transport, options);
  transport.send(master, Hello{transport.node(), slots});
  double last_word = monotonic_seconds();
  bool leaving = false;

  while (!transport.orphaned()) {
    const double now = monotonic_seconds();
    bool busy = false;
    while (std::optional<Received> received = transport.poll()) {
      busy = true;
      if (std::holds_alternative<Dismissed>(received->message)) return;
      if (const Order* order = std::get_if<Order>(&received->message); order && !leaving)
        executor.start(*order, now);
    }
    for (const Message& message : executor.service(now)) {
      busy = true;
      transport.send(master, message);
      last_word = now;
    }
    if (StopSignals::received() != 0 && !leaving) {
      // The master gives this rank's work to others; leaving the job itself would take all of it down.
      executor.kill_all();
      transport.send(master, Leaving{});
      leaving = true;
    }
    if (now > last_word + heartbeat_interval) {
      // A whole offer, so that the next campaign of the same job finds its workers too.
      transport.send(master, Hello{transport.node(), slots});
      last_word = now;
    }
    executor.nap(napping.next(busy));
  }
}

}  // namespace cpt::campaign

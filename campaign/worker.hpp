// A rank other than the master: runs what it is told to.
#pragma once

#include "campaign/executor.hpp"
#include "campaign/run_options.hpp"
#include "campaign/transport.hpp"

namespace cpt::campaign {

/// Cores this rank contributes: options.slots, or its share of what its machine allows. Also frees the rank
/// from mpirun's binding (cores.hpp).
[[nodiscard]] int own_slots(const Transport& transport, const RunOptions& options);

/// Offers this rank's slots to the master and serves it until it is dismissed.
void serve_master(Transport& transport, Executor& executor, const RunOptions& options);
/// With a process of its own for each realization.
void serve_master(Transport& transport, const RunOptions& options);

/// The master's duty whatever happens to it: on destruction sends every worker home.
class Dismissal {
 public:
  explicit Dismissal(Transport& transport) : transport_(transport) {}
  ~Dismissal() {
    for (int rank = 1; rank < transport_.size(); ++rank) transport_.send(rank, Dismissed{});
  }
  Dismissal(const Dismissal&) = delete;
  Dismissal& operator=(const Dismissal&) = delete;

 private:
  Transport& transport_;
};

}  // namespace cpt::campaign

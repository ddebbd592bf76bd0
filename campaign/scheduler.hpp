// Which realization runs where, with how many threads. Pure bookkeeping: no MPI, no processes, no clock.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace cpt::campaign {

/// Hand this realization to this rank.
struct Assignment {
  int realization;
  int rank;
  int threads;
};

/// Realizations by state; `failed` are finished too, but not well.
struct Tally {
  int pending = 0;
  int running = 0;
  int finished = 0;
  int failed = 0;
  [[nodiscard]] int total() const { return pending + running + finished + failed; }
};

/// Ranks contribute slots (cores) to their node. A realization is started by one rank and takes `threads`
/// slots of that rank's node: one while enough realizations are pending to fill all cores, more when fewer
/// remain.
class Scheduler {
 public:
  /// Realizations are handed out in the order given. `threads` fixes the threads of every realization (at
  /// most its node's slots); 0 chooses.
  explicit Scheduler(std::span<const int> realizations, int threads = 0);

  /// A rank offers slots; 0 slots are allowed. Throws std::invalid_argument if the rank is known already.
  void add_rank(int rank, int node, int slots);
  /// The rank is gone: its running realizations are pending again, before all others. Returns them. Its slots
  /// go to another rank of its node, if there is one: the cores are still there.
  std::vector<int> lose_rank(int rank);

  /// The next realization to start, which is then running; nullopt if none is pending or no slot is free.
  [[nodiscard]] std::optional<Assignment> next();
  /// A running realization ended. False (and nothing changes) if `rank` is not running it: a late word from a
  /// lost rank.
  bool end(int realization, int rank, bool failed);
  /// A running realization was interrupted: it is pending again, before all others. False as with `end`.
  bool put_back(int realization, int rank);
  /// A pending realization is given up, for instance after several ranks were lost with it.
  void give_up(int realization);

  /// Pending realizations that are not to be run after all; returns those that were still pending.
  std::vector<int> drop(std::span<const int> realizations);

  [[nodiscard]] Tally tally() const;
  [[nodiscard]] bool done() const { return pending_.empty() && running_.empty(); }
  [[nodiscard]] int slots() const;
  /// Rank that runs a realization; nullopt if none does.
  [[nodiscard]] std::optional<int> runner(int realization) const;

 private:
  struct Rank {
    int node;
    int slots;
    int realizations = 0;
  };
  struct Running {
    int rank;
    int threads;
  };
  [[nodiscard]] std::map<int, int> free_slots() const;  // by node
  [[nodiscard]] int node_slots(int node) const;
  [[nodiscard]] int choose_threads(int free_here, int free_everywhere, int node) const;
  [[nodiscard]] int choose_rank(int node) const;

  int fixed_threads_;
  std::deque<int> pending_;  // in the order of handing out
  std::map<int, Running> running_;
  std::map<int, Rank> ranks_;
  int finished_ = 0;
  int failed_ = 0;
};

}  // namespace cpt::campaign

// How messages travel between the master (rank 0) and the workers.
#pragma once

#include <optional>

#include "campaign/messages.hpp"

namespace cpt::campaign {

inline constexpr int master = 0;  ///< its rank

/// A message and the rank it came from.
struct Received {
  int from;
  Message message;
};

/// Nothing here blocks: who waits, sleeps between polls, so that a waiting rank leaves its core to
/// realizations.
class Transport {
 public:
  virtual ~Transport() = default;
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// Ranks with the same node number share a machine.
  [[nodiscard]] virtual int node() const = 0;
  [[nodiscard]] virtual int ranks_on_node() const = 0;
  [[nodiscard]] virtual int rank_on_node() const = 0;
  virtual void send(int to, const Message& message) = 0;
  /// The next message that has arrived, if any. Throws MalformedMessage.
  [[nodiscard]] virtual std::optional<Received> poll() = 0;
  /// [s] longest useful sleep until the next poll; short while a long message is under way.
  [[nodiscard]] virtual double longest_nap() const = 0;
  /// True once the launcher of the ranks (mpirun) is gone and nobody will end this rank.
  [[nodiscard]] virtual bool orphaned() const = 0;
};

/// One process without mpirun: a master with nobody to talk to.
class InProcessTransport final : public Transport {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int size() const override { return 1; }
  [[nodiscard]] int node() const override { return 0; }
  [[nodiscard]] int ranks_on_node() const override { return 1; }
  [[nodiscard]] int rank_on_node() const override { return 0; }
  void send(int, const Message&) override {}
  [[nodiscard]] std::optional<Received> poll() override { return std::nullopt; }
  [[nodiscard]] double longest_nap() const override { return 0.2; }
  [[nodiscard]] bool orphaned() const override { return false; }
};

}  // namespace cpt::campaign

// What the master, the workers and the realizations' processes say to each other.
#pragma once

#include <sys/types.h>

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "campaign/bytes.hpp"
#include "solver/simulate.hpp"

namespace cpt::campaign {

/// A worker offers its slots (one slot is one core) to the master.
struct Hello {
  int node = 0;   ///< ranks with the same number share a machine
  int slots = 0;  ///< cores this rank contributes
};

/// One realization to run: everything its process needs.
struct Order {
  int realization = 0;
  int threads = 1;
  double wall_limit_seconds = std::numeric_limits<double>::infinity();
  double hang_limit_seconds = 300.0;  ///< without a step forward
  solver::Setup setup;
  std::string checkpoint = {};  ///< file to go on from and to keep the state in; empty: none
  double checkpoint_seconds = std::numeric_limits<double>::infinity();  ///< between two states kept
  std::string work = {};  ///< folder for an external program to work in; its `checkpoint` is a folder, too
};

struct ProgressReport {
  int realization = 0;
  solver::Progress progress{};
};

struct OutcomeReport {
  int realization = 0;
  solver::Outcome outcome;
  bool interrupted = false;  ///< told to end from outside: no outcome to record, to be run again
};

/// Something about a realization that its user should know.
struct Remark {
  int realization = 0;
  std::string text;
};

/// The master asks a worker to stop as a signal would.
struct Stop {};

/// A worker was told to stop; its realizations have ended.
struct Leaving {};

/// The master has no more work.
struct Dismissed {};

using Message = std::variant<Hello, Order, ProgressReport, OutcomeReport, Remark, Stop, Leaving, Dismissed>;

[[nodiscard]] Bytes encode(const Message& message);
/// Throws MalformedMessage. A decoded order's setup has the sender's canonical text, or decoding fails.
[[nodiscard]] Message decode(std::span<const std::byte> bytes);

/// A message with a header, for byte streams.
[[nodiscard]] Bytes frame(const Message& message);

/// Cuts a byte stream into messages.
class FrameReader {
 public:
  void feed(std::span<const std::byte> bytes);
  /// The next whole message; nullopt if more bytes are needed. Throws MalformedMessage if the stream is not
  /// ours.
  [[nodiscard]] std::optional<Message> next();
  /// True inside an unfinished message.
  [[nodiscard]] bool partial() const { return !buffer_.empty(); }

 private:
  Bytes buffer_;
};

}  // namespace cpt::campaign

// Runs the realizations of one rank.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "campaign/realization_command.hpp"
#include "campaign/realization_process.hpp"

namespace cpt::campaign {

class Executor {
 public:
  virtual ~Executor() = default;
  virtual void start(const Order& order, double now) = 0;
  /// What happened since the last call: progress and outcomes. Does not block.
  [[nodiscard]] virtual std::vector<Message> service(double now) = 0;
  /// Sleeps until a realization has news, a signal arrives, or `seconds` have passed.
  virtual void nap(double seconds) const = 0;
  /// Asks all realizations to keep their states and end; their outcomes follow, most as interrupted.
  virtual void ask_all_to_end() = 0;
  virtual void kill_all() = 0;
  [[nodiscard]] virtual std::size_t running() const = 0;
};

/// Each realization in a process of its own.
class ProcessExecutor final : public Executor {
 public:
  explicit ProcessExecutor(RealizationCommand command) : command_(std::move(command)) {}

  void start(const Order& order, double now) override;
  [[nodiscard]] std::vector<Message> service(double now) override;
  void nap(double seconds) const override;
  void ask_all_to_end() override;
  void kill_all() override { processes_.clear(); }
  [[nodiscard]] std::size_t running() const override { return processes_.size(); }

 private:
  RealizationCommand command_;
  std::map<int, std::unique_ptr<RealizationProcess>> processes_;  // by realization
};

/// For so long [s] realizations that were asked to end may take to keep their states; then they are killed.
inline constexpr double stop_grace = 10.0;

/// Length of the next sleep between polls [s]: none after something happened, then 1 ms and at most half a
/// percent of the time since, so that waiting adds as little to it and a rank with nothing to do leaves its
/// core alone.
class Napping {
 public:
  [[nodiscard]] double next(bool something_happened, double now, double longest) {
    if (something_happened) last_ = now;
    return something_happened ? 0.0 : std::min(std::max(0.005 * (now - last_), 0.001), longest);
  }

 private:
  double last_ = 0.0;  // [s] when something happened
};

}  // namespace cpt::campaign

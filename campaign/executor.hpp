// Runs realizations of one rank, each in a process of its own.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "campaign/realization_process.hpp"

namespace cpt::campaign {

class Executor {
 public:
  /// `command` starts one realization process (realization_child.hpp).
  explicit Executor(std::vector<std::string> command) : command_(std::move(command)) {}

  void start(const Order& order, double now);
  /// What happened since the last call: progress and outcomes. Does not block.
  [[nodiscard]] std::vector<Message> service(double now);
  /// Sleeps until a realization has news, a signal arrives, or `seconds` have passed.
  void nap(double seconds) const;
  /// Asks all realizations to keep their states and end; their outcomes follow, most as interrupted.
  void ask_all_to_end();
  void kill_all() { processes_.clear(); }
  [[nodiscard]] std::size_t running() const { return processes_.size(); }

 private:
  std::vector<std::string> command_;
  std::map<int, std::unique_ptr<RealizationProcess>> processes_;  // by realization
};

/// For so long [s] realizations that were asked to end may take to keep their states; then they are killed.
inline constexpr double stop_grace = 10.0;

/// Length of the next sleep between polls: short after something happened, doubling to `longest` while
/// nothing does, so that a waiting rank reacts at once and still leaves its core alone.
class Napping {
 public:
  explicit Napping(double longest) : longest_(longest) {}
  [[nodiscard]] double next(bool something_happened) {
    nap_ = something_happened ? 0.001 : (nap_ * 2.0 < longest_ ? nap_ * 2.0 : longest_);
    return nap_;
  }

 private:
  double longest_;      // [s]
  double nap_ = 0.001;  // [s]
};

}  // namespace cpt::campaign

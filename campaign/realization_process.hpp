// The parent's end of one realization that runs in a process of its own.
//
// A realization may crash, hang, run out of memory or write nonsense; here each of these becomes an outcome
// with a status and a reason, and the campaign goes on.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "campaign/messages.hpp"

namespace cpt::campaign {

class RealizationProcess {
 public:
  /// Starts `command` (absolute path and arguments) and hands it the order. If it cannot be started, the
  /// first service() returns a crashed outcome.
  RealizationProcess(const std::vector<std::string>& command, Order order, double now);
  /// Kills the process if it still runs.
  ~RealizationProcess();
  RealizationProcess(const RealizationProcess&) = delete;
  RealizationProcess& operator=(const RealizationProcess&) = delete;

  struct News {
    std::optional<solver::Progress> progress;  ///< the latest since the last call
    std::optional<solver::Outcome> outcome;    ///< the process is gone; nothing follows
    bool interrupted = false;                  ///< with an outcome: it was told to end, not by its limits
    std::vector<std::string> remarks;
  };
  /// Takes in what the process sent, enforces its limits, notices its end. Does not block.
  [[nodiscard]] News service(double now);
  /// Tells it to end; the outcome is then `interrupted`, unless it finishes first.
  void ask_to_end() const;

  [[nodiscard]] int realization() const { return order_.realization; }
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Descriptor that becomes readable when there is something to service; -1 once there is no more.
  [[nodiscard]] int descriptor() const { return channel_; }

 private:
  /// Which deadline to end the process by, if any.
  struct Ending {
    solver::Status status;
    std::string reason;
    double kill_at;  // [s] when asking becomes killing
  };
  void read_channel(News& news, double now);
  void read_errors();
  void accept(Message message, News& news, double now);
  void enforce_limits(double now);
  void kill_group() const;
  void end_by(solver::Status status, std::string reason, double kill_at);
  [[nodiscard]] bool interrupted(int wait_status) const;
  [[nodiscard]] solver::Outcome conclude(int wait_status, double now);
  [[nodiscard]] solver::Outcome failure(solver::Status status, std::string reason, double now) const;

  Order order_;
  pid_t pid_ = -1;
  int channel_ = -1;          // [-] socket to the child: the order down; progress and the outcome up
  int errors_ = -1;           // [-] pipe from the child's stdout and stderr
  double started_;            // [s]
  double last_step_forward_;  // [s]
  std::string start_failure_;
  FrameReader reader_;
  std::string last_words_;  // tail of what the child wrote to stderr
  std::optional<solver::Progress> progress_;
  std::optional<solver::Outcome> outcome_;
  bool interrupted_ = false;
  std::optional<Ending> ending_;
};

}  // namespace cpt::campaign

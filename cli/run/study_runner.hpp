// Runs several studies one after the other on the same ranks.
#pragma once

#include <functional>

#include "campaign/run_options.hpp"
#include "campaign/transport.hpp"
#include "parameters/study.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::cli {

class StudyRunner {
 public:
  /// Thrown when a signal has ended a campaign; the same command goes on where it was.
  struct Stopped {
    int signal;
  };

  StudyRunner(const campaign::RunOptions& options, bool quiet, std::string study_text,
              campaign::Transport& transport)
      : options_(options), quiet_(quiet), study_text_(std::move(study_text)), transport_(transport) {}

  /// What `study` holds when all has run; what another campaign's database has finished is taken from there.
  /// Throws Stopped.
  results::Snapshot run(const parameters::Study& study, const std::filesystem::path& finished);
  [[nodiscard]] bool ranks_lost() const { return ranks_lost_; }

 private:
  const campaign::RunOptions& options_;
  bool quiet_;
  std::string study_text_;
  campaign::Transport& transport_;
  bool ranks_lost_ = false;
};

/// The master's part of a command: it returns the exit code and tells whether ranks were lost.
using MasterWork = std::function<int(campaign::Transport& transport, bool& ranks_lost)>;

/// Calls `work` with the transport of this process: the master's under MPI or alone. Other ranks serve it.
[[nodiscard]] int run_on_ranks(const campaign::RunOptions& options, const MasterWork& work);

/// The same; StudyRunner::Stopped and std::invalid_argument thrown by `work` become codes and messages.
[[nodiscard]] int run_as_master(const campaign::RunOptions& options, const MasterWork& work);

}  // namespace cpt::cli

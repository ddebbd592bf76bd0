// The master: hands out the realizations of a study, records how each ended, until all have.
#pragma once

#include <string>

#include "campaign/executor.hpp"
#include "campaign/progress_display.hpp"
#include "campaign/run_options.hpp"
#include "campaign/transport.hpp"
#include "parameters/study.hpp"

namespace cpt::campaign {

/// Time of a part of the work [s].
struct Spent {
  double wall = 0.0;
  double processor = 0.0;
};

/// Where the master's time went.
struct MasterTime {
  Spent messages;      ///< sending and receiving, packing included
  Spent database;      ///< transactions of the ledger
  Spent curves;        ///< the curve file
  Spent page;          ///< the page that follows the campaign
  Spent realizations;  ///< starting its own realizations and listening to them
  Spent waiting;       ///< asleep
  Spent whole;         ///< all of it, from the open ledger on; the rest is scheduling and display
};

/// How a campaign ended.
struct Summary {
  Tally tally;              ///< of the whole study, work of earlier campaigns included
  int signal = 0;           ///< that stopped it; 0 if none did
  bool ranks_lost = false;  ///< MPI cannot be finalized any more
  MasterTime time;
  std::string curves_problem;  ///< why the curve file could not be written in the end; empty if it was
  bool complete() const { return tally.finished == tally.total(); }
};

/// Runs what the study's database does not hold yet. Whatever a realization does ends up in the database as
/// its status and reason; the campaign goes on. A worker that falls silent is lost: its realizations start
/// again elsewhere, and after two losses count as rank_lost. SIGINT, SIGTERM, SIGHUP and SIGUSR1 end the
/// campaign with the database in order and the states of unfinished pushes beside it
/// (results/push/checkpoint.hpp); the same call later goes on. Throws results::Locked if another campaign
/// holds the database and results::Error if it cannot be used.
[[nodiscard]] Summary run_campaign(const parameters::Study& study, const std::string& study_text,
                                   Transport& transport, Executor& executor, const RunOptions& options,
                                   ProgressDisplay& display);
/// With a process of its own for each realization.
[[nodiscard]] Summary run_campaign(const parameters::Study& study, const std::string& study_text,
                                   Transport& transport, const RunOptions& options, ProgressDisplay& display);

}  // namespace cpt::campaign

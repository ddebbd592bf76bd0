// The master: hands out the realizations of a study, records how each ended, until all have.
#pragma once

#include <string>

#include "campaign/progress_display.hpp"
#include "campaign/run_options.hpp"
#include "campaign/transport.hpp"
#include "parameters/study.hpp"

namespace cpt::campaign {

/// How a campaign ended.
struct Summary {
  Tally tally;              ///< of the whole study, work of earlier campaigns included
  int signal = 0;           ///< that stopped it; 0 if none did
  bool ranks_lost = false;  ///< MPI cannot be finalized any more
  bool complete() const { return tally.finished == tally.total(); }
};

/// Runs what the study's database does not hold yet. Whatever a realization does ends up in the database as
/// its status and reason; the campaign goes on. A worker that falls silent is lost: its realizations start
/// again elsewhere, and after two losses count as rank_lost. SIGINT, SIGTERM, SIGHUP and SIGUSR1 end the
/// campaign with the database in order and the states of unfinished pushes beside it
/// (results/checkpoint.hpp); the same call later goes on. Throws results::Locked if another campaign holds
/// the database and results::Error if it cannot be used.
[[nodiscard]] Summary run_campaign(const parameters::Study& study, const std::string& study_text,
                                   Transport& transport, const RunOptions& options, ProgressDisplay& display);

}  // namespace cpt::campaign

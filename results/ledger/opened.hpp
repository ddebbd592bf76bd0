// How a study and what its ledger holds fit together.
#pragma once

#include <string>
#include <vector>

namespace cpt::results {

/// What opening a ledger for a run finds and does.
struct Opened {
  bool created = false;  ///< a new database
  int kept = 0;          ///< completed with the same settings: not run again
  int failed = 0;        ///< failed with the same settings: stay failed (retry_failed runs them again)
  int used_again = 0;    ///< of the two: unused until now
  int interrupted =
      0;              ///< were running, or lost with their rank, when the last campaign ended: pending again
  int running = 0;    ///< run now, by the campaign that holds the lock: only of a look at its database
  int retried = 0;    ///< failed ones set back to pending because retry_failed asked for it
  int damaged = 0;    ///< no longer match their checksum: pending again
  int fresh = 0;      ///< not in the database: pending
  int set_aside = 0;  ///< finished ones that were in use until now and whose settings the study no longer has
  int unused = 0;     ///< all finished ones that the study does not ask for; they stay in the database
  std::vector<std::string> other_solvers;  ///< versions that made some of them, other than this one
  int of_other_solvers = 0;                ///< how many
  int pending = 0;                         ///< to run now
  std::vector<std::string>
      messages;  ///< the above in sentences, for the user; empty where there is nothing to say
};

}  // namespace cpt::results

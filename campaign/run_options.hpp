// How a campaign is run; none of it changes a bit of its results.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/realization_command.hpp"
#include "results/files/file_system.hpp"

namespace cpt::campaign {

struct RunOptions {
  RealizationCommand realization_command;
  int slots = 0;    ///< cores of each rank; 0 = this rank's share of its machine's allowed cores
  int threads = 0;  ///< inside each realization; 0 = 1, and more for the last realizations
  double hang_limit_seconds = 300.0;  ///< a realization that makes no step for so long is ended
  double rank_limit_seconds = 30.0;   ///< a worker silent for so long is lost
  double checkpoint_seconds = 300.0;  ///< between two checkpoints of a realization; 0: none at all
  std::optional<results::FileSystem> file_system = {};  ///< of the database; found out if not given
  /// Writes the page of a campaign that is still running, or was stopped, from its database, and returns the
  /// page's file; none if empty. May throw results::Error.
  std::function<std::string(bool running)> write_page = {};
  bool retry_failed = false;              ///< run realizations again that failed in an earlier campaign
  std::filesystem::path adopt_from = {};  ///< another database; what it has completed is not run again
};

}  // namespace cpt::campaign

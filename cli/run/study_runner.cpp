#include "cli/run/study_runner.hpp"

#include <fmt/format.h>

#include "campaign/mpi_transport.hpp"
#include "campaign/progress_display.hpp"
#include "campaign/run_campaign.hpp"
#include "campaign/stop_signals.hpp"
#include "campaign/worker.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"

namespace cpt::cli {
namespace {

int as_master(campaign::Transport& transport, bool& ranks_lost, const MasterWork& work) {
  const campaign::Dismissal dismissal(transport);
  return work(transport, ranks_lost);
}

}  // namespace

results::Snapshot StudyRunner::run(const parameters::Study& study, const std::filesystem::path& finished) {
  campaign::RunOptions options = options_;
  options.adopt_from = finished;
  campaign::ProgressDisplay display(stderr, quiet_ ? campaign::ProgressDisplay::Style::silent
                                                   : campaign::ProgressDisplay::style_of(stderr));
  const campaign::Summary summary = campaign::run_campaign(study, study_text_, transport_, options, display);
  ranks_lost_ = ranks_lost_ || summary.ranks_lost;
  if (summary.signal != 0) throw Stopped{summary.signal};
  return results::read_snapshot(study.database);
}

int run_on_ranks(const campaign::RunOptions& options, const MasterWork& work) {
  const campaign::StopSignals signals;
  bool ranks_lost = false;
  if (!campaign::started_by_mpi()) {
    campaign::InProcessTransport transport;
    return as_master(transport, ranks_lost, work);
  }
  campaign::MpiTransport transport;
  if (transport.rank() != 0) {
    campaign::serve_master(transport, options);
    return all_well;
  }
  const int code = as_master(transport, ranks_lost, work);
  if (ranks_lost) transport.abandon(code);
  return code;
}

int run_as_master(const campaign::RunOptions& options, const MasterWork& work) {
  return run_on_ranks(options, [&](campaign::Transport& transport, bool& ranks_lost) {
    try {
      return work(transport, ranks_lost);
    } catch (const StudyRunner::Stopped& stopped) {
      fmt::print(stderr, "stopped by signal {}; the same command goes on where this one stopped\n",
                 stopped.signal);
      return stopped_by_signal + stopped.signal;
    } catch (const std::invalid_argument& problem) {
      throw BadInput(problem.what());
    }
  });
}

}  // namespace cpt::cli

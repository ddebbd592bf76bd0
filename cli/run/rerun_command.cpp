// campaign rerun STUDY ID
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <memory>
#include <optional>

#include "campaign/clock.hpp"
#include "campaign/cores.hpp"
#include "campaign/executor.hpp"
#include "campaign/stop_signals.hpp"
#include "cli/command.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "cli/run/realization_command.hpp"
#include "results/ledger/ledger_view.hpp"
#include "results/ledger/provenance.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::cli {
namespace {

struct RerunArguments {
  std::filesystem::path study;
  int id = 0;
  int threads = 0;
  std::string executor;
};

results::StoredRun find_stored(const StudyFile& file, const solver::Setup& setup, int id) {
  const parameters::Study& study = file.study;
  auto stored = results::read_run(results::view_ledger(study, file.text).database, id);
  if (!stored || !stored->row.ended())
    throw BadInput(
        fmt::format("{} holds no finished realization {}; run the study first", study.database.string(), id));
  if (stored->row.settings_hash != results::settings_hash(setup))
    throw BadInput(
        fmt::format("realization {} was run with other settings or another solver version than the study "
                    "has now; run the study again",
                    id));
  return *std::move(stored);
}

// The outcome, or nullopt if a signal stopped the run.
std::optional<solver::Outcome> run_alone(const campaign::Order& order, const std::string& executor_program) {
  campaign::ProcessExecutor executor(realization_command(executor_program));
  executor.start(order, campaign::monotonic_seconds());
  while (campaign::StopSignals::received() == 0) {
    executor.nap(0.2);
    for (campaign::Message& message : executor.service(campaign::monotonic_seconds()))
      if (auto* report = std::get_if<campaign::OutcomeReport>(&message)) return std::move(report->outcome);
  }
  return std::nullopt;
}

int compare_runs(const results::StoredRun& stored, const solver::Outcome& outcome, int id) {
  if (stored.row.status != solver::to_string(outcome.status)) {
    fmt::print("realization {} differs: stored as {}, now {}{}\n", id, stored.row.status,
               solver::to_string(outcome.status), outcome.reason.empty() ? "" : ": " + outcome.reason);
    return rerun_differs;
  }
  const solver::DepthProfile before = stored.profile.value_or(solver::DepthProfile{});
  const auto bin = results::first_difference(before, outcome.profile);
  if (!outcome.profile.declared.empty() || !before.declared.empty()) {
    fmt::print("realization {} is {} as before; its outputs are {}\n", id, stored.row.status,
               bin ? "different" : "identical bit for bit");
    return bin ? rerun_differs : all_well;
  }
  if (bin) {
    const auto q_c = [&](const solver::DepthProfile& profile) {
      return *bin < profile.q_c.size() ? fmt::format("{:.17g} kPa", profile.q_c[*bin] * 1e-3)
                                       : std::string("nothing");
    };
    fmt::print("realization {} differs first in depth bin {}: q_c stored {}, now {}\n", id, *bin + 1,
               q_c(before), q_c(outcome.profile));
    return rerun_differs;
  }
  fmt::print("realization {} is {} as before; its curve of {} depth bins is identical bit for bit\n", id,
             stored.row.status, outcome.profile.depth.size());
  return all_well;
}

int rerun(const RerunArguments& arguments) {
  const campaign::StopSignals signals;
  const StudyFile file = read_study_file(arguments.study);
  const parameters::Study& study = file.study;
  campaign::Order order;
  order.realization = arguments.id;
  order.setup = parameters::make_setup(study, find_realization(study, arguments.id));
  order.wall_limit_seconds = study.wall_limit_seconds;
  if (order.setup.program) {
    order.work =
        (study.database.parent_path() / fmt::format("{}.rerun-{:04}", study.name, arguments.id)).string();
    order.hang_limit_seconds = std::numeric_limits<double>::infinity();
  }
  order.threads = arguments.threads > 0 ? arguments.threads : campaign::use_allowed_cores(false);
  const results::StoredRun stored = find_stored(file, order.setup, arguments.id);
  const std::optional<solver::Outcome> outcome = run_alone(order, arguments.executor);
  if (!outcome) return stopped_by_signal + campaign::StopSignals::received();
  return compare_runs(stored, *outcome, arguments.id);
}

}  // namespace

void add_rerun(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<RerunArguments>();
  CLI::App* command = program.add_subcommand(
      "rerun", "Run one realization again and say whether its curve is bit for bit the stored one");
  command->add_option("STUDY", arguments->study, "Study file that has been run")->type_name("")->required();
  command->add_option("ID", arguments->id, "Realization, as campaign query STUDY realizations lists it")
      ->type_name("")
      ->required();
  command->add_option("--threads", arguments->threads, "Threads [all cores]; the bits do not depend on it")
      ->type_name("N")
      ->check(CLI::Range(1, 4096).description(""));
  add_executor_option(*command, arguments->executor);
  command->footer("The database is not changed. Exit code 0: identical, 4: different.");
  command->callback([arguments, &action] { action = [arguments] { return rerun(*arguments); }; });
}

}  // namespace cpt::cli

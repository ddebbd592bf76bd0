// campaign report STUDY|DB
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "campaign/stop_signals.hpp"
#include "cli/command.hpp"
#include "cli/common/ledger_argument.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "cli/look/study_report.hpp"
#include "reports/labels.hpp"
#include "results/ledger/ledger_watch.hpp"

namespace cpt::cli {
namespace {

struct ReportArguments {
  std::filesystem::path source;
  std::filesystem::path directory;
  bool watch = false;
  double every_seconds = 5.0;
  int column_mm = static_cast<int>(drawing::Column::one_and_half);
  [[nodiscard]] drawing::Column column() const { return static_cast<drawing::Column>(column_mm); }
};

// NAME-report beside the database NAME.sqlite, or what the study says.
std::filesystem::path report_directory(const ReportArguments& arguments) {
  if (!arguments.directory.empty()) return arguments.directory;
  if (names_study(arguments.source)) return read_study_file(arguments.source).study.report_dir;
  return arguments.source.parent_path() / (arguments.source.stem().string() + "-report");
}

// Sleeps for so long, or until a signal arrives.
void sleep(std::chrono::duration<double> time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (std::chrono::steady_clock::now() < end && campaign::StopSignals::received() == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

// Writes the report whenever the database has changed, until no realization is left to run. The last page
// does not load itself anew.
int watch(const ReportArguments& arguments, const std::filesystem::path& database,
          const std::filesystem::path& directory) {
  const campaign::StopSignals signals;
  results::LedgerWatch ledger(database);
  bool quiet = false;  // what is to be said of an edited study is said once
  const int reload_seconds = std::max(1, static_cast<int>(arguments.every_seconds));
  while (campaign::StopSignals::received() == 0) {
    if (ledger.changed()) {
      const results::LedgerView view = open_ledger(arguments.source, quiet);
      const results::Snapshot campaign = results::read_snapshot(view);
      quiet = true;
      const bool running = std::any_of(campaign.realizations.begin(), campaign.realizations.end(),
                                       [](const auto& run) { return run.waiting(); });
      const auto files = write_study_report(campaign, database, directory, running ? reload_seconds : 0,
                                            arguments.column(), view.notes);
      fmt::print("{}: {}\n", files.front().string(), reports::state_of(campaign));
      std::fflush(stdout);
      if (!running) return all_well;
    }
    sleep(std::chrono::duration<double>(arguments.every_seconds));
  }
  const results::LedgerView view = open_ledger(arguments.source, quiet);
  write_study_report(results::read_snapshot(view), database, directory, 0, arguments.column(), view.notes);
  return stopped_by_signal + campaign::StopSignals::received();
}

int report(const ReportArguments& arguments) {
  const std::filesystem::path database = database_of(arguments.source),
                              directory = report_directory(arguments);
  if (arguments.watch) return watch(arguments, database, directory);
  const results::LedgerView view = open_ledger(arguments.source);
  for (const auto& file : write_study_report(results::read_snapshot(view), database, directory, 0,
                                             arguments.column(), view.notes))
    fmt::print("{}\n", file.string());
  return all_well;
}

}  // namespace

void add_report(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = program.add_subcommand(
      "report", "Write figures and tables: tornado, sensitivity indices, q_c profiles, baseline and windows");
  command->add_option("STUDY|DB", arguments->source, "Study file or database")->type_name("")->required();
  command->add_option("--directory", arguments->directory, "Where to [NAME-report beside the study]");
  command->add_flag(
      "--watch", arguments->watch,
      "Write it again whenever the campaign has got further, until it is finished; an open page "
      "follows by itself");
  command->add_option("--every", arguments->every_seconds, "With --watch: look so often [5]")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.1, 3600.0).description(""));
  command
      ->add_option("--column", arguments->column_mm,
                   "Width of the figures, a journal's column: 90, 140 or 190 [140]")
      ->type_name("MM")
      ->check(CLI::IsMember({90, 140, 190}).description(""));
  command->footer(
      "Works at any time, also while the campaign runs. Prints the files written, index.html first: one page "
      "that "
      "needs no network.");
  command->callback([arguments, &action] { action = [arguments] { return report(*arguments); }; });
}

}  // namespace cpt::cli

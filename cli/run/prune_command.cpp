// campaign prune STUDY|DB
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <set>

#include "campaign/output.hpp"
#include "cli/command.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "parameters/all_realizations.hpp"
#include "results/ledger/provenance.hpp"
#include "results/ledger/pruning.hpp"
#include "results/ledger/schema.hpp"
#include "results/tables/table_format.hpp"
#include "solver/simulate.hpp"

namespace cpt::cli {
namespace {

struct PruneArguments {
  std::filesystem::path source;
  bool yes = false, other_solvers = false, failed = false, keep_size = false;
};

std::string results_of(std::size_t count) {
  return fmt::format("{} unused result{}", count, count == 1 ? "" : "s");
}

// Settings that the study's file asks for now: their results stay, though no campaign has taken them back
// yet.
std::set<std::string> asked_for(const std::filesystem::path& source) {
  std::set<std::string> hashes;
  if (!names_study(source)) return hashes;
  const parameters::Study study = read_study_file(source).study;
  for (const parameters::Realization& realization : parameters::all_realizations(study))
    hashes.insert(results::settings_hash(parameters::make_setup(study, realization)));
  return hashes;
}

std::vector<results::UnusedRun> chosen(const results::Database& database, const PruneArguments& arguments) {
  const std::set<std::string> asked = asked_for(arguments.source);
  std::vector<results::UnusedRun> runs = results::unused_runs(database);
  const auto back =
      std::erase_if(runs, [&](const results::UnusedRun& run) { return asked.contains(run.settings_hash); });
  if (back > 0)
    fmt::print("{} stay: the study asks for their settings again\n",
               results_of(static_cast<std::size_t>(back)));
  std::erase_if(runs, [&](const results::UnusedRun& run) {
    return (arguments.other_solvers && run.solver_version == solver::solver_version()) ||
           (arguments.failed && run.status == "completed");
  });
  return runs;
}

void name(const results::Database& database, const std::vector<results::UnusedRun>& runs) {
  results::Table table{{"id", "parameter", "side", "value", "status", "solver_version", "finished", "study"},
                       {}};
  std::set<std::int64_t> studies;
  for (const results::UnusedRun& run : runs) {
    table.rows.push_back({run.id, run.parameter, run.side, run.value_text, run.status, run.solver_version,
                          run.finished, run.study});
    studies.insert(run.study);
  }
  fmt::print("{}", results::format(table, results::Format::table));
  for (const std::int64_t study : studies)
    if (const auto settings = results::former_settings(database, study); !settings.empty())
      fmt::print("study {}: {}\n", study, fmt::join(settings, "; "));
}

bool agreed(std::size_t count) {
  fmt::print("remove {} for good? [y/N] ", results_of(count));
  std::fflush(stdout);
  std::string answer;
  return std::getline(std::cin, answer) && (answer == "y" || answer == "Y" || answer == "yes");
}

void remove(results::Pruning& pruning, const std::vector<results::UnusedRun>& runs, bool keep_size) {
  pruning.remove(runs);
  fmt::print("{} removed", results_of(runs.size()));
  if (!keep_size) {
    try {
      fmt::print(", {:.1f} MB freed", static_cast<double>(pruning.shrink()) * 1e-6);
    } catch (const results::Error& problem) {
      fmt::print("\n");
      throw results::Error(
          fmt::format("they are removed, but the file could not be made smaller: {}", problem.what()));
    }
  }
  fmt::print("\n");
}

int prune(const PruneArguments& arguments) {
  const std::filesystem::path file = database_of(arguments.source);
  const bool asks = !arguments.yes && campaign::is_terminal(stdin) && campaign::is_terminal(stdout);
  // From the naming to the removal nobody else writes.
  std::optional<results::Pruning> pruning;
  std::optional<results::Database> look;
  if (arguments.yes || asks) {
    pruning.emplace(file);
  } else {
    look.emplace(file, results::Database::Mode::read_only);
    results::check_schema(*look);
  }
  const results::Database& database = pruning ? pruning->database() : *look;
  const std::vector<results::UnusedRun> runs = chosen(database, arguments);
  if (runs.empty()) {
    fmt::print("{}: nothing to remove\n", file.string());
    return all_well;
  }
  name(database, runs);
  if (arguments.yes || (asks && agreed(runs.size())))
    remove(*pruning, runs, arguments.keep_size);
  else
    fmt::print("{}; nothing is removed{}\n", results_of(runs.size()), asks ? "" : ": --yes removes them");
  return all_well;
}

}  // namespace

void add_prune(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<PruneArguments>();
  CLI::App* command = program.add_subcommand(
      "prune", "List finished results that the study no longer asks for, and remove them on request");
  command->add_option("STUDY|DB", arguments->source, "Study file or database")->type_name("")->required();
  command->add_flag("--yes", arguments->yes, "Remove what is listed, without a question");
  command->add_flag("--other-solvers", arguments->other_solvers,
                    "Only results that another solver version made; this one never uses them");
  command->add_flag("--failed", arguments->failed, "Only failed ones");
  command->add_flag("--keep-size", arguments->keep_size,
                    "Leave the freed room inside the file, for later results; else the file is written anew");
  command->footer(
      R"(An edit of a study loses nothing: results whose settings it no longer has stay in the database, unused, and count
again when it has them again. This command names them, with what their study had otherwise, and removes them: on a
terminal it asks, elsewhere only with --yes. Results that the study asks for, also after an edit, are never removed. What
the last campaign used and an edit since dropped becomes unused at the next start.

Examples:
  campaign prune sens.toml
  campaign prune sens.toml --other-solvers --yes
  campaign query sens.toml unused --format csv)");
  command->callback([arguments, &action] { action = [arguments] { return prune(*arguments); }; });
}

}  // namespace cpt::cli

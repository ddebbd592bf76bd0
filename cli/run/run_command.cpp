// campaign [run] STUDY
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "campaign/mpi_transport.hpp"
#include "campaign/run_campaign.hpp"
#include "cli/command.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "cli/look/study_report.hpp"
#include "cli/run/plan.hpp"
#include "cli/run/realization_command.hpp"
#include "cli/run/sample_growth.hpp"
#include "cli/run/study_remarks.hpp"
#include "cli/run/study_runner.hpp"

namespace cpt::cli {
namespace {

struct RunArguments {
  std::filesystem::path study;
  bool validate = false;
  bool plan = false;
  bool quiet = false;
  bool no_report = false;
  results::Format format = results::Format::table;
  std::string executor;
  campaign::RunOptions options;
};

void write_report(const parameters::Study& study) {
  const results::Snapshot campaign = results::read_snapshot(study.database);
  for (const results::WindowRow& window : campaign.windows)
    if (!window.problem.empty())
      fmt::print("note: window {} is undefined: {}\n", window.name, window.problem);
  const auto files = write_study_report(campaign, study.database, study.report_dir);
  if (!files.empty()) fmt::print("report: {}\n", files.front().string());
}

int exit_code(const campaign::Summary& summary) {
  if (summary.signal != 0) return stopped_by_signal + summary.signal;
  if (!summary.curves_problem.empty()) return unusable_file;
  return summary.complete() ? all_well : realizations_failed;
}

constexpr int reload_while_running = 5;  // of the page while the campaign runs

int run_study(RunArguments arguments, campaign::Transport& transport, bool& ranks_lost) {
  const StudyFile file = read_study_file(arguments.study);
  refuse_forgotten_growth(file.study);
  if (!arguments.quiet) print_remarks(file.study);
  if (!arguments.no_report)
    arguments.options.write_page = [&study = file.study](bool running) {
      return write_study_page(results::read_snapshot(study.database), study.database, study.report_dir,
                              running ? reload_while_running : 0)
          .string();
    };
  const auto style = arguments.quiet ? campaign::ProgressDisplay::Style::silent
                                     : campaign::ProgressDisplay::style_of(stderr);
  campaign::ProgressDisplay display(stderr, style);
  if (const std::string note = growth_note(file.study); !note.empty()) display.note(note);
  const campaign::Summary summary =
      campaign::run_campaign(file.study, file.text, transport, arguments.options, display);
  ranks_lost = summary.ranks_lost;

  const campaign::Tally& tally = summary.tally;
  if (!arguments.quiet)
    fmt::print("{} of {} realizations completed, {} failed; database: {}\n", tally.finished, tally.total(),
               tally.failed, file.study.database.string());
  if (!summary.curves_problem.empty()) fmt::print(stderr, "{}\n", summary.curves_problem);
  if (summary.signal != 0)
    fmt::print(stderr, "stopped by signal {}; the same command goes on where this one stopped\n",
               summary.signal);
  else if (!arguments.no_report)
    write_report(file.study);
  return exit_code(summary);
}

int run(const RunArguments& arguments) {
  const bool first_rank = campaign::rank_from_environment() == 0;
  if (arguments.validate || arguments.plan) {
    if (!first_rank) return all_well;
    const StudyFile file = read_study_file(arguments.study);
    if (arguments.plan && arguments.format != results::Format::table) {
      print_points(file.study, arguments.format);
      return arguments.validate ? validate(file.study) : all_well;
    }
    print_remarks(file.study);
    if (arguments.plan) print_plan(file.study);
    return arguments.validate ? validate(file.study) : all_well;
  }

  return run_on_ranks(arguments.options, [&](campaign::Transport& transport, bool& ranks_lost) {
    return run_study(arguments, transport, ranks_lost);
  });
}

}  // namespace

void add_run(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<RunArguments>();
  campaign::RunOptions& options = arguments->options;
  CLI::App* command =
      program.add_subcommand("run", "Run a study, or go on with it: finished realizations are kept");
  command->add_option("STUDY", arguments->study, "NAME.toml; results go to NAME.sqlite and NAME.h5 beside it")
      ->type_name("")
      ->required();
  command->add_flag("--validate", arguments->validate, "Check the study, build every model once, and quit");
  command->add_flag("--plan", arguments->plan, "Print the realizations and quit");
  command
      ->add_option_function<std::string>(
          "--format",
          [arguments](const std::string& name) {
            arguments->format = results::format_from_string(name).value();
          },
          "Of --plan: table (to read), or csv or json, a row a realization with all its inputs [table]")
      ->type_name("")
      ->check(CLI::IsMember({"table", "csv", "json"}).description(""));

  const auto count = CLI::Range(1, 4096).description("");
  command->add_option("--slots", options.slots, "Cores each rank uses [its share of the machine's]")
      ->type_name("N")
      ->check(count);
  command
      ->add_option("--threads", options.threads,
                   "Threads of each realization [1, and more for the last ones]")
      ->type_name("N")
      ->check(count);
  command
      ->add_option("--hang-limit", options.hang_limit_seconds,
                   "End a realization that makes no step for so long [300]")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.1, 1.0e6).description(""));
  command
      ->add_option("--rank-limit", options.rank_limit_seconds,
                   "Count an MPI rank as lost when silent for so long [30]")
      ->type_name("SECONDS")
      ->check(CLI::Range(5.0, 1.0e6).description(""));
  command
      ->add_option("--checkpoint", options.checkpoint_seconds,
                   "Keep the state of each running realization so often, and when stopped; 0: never [300]")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.0, 1.0e6).description(""));
  command
      ->add_option("--file-system", options.file_system,
                   "Where the database is: local or network [recognised]; a network needs a slower journal")
      ->type_name("KIND")
      ->transform(CLI::CheckedTransformer(
                      std::map<std::string, results::FileSystem>{{"local", results::FileSystem::local},
                                                                 {"network", results::FileSystem::network}})
                      .description(""));
  command->add_flag("--retry-failed", options.retry_failed, "Run failed realizations again");
  command->add_flag("--quiet", arguments->quiet, "No progress, no summary");
  command->add_flag("--no-report", arguments->no_report,
                    "Write no report, neither while it runs nor at the end");
  add_executor_option(*command, arguments->executor);
  command->footer(std::string(R"(No result depends on slots, threads or ranks.

Under mpirun it is mpirun that writes what the ranks print. Where it cannot, its own standard output being closed,
without a reader or on a full disk, the exit code is 6 in place of 0 and standard error says so; the results are whole.
Where mpirun runs on another machine than the rank that prints, the program cannot tell.

)") + exit_code_help);
  command->callback([arguments, &action] {
    arguments->options.realization_command = realization_command(arguments->executor);
    action = [arguments] { return run(*arguments); };
  });
}

}  // namespace cpt::cli

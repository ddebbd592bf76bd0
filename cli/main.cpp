// campaign: uncertainty and sensitivity of simulated cone penetration tests.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/mpi_transport.hpp"
#include "campaign/output.hpp"
#include "campaign/realization_child.hpp"
#include "campaign/stop_signals.hpp"
#include "cli/command.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "cli/program/misspelt.hpp"
#include "cli/program/version.hpp"
#include "parameters/nearest_name.hpp"
#include "results/files/error.hpp"
#include "results/files/patience.hpp"
#include "results/files/refusal.hpp"
#include "results/tables/query.hpp"
#include "solver/quantities.hpp"
#include "solver/simulate.hpp"

namespace {

using namespace cpt;

constexpr const char* examples = R"(Examples:
  campaign sens.toml                         run the study, or go on with it, on all cores
  mpirun -np 2 campaign sens.toml            the same with two MPI ranks, also over several machines
  campaign run sens.toml --plan              what would be run
  campaign query sens.toml sensitivity       the sensitivity indices so far
  campaign export sens.toml                  all of it as CSV tables in sens-export/
  campaign report sens.toml                  figures and tables in sens-report/
  campaign emulate clay.toml                 an emulator of its averages and curves, and how good it is
  campaign predict clay.toml --set clay.G_kPa=900 what a run would give that was not made
  campaign prune sens.toml                   finished results that an edit left unused
  campaign push sens.toml --fields-at 0.5    one push with its stress and density fields for ParaView
  campaign view sens-push                    those fields as pictures and as an animation
  campaign element triaxial --p0_kPa 100     a triaxial test of the sand
  campaign element calibrate cd_160kPa.csv   hardening modulus from a measured one
  campaign recording sounding.gef            what a measured sounding holds, with its plot
  campaign list quantities                   everything a study can set

)";

// `campaign STUDY ...` means `campaign run STUDY ...`. Throws BadInput for a word that is neither command nor
// study.
std::vector<std::string> command_line(int argc, char** argv, const CLI::App& program) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) return words;
  const std::string& first = words.front();
  for (const std::string_view own : {"-h", "--help", "--version"})
    if (first == own) return words;
  std::vector<std::string_view> commands;
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  commands.assign(names.begin(), names.end());
  if (std::find(commands.begin(), commands.end(), first) != commands.end()) return words;
  std::error_code ignored;
  if (first.starts_with('-') || first.ends_with(".toml") ||
      std::filesystem::is_regular_file(first, ignored)) {
    words.insert(words.begin(), "run");
    return words;
  }
  const std::string study = first + ".toml";
  const std::string_view near = std::filesystem::is_regular_file(study, ignored)
                                    ? std::string_view(study)
                                    : parameters::nearest_name(first, commands);
  throw cli::BadInput(fmt::format("'{}' is neither a command nor a study file (NAME.toml){}", first,
                                  near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

int run_program(int argc, char** argv) {
  CLI::App program("Uncertainty and sensitivity of simulated cone penetration tests", "campaign");
  program.set_version_flag("--version", cli::version());
  program.footer(std::string(examples) + cli::exit_code_help);
  program.require_subcommand(1);
  cli::Action action;
  for (const auto add :
       {cli::add_run,       cli::add_rerun,       cli::add_query,     cli::add_compare,   cli::add_combine,
        cli::add_emulate,   cli::add_predict,     cli::add_export,    cli::add_import,    cli::add_report,
        cli::add_prune,     cli::add_push,        cli::add_view,      cli::add_paper,     cli::add_numerics,
        cli::add_diagnose,  cli::add_calibration, cli::add_conceal,   cli::add_reveal,    cli::add_element,
        cli::add_recording, cli::add_list,        cli::add_reference, cli::add_completion})
    add(program, action);

  std::vector<std::string> words = command_line(argc, argv, program);
  if (words.empty()) words.emplace_back("--help");
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());  // as CLI11 takes a vector
    program.parse(reversed);
  } catch (const CLI::ParseError& end) {
    // --help and --version end here too, with code 0. Of several MPI ranks only the first speaks.
    std::ostringstream out, err;
    program.exit(end, out, err);
    if (campaign::rank_from_environment() == 0) {
      fmt::print("{}", out.str());
      fmt::print(stderr, "{}", err.str());
      if (const std::string hint = cli::misspelt_hint(program, words, end);
          end.get_exit_code() != 0 && !hint.empty())
        fmt::print(stderr, "{}\n", hint);
    }
    return end.get_exit_code() == 0 ? cli::all_well : cli::bad_input;
  }
  return action();
}

int complain(std::string_view message, int code) {
  if (campaign::rank_from_environment() == 0) fmt::print(stderr, "{}\n", message);
  return code;
}

int unless_stopped(int code) {
  const int signal = campaign::StopSignals::received();
  return signal == 0 ? code : cli::stopped_by_signal + signal;
}

// A reader, or a campaign at its start, waits for a database that another program keeps locked, and says so.
bool wait_for_database(const std::filesystem::path& database, double seconds) {
  constexpr double longest = 600.0, silent = 2.0;  // [s]
  static bool told = false;
  if (seconds > silent && !std::exchange(told, true) && campaign::rank_from_environment() == 0)
    fmt::print(stderr, "{}: {} keeps the database locked; waiting until it is free\n", database.string(),
               results::who_keeps(database));
  return seconds < longest && campaign::StopSignals::received() == 0;
}

// What the command came to; whatever it throws is told.
int outcome(int argc, char** argv) {
  const results::Patience patience(wait_for_database);
  try {
    return run_program(argc, argv);
  } catch (const cli::BadInput& problem) {
    return complain(problem.what(), cli::bad_input);
  } catch (const results::BadQuery& problem) {
    return complain(problem.what(), cli::bad_input);
  } catch (const results::Locked& problem) {
    return complain(problem.what(), cli::database_in_use);
  } catch (const results::Busy& problem) {
    return complain(problem.what(), unless_stopped(cli::unusable_file));
  } catch (const results::Interrupted& problem) {
    return complain(problem.what(), unless_stopped(cli::unusable_file));
  } catch (const results::Error& problem) {
    return complain(problem.what(), cli::unusable_file);
  } catch (const std::filesystem::filesystem_error& problem) {
    return complain(results::refusal(problem.path1(), "cannot be used", problem.code()), cli::unusable_file);
  } catch (const std::ios_base::failure& problem) {
    return complain(fmt::format("a file cannot be read: {}", problem.what()), cli::unusable_file);
  } catch (const std::exception& problem) {
    return complain(fmt::format("internal error: {}", problem.what()), cli::internal_error);
  }
}

}  // namespace

int main(int argc, char** argv) {
  campaign::open_output();
  // The process of one realization; started by the campaign only.
  if (argc == 2 && std::string_view(argv[1]) == "realize")
    return campaign::serve_realization(solver::simulate);
  return campaign::close_output(outcome(argc, argv), cli::unusable_file);
}

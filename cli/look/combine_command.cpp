// campaign combine DEAR CHEAP
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "cli/command.hpp"
#include "cli/common/format_option.hpp"
#include "cli/common/ledger_argument.hpp"
#include "cli/exit_codes.hpp"
#include "results/statistics/two_fidelities.hpp"

namespace cpt::cli {
namespace {

struct CombineArguments {
  std::filesystem::path dear, cheap;
  int emulated = 0;
  results::Format format = results::Format::table;
};

void print_how_they_go_along(const results::TwoFidelities& both) {
  for (const results::FidelityLevel* level : {&both.dear, &both.cheap})
    fmt::print("{} (preset {}): {} runs of {:.3g} s, {:.3g} h in all\n", level->name, level->preset,
               level->runs, level->seconds_a_run, level->runs * level->seconds_a_run / 3600.0);
  for (const results::FidelityWindow& window : both.windows)
    fmt::print(
        "{}: correlation {:.4f} over {} paired runs; with {:.3g} cheap runs for each dear one a mean has "
        "{:.3g} "
        "of the variance that the same time buys with dear runs alone\n",
        window.window, window.correlation, window.paired, window.best_run_ratio, window.variance_ratio);
  for (const results::FidelityWindow& window : both.windows)
    if (std::isfinite(window.emulator_correlation))
      fmt::print(
          "{}: an emulator of the cheap runs as a third level, asked at {} runs: Q2 {:.4f}, correlation with "
          "the dear "
          "runs {:.4f}, at runs held out\n",
          window.window, both.emulated_runs, window.emulator_q2, window.emulator_correlation);
  fmt::print("\n");
}

int combine(const CombineArguments& arguments) {
  const results::TwoFidelities both =
      results::two_fidelities(results::read_snapshot(open_ledger(arguments.dear)),
                              results::read_snapshot(open_ledger(arguments.cheap)), arguments.emulated);
  if (arguments.format == results::Format::table) print_how_they_go_along(both);
  fmt::print("{}", results::format(results::fidelity_table(both), arguments.format));
  for (const std::string& warning : both.warnings) fmt::print(stderr, "warning: {}\n", warning);
  return all_well;
}

}  // namespace

void add_combine(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<CombineArguments>();
  CLI::App* command = program.add_subcommand(
      "combine", "What q_c of a dear preset is worth, from few of its runs and many of a cheap one");
  command->add_option("DEAR", arguments->dear, "Study file or database: few runs of the better preset")
      ->type_name("")
      ->required();
  command->add_option("CHEAP", arguments->cheap, "The same propagation at a cheaper preset, with more runs")
      ->type_name("")
      ->required();
  command
      ->add_option("--emulated", arguments->emulated,
                   "Third level: an emulator of the cheap runs, asked at the design's first N runs")
      ->type_name("N")
      ->check(CLI::Range(100, 100000).description("100 to 100000"));
  add_format_option(*command, arguments->format);
  command->footer(
      R"(Both studies have a [design] with kind = "propagation" and the same rows, distributions, correlations, seed and
sampling, so that their first runs have the same inputs; only preset and runs differ. The table has each number from the
dear runs alone and from both, with 95 % intervals, and how wide the second interval is over the first (width_ratio).

The emulator (--emulated) is a sparse polynomial of each window's average; what it says of a run it was made without. Where its Q2
is below 0.9 it is left out, with a warning.

Examples:
  campaign paper.toml && campaign quick.toml
  campaign combine paper.toml quick.toml
  campaign combine paper.toml quick.toml --emulated 20000)");
  command->callback([arguments, &action] { action = [arguments] { return combine(*arguments); }; });
}

}  // namespace cpt::cli

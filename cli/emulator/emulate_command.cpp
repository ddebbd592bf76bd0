// campaign emulate STUDY
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <system_error>

#include "cli/command.hpp"
#include "cli/common/cells.hpp"
#include "cli/common/format_option.hpp"
#include "cli/emulator/emulator_argument.hpp"
#include "cli/emulator/next_points.hpp"
#include "cli/exit_codes.hpp"
#include "results/emulator/emulator_file.hpp"

namespace cpt::cli {
namespace {

struct EmulateArguments {
  std::filesystem::path study;
  int next = 0;
  results::Format format = results::Format::table;
};

results::Table told(const results::Emulator& emulator) {
  results::Table table{{"output", "runs", "scale", "components", "Q2", "rmse", "unit", "coverage_95",
                        "coverage_lower", "coverage_upper", "verdict"},
                       {}};
  for (const results::EmulatedOutput& output : emulator.outputs) {
    const results::Validation& v = output.validation;
    table.rows.push_back(
        {output.name, whole(v.runs), std::string(output.emulator.logarithmic() ? "logarithm" : "linear"),
         whole(output.emulator.processes().size()), v.q2, v.rmse, output.unit, v.coverage, v.coverage_lower,
         v.coverage_upper, std::string(v.refused() ? "refused" : "accepted")});
  }
  return table;
}

int emulate(const EmulateArguments& arguments) {
  const StudyFile study = read_study_file(arguments.study);
  const results::Emulator emulator = emulator_of(arguments.study, study, arguments.next > 0);
  if (arguments.next > 0) {
    fmt::print("{}", next_points(study.study, emulator, arguments.next));
    return all_well;
  }
  fmt::print("{}", results::format(told(emulator), arguments.format));
  bool refused = false;
  for (const results::EmulatedOutput& output : emulator.outputs)
    if (const std::string why = refusal_of(output); !why.empty()) {
      refused = true;
      fmt::print(stderr, "refused: {}: {}; it is not predicted\n", output.name, why);
    }
  if (!refused) return all_well;
  fmt::print(stderr, "more runs may mend it: campaign emulate {} --next 10 >> {}\n", arguments.study.string(),
             arguments.study.string());
  return emulator_refused;
}

}  // namespace

void add_emulate(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<EmulateArguments>();
  CLI::App* command = program.add_subcommand(
      "emulate", "Make an emulator of a study's averages and curves from its runs, and say how good it is");
  command->add_option("STUDY", arguments->study, "Study file")->type_name("")->required();
  command
      ->add_option("--next", arguments->next,
                   "Print the N points where it knows least, as [[points]] to append to the study")
      ->type_name("N")
      ->check(CLI::Range(1, 1000).description("1 to 1000"));
  add_format_option(*command, arguments->format);
  command->footer(
      R"(Learns from the completed runs that vary inputs together: the study's [design], its [[points]], bounds. The
emulator is stored as NAME-emulator.h5 beside the database and campaign predict evaluates it. The table has for each
average (WINDOW.q_c_mean_kPa) and each curve (q_c_kPa), of an external program each result and curve,
  Q2           share of the variance that is predicted at runs held out (10 folds, fitted anew without them)
  rmse, unit   root of the mean squared error there
  coverage_95  share of their values within the 95 % intervals, with its own interval
Outputs with Q2 < 0.9 are refused: they are not predicted, and the exit code is 7.

Examples:
  campaign emulate clay.toml
  campaign emulate clay.toml --next 10 >> clay.toml)");
  command->callback([arguments, &action] { action = [arguments] { return emulate(*arguments); }; });
}

}  // namespace cpt::cli

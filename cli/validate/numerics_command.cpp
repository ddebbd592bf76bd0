// campaign numerics STUDY|DB ...
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "cli/command.hpp"
#include "cli/common/ledger_argument.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "validation/numerics/write_numerics.hpp"

namespace cpt::cli {
namespace {

struct NumericsArguments {
  std::vector<std::filesystem::path> sources;
  std::filesystem::path out = "docs/numerical-uncertainty.md";
};

int numerics(const NumericsArguments& arguments) {
  std::vector<validation::numerics::NumericsStudy> studies;
  for (const std::filesystem::path& source : arguments.sources)
    studies.push_back(validation::numerics::read_numerics(results::read_snapshot(open_ledger(source)),
                                                          database_of(source)));
  for (const auto& file : validation::numerics::write_numerics(studies, arguments.out))
    fmt::print("{}\n", file.string());
  return all_well;
}

}  // namespace

void add_numerics(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<NumericsArguments>();
  CLI::App* command = program.add_subcommand(
      "numerics",
      "What mesh, material points, time step, mass scaling and speed do to q_c, beside the repeats' noise");
  command->add_option("STUDY|DB", arguments->sources, "Study files or databases")
      ->type_name("...")
      ->required();
  command
      ->add_option("--out", arguments->out, "Page to write; figures go to the folder of its name beside it")
      ->type_name("FILE.md")
      ->capture_default_str();
  command->footer(
      R"(A study of the numerics is any study with rows or points that change one quantity of the group numerics, or the
speed of the push; points that change numerics.point_shift are its repeats. Others stand in the table of presets.
Works at any time, also while campaigns run.

Example:
  campaign numerics examples/numerics/*.toml --out numerics.md)");
  command->callback([arguments, &action] { action = [arguments] { return numerics(*arguments); }; });
}

}  // namespace cpt::cli

// campaign paper FOLDER
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/exit_codes.hpp"
#include "validation/paper/write_paper.hpp"

namespace cpt::cli {
namespace {

struct PaperArguments {
  std::filesystem::path folder, beside;
  std::filesystem::path out = "docs/paper.md";
  std::filesystem::path causes;
};

using namespace validation::paper;

std::vector<Cause> causes_of(const PaperArguments& arguments) {
  if (!arguments.causes.empty()) return read_causes(arguments.causes);
  const std::filesystem::path usual = "docs/paper-causes.toml";
  return std::filesystem::exists(usual) ? read_causes(usual) : std::vector<Cause>{};
}

int paper(const PaperArguments& arguments) {
  const Runs runs = read_runs(arguments.folder);
  const Runs beside = arguments.beside.empty() ? Runs{} : read_runs(arguments.beside);
  const auto files =
      write_paper(runs, causes_of(arguments), arguments.out, arguments.beside.empty() ? nullptr : &beside);
  fmt::print("{} and {} figure files in {}\n", files.front().string(), files.size() - 1,
             (arguments.out.parent_path() / arguments.out.stem()).string());
  return all_well;
}

}  // namespace

void add_paper(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<PaperArguments>();
  CLI::App* command = program.add_subcommand(
      "paper", "Hold the campaigns of examples/paper against the results of Yost et al. (2023)");
  command->add_option("FOLDER", arguments->folder, "Where their databases are")->type_name("")->required();
  command
      ->add_option("--out", arguments->out, "Page to write; figures go to the folder of its name beside it")
      ->type_name("FILE.md")
      ->capture_default_str();
  command
      ->add_option("--causes", arguments->causes,
                   "What was found to cause the differences, by row [docs/paper-causes.toml if it is there]")
      ->type_name("FILE.toml");
  command
      ->add_option("--beside", arguments->beside,
                   "Folder of the same studies run otherwise, coarser for instance: columns of their own")
      ->type_name("FOLDER");
  command->footer(R"(Works at any time: what has not been run is told as such.

Examples:
  scripts/reproduce-paper                      runs all studies and writes docs/paper.md
  campaign paper examples/paper --out now.md   how far they are)");
  command->callback([arguments, &action] { action = [arguments] { return paper(*arguments); }; });
}

}  // namespace cpt::cli

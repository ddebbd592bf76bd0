// campaign report STUDY|DB
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/exit_codes.hpp"
#include "cli/study_argument.hpp"
#include "reports/report.hpp"
#include "results/snapshot.hpp"

namespace cpt::cli {
namespace {

struct Arguments {
  std::filesystem::path source;
  std::filesystem::path directory;
};

// NAME-report beside the database NAME.sqlite, or what the study says.
std::filesystem::path report_directory(const Arguments& arguments) {
  if (!arguments.directory.empty()) return arguments.directory;
  if (arguments.source.extension() == ".toml") return read_study_file(arguments.source).study.report_dir;
  return arguments.source.parent_path() / (arguments.source.stem().string() + "-report");
}

int report(const Arguments& arguments) {
  const results::Snapshot campaign = results::read_snapshot(database_of(arguments.source));
  for (const auto& file : reports::write_report(campaign, report_directory(arguments)))
    fmt::print("{}\n", file.string());
  return all_well;
}

}  // namespace

void add_report(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "report", "Write figures and tables: tornado, sensitivity indices, q_c profiles, baseline and windows");
  command->add_option("STUDY|DB", arguments->source, "Study file or database")->type_name("")->required();
  command->add_option("--directory", arguments->directory, "Where to [NAME-report beside the study]");
  command->footer(
      "Works at any time, also while the campaign runs. Prints the files written, index.html first.");
  command->callback([arguments, &action] { action = [arguments] { return report(*arguments); }; });
}

}  // namespace cpt::cli

// campaign export STUDY|DB
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/common/ledger_argument.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "results/files/atomic_file.hpp"
#include "results/ledger/schema.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/tables/campaign_tables.hpp"
#include "results/tables/json_document.hpp"
#include "results/tables/samples.hpp"

namespace cpt::cli {
namespace {

struct ExportArguments {
  std::filesystem::path source, to;
  std::string format = "csv";
};

void write_text(const std::filesystem::path& file, const std::string& text) {
  results::write_atomically(file, text, "");
  fmt::print("{}\n", file.string());
}

void write_folder(const std::filesystem::path& folder, const std::vector<results::NamedTable>& tables) {
  results::make_folder(folder);
  for (const auto& [name, table] : tables)
    write_text(folder / (name + ".csv"), results::format(table, results::Format::csv));
}

// NAME-export, NAME.json or NAME.dat beside the database, if not said.
std::filesystem::path target_of(const ExportArguments& arguments, const std::filesystem::path& database) {
  std::error_code ignored;
  for (const std::filesystem::path& source : {arguments.source, database})
    if (std::filesystem::equivalent(arguments.to, source, ignored))
      throw BadInput(fmt::format("--to {}: would overwrite what is exported", arguments.to.string()));
  if (!arguments.to.empty()) return arguments.to;
  const std::string ending = arguments.format == "csv"    ? "-export"
                             : arguments.format == "json" ? ".json"
                                                          : ".dat";
  return database.parent_path() / (database.stem().string() + ending);
}

int export_campaign(const ExportArguments& arguments) {
  const std::filesystem::path database = database_of(arguments.source);
  const std::filesystem::path to = target_of(arguments, database);
  const results::LedgerView ledger = open_ledger(arguments.source);
  if (arguments.format == "csv")
    write_folder(to, results::campaign_tables(ledger.database));
  else if (arguments.format == "json")
    write_text(to, results::json_document("campaign export", results::schema_version,
                                          results::campaign_tables(ledger.database)));
  else
    write_text(to, results::dakota_table(results::read_snapshot(ledger)));
  return all_well;
}

}  // namespace

void add_export(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = program.add_subcommand(
      "export", "Write all that a campaign's database holds as tables for other programs");
  command->add_option("STUDY|DB", arguments->source, "Study file or database")->type_name("")->required();
  command
      ->add_option("--format", arguments->format,
                   "csv (a folder of tables), json (one document) or dakota (one table) [csv]")
      ->type_name("")
      ->check(CLI::IsMember({"csv", "json", "dakota"}).description(""));
  command
      ->add_option(
          "--to", arguments->to,
          "Folder of the CSV tables, or file [NAME-export, NAME.json or NAME.dat beside the database]")
      ->type_name("PATH");
  command->footer(
      R"(The tables are those of docs/schema.md. samples.csv is the one to begin with: a row a realization, failed ones
too, a column for each input that varies and for each average of q_c. curve.csv has all depths. --format dakota
is samples in Dakota's annotated tabular format, NaN for what failed. Numbers read back to the same bits.
Works at any time, also while the campaign runs. To hand a whole campaign on, copy its database: it is one file.

Examples:
  campaign export sens.toml
  campaign export sens.sqlite --format json --to sens.json
  campaign export sens.toml --format dakota)");
  command->callback([arguments, &action] { action = [arguments] { return export_campaign(*arguments); }; });
}

}  // namespace cpt::cli

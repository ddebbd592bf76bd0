// campaign import SOURCE --to NEW
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exchange/read_table.hpp"
#include "cli/exit_codes.hpp"
#include "parameters/read_samples.hpp"
#include "parameters/read_study.hpp"
#include "results/files/atomic_file.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/tables/import_results.hpp"

namespace cpt::cli {
namespace {

struct ImportArguments {
  std::filesystem::path source, study, to;
  std::vector<std::string> columns;  // KEY=NAME
  std::vector<std::string> ignored;
};

parameters::SampleColumns columns_of(const ImportArguments& arguments) {
  parameters::SampleColumns columns;
  for (const std::string& entry : arguments.columns) {
    const auto equals = entry.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == entry.size())
      throw BadInput(fmt::format("--column {}: must be KEY=NAME, e.g. sand.H=x1", entry));
    columns.names.push_back({entry.substr(0, equals), entry.substr(equals + 1)});
  }
  columns.ignored = arguments.ignored;
  columns.responses = arguments.to.extension() != ".toml";
  return columns;
}

template <class T>
T sound(std::variant<T, std::vector<parameters::StudyError>> read) {
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&read))
    throw BadInput(parameters::format(*errors));
  return std::get<T>(std::move(read));
}

void tell(const results::Remarks& remarks, const std::filesystem::path& database) {
  const results::Snapshot campaign = results::read_snapshot(database);
  std::size_t completed = 0, failed = 0;
  for (const results::RealizationRow& run : campaign.realizations) {
    completed += run.completed();
    failed += run.failed();
  }
  fmt::print("{}: {} realizations, {} completed, {} failed\n", database.string(),
             campaign.realizations.size(), completed, failed);
  for (const std::string& remark : remarks) fmt::print("{}\n", remark);
}

// A study that also runs the samples.
int make_study(const ImportArguments& arguments, const StudyFile& study,
               const std::vector<parameters::Sample>& samples) {
  const std::vector<parameters::Sample> points = parameters::new_samples(study.study, samples);
  const std::string text = parameters::with_points(study.text, points);
  (void)sound(parameters::parse_study(text, arguments.to));
  results::write_atomically(arguments.to, text, "");
  fmt::print("{}: {} new points; {} of the {} rows are realizations of the study already\n",
             arguments.to.string(), points.size(), samples.size() - points.size(), samples.size());
  return all_well;
}

int import_table(const ImportArguments& arguments) {
  if (arguments.study.empty())
    throw BadInput(
        fmt::format("{}: a table needs --study STUDY, which says what its inputs start from and in which "
                    "windows q_c is averaged",
                    arguments.source.string()));
  const StudyFile study = read_study_file(arguments.study);
  const TableFile read = read_table(arguments.source);
  const auto samples = sound(parameters::read_samples(read.table, study.study, columns_of(arguments)));
  if (arguments.to.extension() == ".toml") return make_study(arguments, study, samples);
  tell(results::import_samples(study.study, study.text, samples, read.file, arguments.to), arguments.to);
  return all_well;
}

int import(const ImportArguments& arguments) {
  std::error_code ignored;
  if (std::filesystem::exists(arguments.to, ignored))
    throw BadInput(fmt::format("--to {}: exists; name a new file", arguments.to.string()));
  if (std::filesystem::is_directory(arguments.source, ignored) || arguments.source.extension() == ".json")
    throw BadInput(
        fmt::format("{}: an export is not read back; copy its database, NAME.sqlite, which has all of it",
                    arguments.source.string()));
  const std::string ending = arguments.to.extension();
  if (ending != ".sqlite" && ending != ".toml")
    throw BadInput(fmt::format("--to {}: must end in .sqlite (results) or .toml (points to run)",
                               arguments.to.string()));
  return import_table(arguments);
}

}  // namespace

void add_import(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<ImportArguments>();
  CLI::App* command = program.add_subcommand(
      "import", "Make a database of results from elsewhere, or a study of points to run");
  command
      ->add_option("SOURCE", arguments->source,
                   "Table of inputs, and of results if it has them: CSV, or Dakota's tabular format")
      ->type_name("")
      ->required();
  command
      ->add_option("--to", arguments->to,
                   "New file: NAME.sqlite for results, NAME.toml for the study with a point for each row")
      ->type_name("FILE")
      ->required();
  command->add_option("--study", arguments->study, "Study that the table's rows are samples of")
      ->type_name("STUDY");
  command->add_option("--column", arguments->columns, "What a column is, e.g. sand.H=x1; may be repeated")
      ->type_name("KEY=NAME")
      ->allow_extra_args(false);
  command->add_option("--ignore", arguments->ignored, "A column that is not read; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->footer(
      R"(A table has a row a sample and a column for each input (campaign list
quantities) and for each average of q_c (WINDOW.q_c_mean_kPa, if known also .q_c_min_kPa and .q_c_max_kPa, for the
study's windows), and may have name, status and reason. Inputs without a column are the study's baseline. Rows
without an average failed.

The database says which file it was made from, with its SHA-256. query, report and compare read it; no campaign
goes on with it, for only this program's own runs promise the same bits.

Examples:
  campaign import other-code.csv --study sens.toml --to other-code.sqlite
  campaign import dakota.dat --study sens.toml --column sand.H=x1 --column deep.q_c_mean_kPa=y1 --to dakota.sqlite
  campaign import samples.csv --study sens.toml --to more.toml)");
  command->callback([arguments, &action] { action = [arguments] { return import(*arguments); }; });
}

}  // namespace cpt::cli

#include "cli/exchange/read_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/common/input_kind.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exchange/export_format.hpp"
#include "parameters/nearest_name.hpp"
#include "parameters/written_number.hpp"
#include "recordings/delimited.hpp"
#include "results/ledger/provenance.hpp"
#include "results/ledger/schema.hpp"
#include "results/tables/campaign_tables.hpp"
#include "results/tables/json_document.hpp"
#include "solver/quantities.hpp"

namespace cpt::cli {
namespace {

// Without the folders above: they may name a machine or a user.
std::string name_of(const std::filesystem::path& file, bool with_folder) {
  if (!with_folder) return file.filename().string();
  return (std::filesystem::absolute(file).lexically_normal().parent_path().filename() / file.filename())
      .string();
}

parameters::FieldTable parsed(const std::string& bytes, const std::filesystem::path& file) {
  const recordings::Decoded content = recordings::decoded(bytes);
  if (const auto& problem = content.problem)
    throw BadInput(recordings::format(
        {{file.string(), problem->line, problem->column, problem->found, problem->expected, problem->hint}}));
  recordings::Problems problems(file.string());
  recordings::DelimitedTable read = recordings::read_delimited(content.text, problems);
  if (problems.any()) throw BadInput(recordings::format(problems.errors()));
  const auto fields = [](std::vector<recordings::PlacedText>& texts) {
    std::vector<parameters::Field> moved;
    moved.reserve(texts.size());
    for (recordings::PlacedText& text : texts)
      moved.push_back({std::move(text.text), {text.line, text.column}});
    return moved;
  };
  parameters::FieldTable table{file.string(), file.stem().string(), fields(read.names), {}};
  for (std::vector<recordings::PlacedText>& row : read.rows) table.rows.push_back(fields(row));
  return table;
}

void add_table(const std::filesystem::path& file, bool in_folder, TableFiles& found) {
  const std::string bytes = read_input(InputKind::table, file);
  found.tables.push_back(parsed(bytes, file));
  found.files.push_back({name_of(file, in_folder), results::sha256(bytes)});
}

// A table under a wrong name would be left out in silence.
void refuse_strangers(const std::filesystem::path& folder) {
  std::vector<std::string_view> known(results::derived_tables().begin(), results::derived_tables().end());
  for (const results::LedgerTable& table : results::ledger_tables()) known.push_back(table.name);
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".csv" || std::ranges::find(known, name) != known.end()) continue;
    const std::string_view near = parameters::nearest_name(name, known);
    throw BadInput(
        fmt::format("{}: is no table of an export{}", entry.path().string(),
                    near.empty() ? "; put it elsewhere" : fmt::format("; did you mean {}.csv?", near)));
  }
}

}  // namespace

bool is_export(const std::filesystem::path& source) {
  std::error_code ignored;
  return std::filesystem::is_directory(source, ignored) || source.extension() == ".json";
}

TableFiles read_export(const std::filesystem::path& source) {
  TableFiles found;
  std::error_code ignored;
  if (std::filesystem::is_directory(source, ignored)) {
    for (const results::LedgerTable& table : results::ledger_tables())
      if (const auto file = source / (table.name + ".csv"); std::filesystem::exists(file, ignored))
        add_table(file, true, found);
    if (found.tables.empty())
      throw BadInput(
          fmt::format("{}: holds none of the tables that campaign export writes", source.string()));
    refuse_strangers(source);
    return found;
  }
  const std::string bytes = read_input(InputKind::table, source);
  auto read = results::read_json_document(bytes, source.string(), export_format, results::schema_version);
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&read))
    throw BadInput(parameters::format(*errors));
  found.tables = std::get<std::vector<parameters::FieldTable>>(std::move(read));
  found.files = {{name_of(source, false), results::sha256(bytes)}};
  return found;
}

TableFiles read_table(const std::filesystem::path& file) {
  TableFiles found;
  add_table(file, false, found);
  return found;
}

}  // namespace cpt::cli

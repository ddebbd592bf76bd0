#include "cli/common/study_argument.hpp"

#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <vector>

#include "campaign/external/program_version.hpp"
#include "cli/common/input_kind.hpp"
#include "cli/exchange/read_table.hpp"
#include "parameters/all_realizations.hpp"
#include "parameters/fields.hpp"
#include "parameters/read_study.hpp"
#include "parameters/study_data.hpp"

namespace cpt::cli {
namespace {

// Whatever it is called. A pipe is read once, by who wants it.
bool starts_as_database(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  std::string start(16, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start.starts_with("SQLite format 3");
}

// The columns of CSV files that the study's distributions are made of.
std::string data_of(const std::string& study_text, const std::filesystem::path& file) {
  std::string sections;
  parameters::ErrorList errors(file.string());
  for (const parameters::WantedFile& wanted : parameters::wanted_files(study_text)) try {
      sections +=
          parameters::data_section(read_table(file.parent_path() / wanted.file).table, wanted, errors);
    } catch (const BadInput& problem) {
      errors.add(wanted.place, "distribution.file", problem.what(), "paths start at the study's folder");
    }
  if (!errors.empty()) throw BadInput(parameters::format(errors.sorted()));
  return sections;
}

void find_version(parameters::Study& study, const std::filesystem::path& file) {
  if (study.version_command.empty()) return;
  solver::ExternalProgram program = *study.baseline.program;
  try {
    program.version = campaign::program_version(study.version_command, program.folder);
  } catch (const campaign::NoVersion& problem) {
    const std::vector<parameters::StudyError> errors = {
        {file.string(), 0, 0, "solver.version", problem.what(),
         "a command that prints the version, or the version itself as a text"}};
    throw BadInput(parameters::format(errors));
  }
  study.baseline.program = std::make_shared<const solver::ExternalProgram>(std::move(program));
}

}  // namespace

StudyFile read_study_file(const std::filesystem::path& file) {
  std::string text = read_input(InputKind::study, file);
  text += data_of(text, file);
  auto parsed = parameters::parse_study(text, file);
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed))
    throw BadInput(parameters::format(*errors));
  StudyFile read{std::get<parameters::Study>(std::move(parsed)), std::move(text)};
  find_version(read.study, file);
  return read;
}

void refuse_external(const parameters::Study& study, std::string_view command) {
  if (study.baseline.program != nullptr)
    throw BadInput(
        fmt::format("{}: its solver is another program ([solver]), and {} is about pushes of the embedded "
                    "one; run, query, report, export, import and rerun take it",
                    study.file.string(), command));
}

parameters::Realization find_realization(const parameters::Study& study, int id) {
  const auto realizations = parameters::all_realizations(study);
  for (const parameters::Realization& realization : realizations)
    if (realization.id == id) return realization;
  throw BadInput(
      fmt::format("{} has no realization {}; it has 1 to {}", study.name, id, realizations.size()));
}

bool names_study(const std::filesystem::path& study_or_database) {
  return study_or_database.extension() == ".toml" && !starts_as_database(study_or_database);
}

std::filesystem::path database_of(const std::filesystem::path& study_or_database) {
  return names_study(study_or_database) ? read_study_file(study_or_database).study.database
                                        : study_or_database;
}

}  // namespace cpt::cli

#include "cli/common/study_argument.hpp"

#include <fmt/format.h>

#include <fstream>

#include "cli/common/input_kind.hpp"
#include "parameters/all_realizations.hpp"
#include "parameters/read_study.hpp"

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

}  // namespace

StudyFile read_study_file(const std::filesystem::path& file) {
  std::string text = read_input(InputKind::study, file);
  auto parsed = parameters::parse_study(text, file);
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed))
    throw BadInput(parameters::format(*errors));
  return {std::get<parameters::Study>(std::move(parsed)), std::move(text)};
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

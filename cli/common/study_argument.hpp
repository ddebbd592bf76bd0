// The STUDY, STUDY|DB and ID arguments that most commands take.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "parameters/realization.hpp"
#include "parameters/study.hpp"

namespace cpt::cli {

/// The command line asks for something that cannot be; `what()` is the whole message. Ends with exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A study and the text it was read from, with the data that it takes from other files (section [data]).
struct StudyFile {
  parameters::Study study;
  std::string text;
};

/// Throws BadInput with all of the study's errors. An external program is asked for its version, where the
/// study says how.
[[nodiscard]] StudyFile read_study_file(const std::filesystem::path& file);
/// Throws BadInput where an external program is the study's solver: the command needs a push.
void refuse_external(const parameters::Study& study, std::string_view command);

/// Realization of the study by its id; throws BadInput if there is none.
[[nodiscard]] parameters::Realization find_realization(const parameters::Study& study, int id);

/// Whether a STUDY|DB argument is a study: called .toml, and no database in spite of it.
[[nodiscard]] bool names_study(const std::filesystem::path& study_or_database);

/// A campaign's database, found from the study (NAME.toml) or given itself.
[[nodiscard]] std::filesystem::path database_of(const std::filesystem::path& study_or_database);

}  // namespace cpt::cli

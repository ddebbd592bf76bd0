// Results that were made elsewhere, or exported before, become a campaign's database.
//
// Such a database says in its table `import` which files it was made from. It can be asked, reported and
// compared like any other, but no campaign goes on with it and no diagnosis takes its realizations over: only
// this program's own runs promise the same bits (ledger.hpp).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "parameters/field_table.hpp"
#include "parameters/read_samples.hpp"
#include "parameters/study.hpp"
#include "parameters/study_error.hpp"
#include "results/files/error.hpp"

namespace cpt::results {

/// A file that was read.
struct ImportedFile {
  std::string name;
  std::string sha256;
};

/// What the user should know of an import, in sentences; or all that is wrong, and then nothing is written.
using Remarks = std::vector<std::string>;
using RemarksOrErrors = std::variant<Remarks, std::vector<parameters::StudyError>>;

/// Makes `database` from the tables of an export (campaign_tables.hpp); those that follow from others
/// (samples, audit, sensitivity, tornado, effects, repeat_noise) are not read, and averages are computed anew
/// where there is a curve. What was exported with a checksum must still match it. Throws Error if the
/// database exists or cannot be written; it is there whole or not at all.
[[nodiscard]] RemarksOrErrors import_tables(std::span<const parameters::FieldTable> tables,
                                            std::span<const ImportedFile> files,
                                            const std::filesystem::path& database);

/// Makes `database` from samples of a study. A sample whose inputs are those of one of the study's
/// realizations stands for it; others, and a second one of equal inputs, become points of their names; what
/// the samples lack stays pending. They have no settings hash and no solver version. Throws as import_tables.
Remarks import_samples(const parameters::Study& study, const std::string& study_text,
                       std::span<const parameters::Sample> samples, const ImportedFile& file,
                       const std::filesystem::path& database);

}  // namespace cpt::results

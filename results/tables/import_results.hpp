// Results that were made elsewhere become a campaign's database.
//
// Such a database says in its table `import` which files it was made from. It can be asked, reported and
// compared like any other, but no campaign goes on with it and no diagnosis takes its realizations over: only
// this program's own runs promise the same bits (ledger.hpp).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "parameters/read_samples.hpp"
#include "parameters/study.hpp"
#include "results/files/error.hpp"

namespace cpt::results {

/// A file that was read.
struct ImportedFile {
  std::string name;
  std::string sha256;
};

/// What the user should know of an import, in sentences.
using Remarks = std::vector<std::string>;

/// Makes `database` from samples of a study. A sample whose inputs are those of one of the study's
/// realizations stands for it; others, and a second one of equal inputs, become points of their names; what
/// the samples lack stays pending. They have no settings hash and no solver version. Throws Error if the
/// database exists or cannot be written; it is there whole or not at all.
Remarks import_samples(const parameters::Study& study, const std::string& study_text,
                       std::span<const parameters::Sample> samples, const ImportedFile& file,
                       const std::filesystem::path& database);

}  // namespace cpt::results

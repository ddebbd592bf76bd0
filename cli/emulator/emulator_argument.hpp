// The STUDY|EMULATOR.h5 argument: an emulator that is as good as its ledger.
#pragma once

#include <filesystem>

#include "cli/common/study_argument.hpp"
#include "results/emulator/training.hpp"

namespace cpt::cli {

/// What the study's ledger now holds for an emulator. What sets study and ledger apart, and which runs are
/// left out, is said on stderr.
[[nodiscard]] results::TrainingRuns training_runs(const std::filesystem::path& source,
                                                  const StudyFile& study);

/// The stored emulator of a study where that will do and is as good as the ledger, else a new one, which is
/// stored. Throws results::Error where there is nothing to make one of.
[[nodiscard]] results::Emulator emulator_of(const std::filesystem::path& source, const StudyFile& study,
                                            bool stored_will_do);

/// The emulator of a study, read from NAME-emulator.h5, or of the file itself, as it is stored. Throws
/// results::Error where the study's ledger holds something else than it was made from.
[[nodiscard]] results::Emulator read_emulator_of(const std::filesystem::path& study_or_emulator);

}  // namespace cpt::cli

#include "cli/emulator/emulator_argument.hpp"

#include <fmt/format.h>

#include <system_error>

#include "cli/common/ledger_argument.hpp"
#include "results/emulator/emulator_file.hpp"

namespace cpt::cli {

results::TrainingRuns training_runs(const std::filesystem::path& source, const StudyFile& study) {
  const results::Snapshot campaign = results::read_snapshot(open_ledger(source));
  results::TrainingRuns runs = results::training_runs(study.study, campaign);
  for (const std::string& note : runs.notes) fmt::print(stderr, "note: {}\n", note);
  return runs;
}

results::Emulator emulator_of(const std::filesystem::path& source, const StudyFile& study,
                              bool stored_will_do) {
  const std::filesystem::path file = results::emulator_file_of(study.study.database);
  const results::TrainingRuns runs = training_runs(source, study);
  std::error_code ignored;
  if (stored_will_do && std::filesystem::exists(file, ignored)) {
    results::Emulator stored = results::read_emulator(file);
    if (results::stale(stored, runs).empty()) return stored;
  }
  std::vector<std::string> notes;
  results::Emulator emulator = results::make_emulator(runs, notes);
  for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", note);
  if (emulator.outputs.empty())
    throw results::Error(fmt::format("{}: no output of its runs can be emulated", emulator.study));
  results::write_emulator(file, emulator);
  fmt::print(stderr, "{}: {} runs of {} inputs\n", file.string(), emulator.runs.size(),
             emulator.inputs.size());
  return emulator;
}

results::Emulator read_emulator_of(const std::filesystem::path& source) {
  if (source.extension() == ".h5") return results::read_emulator(source);
  if (!names_study(source))
    throw BadInput(fmt::format("{}: is neither a study (NAME.toml) nor an emulator (NAME-emulator.h5)",
                               source.string()));
  const StudyFile study = read_study_file(source);
  const std::filesystem::path file = results::emulator_file_of(study.study.database);
  results::Emulator emulator = results::read_emulator(file);
  const auto differences = results::stale(emulator, training_runs(source, study));
  if (!differences.empty())
    throw results::Error(fmt::format("{}: is stale: {}; campaign emulate {} makes it anew", file.string(),
                                     fmt::join(differences, "; "), source.string()));
  return emulator;
}

}  // namespace cpt::cli

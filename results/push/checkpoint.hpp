// Checkpoints: the states of unfinished pushes on disk, so that a stopped campaign goes on where it was.
//
// Beside NAME.sqlite lies NAME.checkpoints/ with one HDF5 file a running realization, named after the hash of
// its settings. A file is written whole and sealed (hdf5_file.hpp), and taken for exactly the settings, the
// solver version and the instruction set it was made with; anything else would not end with the same bits. An
// external program has a folder of that name without ".h5" in place of the file, to keep there what it wants.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "results/files/error.hpp"
#include "solver/push_state.hpp"
#include "solver/setup.hpp"

namespace cpt::results {

/// Throws Error, naming the file and why, if it cannot be written.
void write_checkpoint(const std::filesystem::path& file, const solver::Setup& setup,
                      const solver::PushState& state);

/// nullopt if there is no such file. Throws Error, naming the file and why, if it is damaged or was made with
/// other settings, by another solver version or on another instruction set.
[[nodiscard]] std::optional<solver::PushState> read_checkpoint(const std::filesystem::path& file,
                                                               const solver::Setup& setup);

/// The checkpoints of one campaign.
class CheckpointFolder {
 public:
  /// Makes the folder of this database, and removes from it all checkpoints but those with these settings
  /// hashes. Throws Error if the folder cannot be made.
  CheckpointFolder(const std::filesystem::path& database, const std::set<std::string>& unfinished);
  /// Removes the folder if no checkpoint is left.
  ~CheckpointFolder();
  CheckpointFolder(const CheckpointFolder&) = delete;
  CheckpointFolder& operator=(const CheckpointFolder&) = delete;

  /// Absolute path of the checkpoint of these settings, whether it exists or not.
  [[nodiscard]] std::filesystem::path file(const std::string& settings_hash) const;
  /// Removes the checkpoint of these settings, if there is one.
  void remove(const std::string& settings_hash) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace cpt::results

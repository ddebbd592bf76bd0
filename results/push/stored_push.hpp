// What `campaign push` left behind, read again: its histories and the fields at their depths.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/push/field_series.hpp"
#include "results/push/histories.hpp"

namespace cpt::results {

struct StoredField {
  double depth;                // [m] of the tip
  std::filesystem::path file;  ///< a .vtu
};

struct StoredPush {
  std::string name;              ///< of the files
  std::filesystem::path folder;  ///< of the push
  std::vector<StoredField> fields;
  Histories histories;

  /// An input as the setup's text has it (solver::canonical_text); throws Error if there is none.
  [[nodiscard]] std::string setting(const std::string& name) const;
  [[nodiscard]] bool has_setting(const std::string& name) const;
  /// The same as a number.
  [[nodiscard]] double number(const std::string& name) const;
};

/// Reads a push from its folder (FOLDER, which holds NAME-fields and NAME-histories.h5) or from one of its
/// series of fields (FOLDER/NAME-fields/NAME.pvd). Throws Error where nothing is stored, where the folder
/// holds several pushes, where the histories are missing or damaged.
[[nodiscard]] StoredPush read_stored_push(const std::filesystem::path& folder_or_series);

/// The points of one depth. Throws Error as read_vtu, and where the file is of another push.
[[nodiscard]] VtkPoints read_field(const StoredPush& push, const StoredField& field);

}  // namespace cpt::results

// Reads a measured sounding from a file of any known format: GEF-CPT, AGS4, Geotech .cpt, CSV.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "recordings/recording.hpp"
#include "recordings/recording_error.hpp"

namespace cpt::recordings {

/// Which column of a CSV file holds which quantity.
struct ColumnName {
  std::string quantity;  ///< with its unit: depth_m, q_c_MPa, ...; see csv.hpp
  std::string column;    ///< as the file's line of names has it
};
using ColumnMap = std::vector<ColumnName>;

struct ReadOptions {
  std::string format;         ///< its name; found from content and ending if not given
  ColumnMap columns;          ///< CSV only
  std::vector<double> voids;  ///< CSV only: values that mean "not measured", in the file's unit
  std::string push;           ///< AGS4 only: LOCA_ID or LOCA_ID/SCPG_TESN, where the file holds several
};

/// The sounding, or everything that is wrong with the file (never empty).
using RecordingOrErrors = std::variant<Recording, std::vector<RecordingError>>;

/// From a file's bytes; `file` names it in messages and its ending helps to find the format. Never throws for
/// what the bytes say.
[[nodiscard]] RecordingOrErrors parse_recording(std::string_view bytes, const std::filesystem::path& file,
                                                const ReadOptions& options = {});

}  // namespace cpt::recordings

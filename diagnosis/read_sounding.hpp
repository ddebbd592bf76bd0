// What every request says of a push: where it is recorded and the depths to compare.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "diagnosis/request.hpp"
#include "parameters/fields.hpp"

namespace cpt::diagnosis {

/// Where a push is asked for.
struct SoundingPlace {
  std::filesystem::path folder;    ///< of the request: recordings are beside it
  const parameters::Study* study;  ///< nullptr: what it would decide is not checked
  double cell_height;              // [m] of the depth grid
  bool recorded = true;            ///< else it has a name in place of a recording
};

/// Name, recording, columns and depths of a table [[list]]. Nothing where a depth is missing or no number.
[[nodiscard]] std::optional<SoundingRequest> read_sounding(const parameters::Value& table,
                                                           std::string_view list, const SoundingPlace& place,
                                                           parameters::ErrorList& errors);

}  // namespace cpt::diagnosis

// Times as Geotech files write them.
#pragma once

#include <optional>
#include <string_view>

namespace cpt::recordings {

/// [s] from a zero of the file's own: YYYYMMDDhhmmssmmm (17 digits) or YYYYMMDDhhmmss (14), else a count of
/// milliseconds (up to 12 digits). Nothing for other texts and for dates and hours that do not exist.
[[nodiscard]] std::optional<double> seconds_of(std::string_view digits);

}  // namespace cpt::recordings

// Counts in sentences.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace cpt::results {

/// "1 row", "3 rows"
[[nodiscard]] inline std::string count_of(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace cpt::results

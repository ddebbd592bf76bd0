// Numbers as the commands' tables have them.
#pragma once

#include <cmath>
#include <cstdint>

#include "results/tables/table_format.hpp"

namespace cpt::cli {

inline constexpr double kPa = 1.0e3, MPa = 1.0e6;  // [Pa]

/// Empty where there is no value.
[[nodiscard]] inline results::Cell cell(double value) {
  return std::isnan(value) ? results::Cell{} : results::Cell(value);
}
[[nodiscard]] inline results::Cell whole(int value) { return std::int64_t{value}; }
[[nodiscard]] inline results::Cell whole(std::size_t value) { return static_cast<std::int64_t>(value); }

}  // namespace cpt::cli

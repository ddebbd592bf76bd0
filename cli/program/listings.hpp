// Everything there is to choose from or to look up, as tables: `campaign list`, docs/reference.md and the man
// page.
#pragma once

#include <span>

#include "results/tables/table_format.hpp"

namespace cpt::cli {

struct Listing {
  const char* name;     ///< as in `campaign list NAME`
  const char* title;    ///< of its section in the reference
  const char* meaning;  ///< one line
  /// With all columns, or with those that a line of the terminal has room for.
  results::Table (*make)(bool all);
};

[[nodiscard]] std::span<const Listing> listings();

}  // namespace cpt::cli

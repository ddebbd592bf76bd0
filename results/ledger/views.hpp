// The ledger's views, as SQL; docs/schema.md explains every column.
#pragma once

#include <span>
#include <string>

namespace cpt::results {

struct View {
  std::string name;
  std::string definition;  ///< CREATE VIEW ...;
};

/// In an order in which each may be dropped or made.
[[nodiscard]] std::span<const View> views();

}  // namespace cpt::results

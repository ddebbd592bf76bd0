// The text of a setup (solver::canonical_text) by its names.
#pragma once

#include <map>
#include <string>

namespace cpt::results {

/// "name = value" lines by name; several of one name, as layers and zones have, are joined by "; ".
[[nodiscard]] std::map<std::string, std::string> setup_by_name(const std::string& canonical_text);

}  // namespace cpt::results

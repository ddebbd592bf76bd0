// What the field calls quantities that have another name here; for hints.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cpt::parameters {

struct Synonym {
  std::string_view word;      ///< squeezed
  std::string_view quantity;  ///< dotted name
};

/// Of a word with several meanings, that in the group asked for counts, else the first.
[[nodiscard]] std::span<const Synonym> quantity_synonyms();

/// Letters and digits alone, in lower case: "relativedensity" of "Relative_density".
[[nodiscard]] std::string squeezed(std::string_view name);

}  // namespace cpt::parameters

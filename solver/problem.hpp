// What is wrong with a setup.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace cpt::solver {

struct Problem {
  std::string quantity;  ///< dotted name of the quantity to change, or "layers" / "numerics.zones" / "soils"
  std::string message;   ///< value, violated constraint and a hint
  std::optional<std::size_t> layer = {};  ///< of "layers": which one, where it is one alone
};

}  // namespace cpt::solver

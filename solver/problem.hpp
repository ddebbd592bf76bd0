// What is wrong with a setup.
#pragma once

#include <string>

namespace cpt::solver {

struct Problem {
  std::string quantity;  ///< dotted name of the quantity to change, or "layers" / "numerics.zones" / "soils"
  std::string message;   ///< value, violated constraint and a hint
};

}  // namespace cpt::solver

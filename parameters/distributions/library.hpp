// OpenTURNS, behind a module of its own that is loaded when first asked for: it takes two tenths of a second
// of CPU to start, which no realization's process is to pay, and a build without it lacks this module and
// nothing else.
#pragma once

#include <memory>
#include <stdexcept>

#include "parameters/distributions/distribution.hpp"

namespace cpt::parameters {

/// What the module offers (openturns/module.cpp). Functions throw std::invalid_argument with OpenTURNS'
/// words.
struct OpenTurns {
  std::unique_ptr<const Marginal> (*marginal)(const Distribution& distribution);
};

/// The module cannot be loaded; says which file, why, and what to install.
struct MissingLibrary : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The module, loaded once. Throws MissingLibrary.
[[nodiscard]] const OpenTurns& openturns();

/// Name of the module's one symbol, a function that returns `const OpenTurns*`.
inline constexpr const char* openturns_entry = "cpt_openturns";

}  // namespace cpt::parameters

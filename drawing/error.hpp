// What cannot be drawn.
#pragma once

#include <stdexcept>

namespace cpt::drawing {

/// A document, a picture or an animation that a library refuses; `what()` says why, but not which file it was
/// for.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace cpt::drawing

// All keys of a request for a calibration.
#pragma once

#include "parameters/keys.hpp"

namespace cpt::diagnosis {

/// The tables of a request, the top of the file first.
[[nodiscard]] std::span<const parameters::KeyTable> calibration_keys();

}  // namespace cpt::diagnosis

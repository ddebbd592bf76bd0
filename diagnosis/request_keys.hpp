// All keys of a request for a diagnosis and of a plan of concealed cases.
#pragma once

#include "parameters/keys.hpp"

namespace cpt::diagnosis {

/// The tables of a request, the top of the file first; [cases] belongs to a plan alone.
[[nodiscard]] std::span<const parameters::KeyTable> request_keys();

}  // namespace cpt::diagnosis

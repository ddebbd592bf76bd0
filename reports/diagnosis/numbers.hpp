// All numbers of a diagnosis as one JSON document.
#pragma once

#include <string>

#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

/// Units stand in the keys; ln is of q_c / Pa. Numbers that are not finite are null, bytes that are no UTF-8
/// U+FFFD. The nodes of the evidences are left out.
[[nodiscard]] std::string diagnosis_json(const DiagnosisInput& input);

}  // namespace cpt::reports::diagnosed

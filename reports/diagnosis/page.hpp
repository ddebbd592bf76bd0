// The page of a diagnosis: the answer, the figures, the tables.
#pragma once

#include <string>
#include <vector>

#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

/// A figure that has been written.
struct LinkedFigure {
  std::string file;     ///< relative to the page, made of letters, digits, '-', '_', '.' and '/'
  std::string caption;  ///< plain text
};

/// The whole page in Markdown.
[[nodiscard]] std::string page(const DiagnosisInput& input, const std::vector<LinkedFigure>& figures);

}  // namespace cpt::reports::diagnosed

// The report's page: one self-contained HTML file.
#pragma once

#include <string>
#include <vector>

#include "results/snapshot.hpp"

namespace cpt::reports {

/// A figure to put on the page.
struct PageFigure {
  std::string svg;
  std::string caption;  ///< plain text
};

/// State of the campaign, failures with reasons, figures, sensitivity tables, realizations, provenance.
[[nodiscard]] std::string page(const results::Snapshot& campaign, const std::vector<PageFigure>& figures);

}  // namespace cpt::reports

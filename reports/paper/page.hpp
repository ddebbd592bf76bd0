// The comparison with the paper as one Markdown page.
#pragma once

#include <string>
#include <vector>

#include "reports/paper/studies.hpp"

namespace cpt::reports::paper {

/// A figure that has been written.
struct LinkedFigure {
  std::string file;  ///< relative to the page
  std::string caption;
};

/// Figures under one heading.
struct FigureGroup {
  std::string title;
  std::vector<LinkedFigure> figures;
};

/// What was run, every finding, what differs or is missing, the sensitivity indices, figures, and how the
/// numbers were made. With `beside`, the same findings of other campaigns, such as finer ones, have columns
/// of their own.
[[nodiscard]] std::string page(const Studies& studies, const std::vector<FigureGroup>& figures,
                               const Studies* beside = nullptr);

}  // namespace cpt::reports::paper

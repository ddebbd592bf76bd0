// The comparison with the paper as one Markdown page.
#pragma once

#include <string>
#include <vector>

#include "validation/paper/causes.hpp"
#include "validation/paper/pushes.hpp"

namespace cpt::validation::paper {

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

/// Every result of the paper with ours and a verdict, causes of what differs, the sensitivity indices,
/// figures, what was run, and how the checks are made. With `beside`, the numbers of the same studies run
/// otherwise, such as coarser, have columns of their own.
[[nodiscard]] std::string page(const Runs& runs, const std::vector<Cause>& causes,
                               const std::vector<FigureGroup>& figures, const Runs* beside = nullptr);

}  // namespace cpt::validation::paper

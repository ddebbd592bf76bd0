// Figures of the paper that no single campaign has.
#pragma once

#include <vector>

#include "reports/figure_files.hpp"
#include "reports/paper/studies.hpp"

namespace cpt::reports::paper {

/// Sand of Table 2 in single-element tests: critical state line with loose tests (Fig. 5), triaxial tests
/// (Fig. 6), oedometer (Fig. 8). Simulated only: the paper's measurements are not published as numbers.
[[nodiscard]] std::vector<NamedFigure> soil_figures();

/// q_c over depth for two walls and two horizontal stresses (Fig. 13), and of first and second push (Fig.
/// 16); as far as they have been run.
[[nodiscard]] std::vector<NamedFigure> chamber_figures(const Studies& studies);

}  // namespace cpt::reports::paper

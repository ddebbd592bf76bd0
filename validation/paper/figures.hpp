// Figures of the paper that no single campaign has.
#pragma once

#include <vector>

#include "reports/figure_files.hpp"
#include "validation/paper/pushes.hpp"
#include "validation/paper/studies.hpp"

namespace cpt::validation::paper {

/// Width of a figure with one plot [pt].
inline constexpr double single_plot_width = 400.0;

/// Sand of Table 2 in single-element tests: critical state line with loose tests (Fig. 5), triaxial tests
/// (Fig. 6), H found again from simulated tests (Fig. 7), oedometer (Fig. 8). Simulated only: the paper's
/// measurements are not published as numbers.
[[nodiscard]] std::vector<reports::NamedFigure> soil_figures();

/// q_c over depth for two walls and two horizontal stresses (Fig. 13), and of first and second push (Fig.
/// 16); as far as they have been run.
[[nodiscard]] std::vector<reports::NamedFigure> chamber_figures(const Studies& studies);

/// Stress paths beside the cone behind either wall (Fig. 14), stresses at the rigid wall (Fig. 15), void
/// ratio at the end by radius and as a map (section 6.3.2); as far as the pushes have been recorded.
[[nodiscard]] std::vector<reports::NamedFigure> push_figures(const Pushes& pushes);

/// H that the calibration finds from simulated drained triaxial tests of known H, over psi_0: a complete SVG
/// document.
[[nodiscard]] std::string hardening_figure();

/// Void ratio at the end of a push by radius, and its change as a map: complete SVG documents.
[[nodiscard]] std::string void_ratio_profile_figure(const results::Histories& push);
[[nodiscard]] std::string void_ratio_map_figure(const results::Histories& push);

}  // namespace cpt::validation::paper

// How parameters, realizations, windows and the state of a campaign are named in figures and on the page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drawing/svg.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::reports {

[[nodiscard]] const results::ParameterRow& parameter_of(const results::Snapshot& campaign,
                                                        std::string_view name);
[[nodiscard]] const results::RealizationRow* baseline_run(const results::Snapshot& campaign);
[[nodiscard]] const solver::DepthProfile* curve_of(const results::Snapshot& campaign, int realization);
/// The realization at a bound; nullptr where the bound equals the baseline.
[[nodiscard]] const results::RealizationRow* bound_run(const results::Snapshot& campaign,
                                                       std::string_view parameter, std::string_view side);
/// What the repeats of the baseline say of a window; nullptr without repeats.
[[nodiscard]] const results::RepeatNoiseRow* repeat_noise_of(const results::Snapshot& campaign,
                                                             std::string_view window);
/// True where the index is known to lie within the noise: that of the repeats, without them SI_noise.
[[nodiscard]] bool within_noise(const results::SensitivityRow& row);
[[nodiscard]] std::vector<results::SensitivityRow> sensitivity_in(const results::Snapshot& campaign,
                                                                  std::string_view window);

/// Symbol of a parameter, with its group in brackets where two rows of the study share a symbol, and where it
/// is one of several soils that the study names.
[[nodiscard]] drawing::Rich symbol_of(const results::Snapshot& campaign,
                                      const results::ParameterRow& parameter);
/// " (kPa)"; nothing for numbers without unit.
[[nodiscard]] drawing::Rich unit_of(const results::ParameterRow& parameter);
/// "baseline", "H = 75", "σ'h0 = 35 kPa", "wall = flexible"; a point's name.
[[nodiscard]] drawing::Rich run_label(const results::Snapshot& campaign, const results::RealizationRow& run);
/// A longer text cut with "…" so that it fits a width.
[[nodiscard]] std::string shortened(std::string_view text, double room, double font_size, bool bold = false);
/// "0.5054–0.5255 m".
[[nodiscard]] std::string depth_range(double from_m, double to_m);

// What a window holds, of q_c or of what an external program gives (results::WindowRow::quantity).
/// Where: "0.5054–0.5255 m", "time 10–20 d"; nothing for a scalar and where that is not known yet.
[[nodiscard]] std::string place_of(const results::Snapshot& campaign, const results::WindowRow& window);
/// "average q_c", "average settlement", of a scalar its name.
[[nodiscard]] drawing::Rich average_of(const results::WindowRow& window);
/// The same with its unit: "average q_c (kPa)".
[[nodiscard]] drawing::Rich axis_of(const results::WindowRow& window);
/// " kPa"; nothing for numbers without unit.
[[nodiscard]] std::string unit_behind(const results::WindowRow& window);

/// A window's name, cut where needed, before what is said of it in a figure's heading.
[[nodiscard]] drawing::Rich window_line(const results::WindowRow& window, const drawing::Rich& what,
                                        double figure_width);

/// "21 of 21 realizations completed", with the failed and waiting ones where there are any.
[[nodiscard]] std::string state_of(const results::Snapshot& campaign);
[[nodiscard]] bool all_completed(const results::Snapshot& campaign);

/// Of what draw_heading() draws, with so many lines.
[[nodiscard]] double heading_height(const results::Snapshot& campaign, std::size_t lines,
                                    drawing::Ground ground = drawing::Ground::file);
/// Bold title and grey lines in the upper left corner; returns the y below them. Says the campaign's state
/// where it is not complete. Nothing in a page, which says all of this.
double draw_heading(drawing::Svg& svg, const results::Snapshot& campaign, std::string_view title,
                    const std::vector<drawing::Rich>& lines);
/// Title and one grey line of a figure that belongs to no campaign; they end 32 points below the upper edge.
void draw_heading(drawing::Svg& svg, std::string_view title, const drawing::Rich& line);

}  // namespace cpt::reports

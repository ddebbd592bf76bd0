// Figures as files: which a campaign has, and how one is written.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "drawing/column.hpp"
#include "reports/place.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/statistics/effects.hpp"

namespace cpt::reports {

struct NamedFigure {
  std::string name;                ///< file name without ending
  std::string caption;             ///< plain text
  std::optional<std::string> svg;  ///< nothing where the results it needs are not there
};

/// Tornado, indices, the design's effects and their convergence (none without a design) of a window; `part`
/// ends their names.
[[nodiscard]] std::vector<NamedFigure> window_figures(const results::Snapshot& campaign,
                                                      const results::Effects& effects,
                                                      const results::WindowRow& window,
                                                      const std::string& part, Place place);

/// Of a design propagation the bands of every channel.
[[nodiscard]] std::vector<NamedFigure> band_figures(const results::Snapshot& campaign,
                                                    const results::Effects& effects, Place place);

/// Those of every window, the bands, profiles, baseline.
[[nodiscard]] std::vector<NamedFigure> campaign_figures(
    const results::Snapshot& campaign, const results::Effects& effects = {},
    drawing::Column column = drawing::Column::one_and_half);

/// Writes NAME.svg and NAME.png and returns them; without an SVG it removes those of an earlier report.
/// Throws results::Error if a file cannot be written.
std::vector<std::filesystem::path> write_figure(const NamedFigure& figure,
                                                const std::filesystem::path& directory);

/// Makes a folder and those above it; throws results::Error if it cannot.
void make_directory(const std::filesystem::path& directory);
/// Replaces a file in one step, so that who reads it finds the old or the new one; throws results::Error if
/// it cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace cpt::reports

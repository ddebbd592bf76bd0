// Panels over depth, one a sounding: their places, the shaded intervals and curves of cells.
#pragma once

#include "drawing/axis.hpp"
#include "drawing/flow_legend.hpp"
#include "drawing/svg.hpp"
#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

/// Where the panels lie; up to four in a row.
class SoundingPanels {
 public:
  /// Room for the legend is kept free below the panels.
  SoundingPanels(const DiagnosisInput& input, double panel_width, double panel_height,
                 drawing::FlowLegend legend);

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] drawing::Box box(std::size_t sounding) const;
  /// Depth axis of a panel: all cells and baselines.
  [[nodiscard]] drawing::Axis depth(std::size_t sounding) const;

  /// Shaded intervals, axes with their grids, and the sounding's name; `across` is the horizontal axis.
  void draw_ground(drawing::Svg& svg, std::size_t sounding, const drawing::Axis& across,
                   const drawing::Rich& title) const;
  void draw_legend(drawing::Svg& svg) const;

 private:
  const DiagnosisInput& input_;
  drawing::FlowLegend legend_;
  double panel_width_, panel_height_, width_ = 0.0, height_ = 0.0, legend_top_ = 0.0;
  drawing::Range range_{};  // [m]
};

/// A value in each cell of a sounding, as a line through the cells' middles, broken where cells lack.
[[nodiscard]] std::vector<drawing::Point> cell_line(const DiagnosisInput& input, std::size_t sounding,
                                                    const VectorXd& values, const drawing::Axis& across,
                                                    const drawing::Axis& depth);

/// Line of the k-th rival of the best effect; their entries of a legend.
[[nodiscard]] drawing::Pen rival_pen(std::size_t k);
void add_rivals(drawing::FlowLegend& legend, const DiagnosisInput& input);

/// Entries of a legend for the shaded intervals that there are.
void add_intervals(drawing::FlowLegend& legend, const DiagnosisInput& input);

/// "best effect: TITLE", with what must be known of it; one line for the head of a figure.
[[nodiscard]] std::string best_effect_line(const DiagnosisInput& input);

}  // namespace cpt::reports::diagnosed

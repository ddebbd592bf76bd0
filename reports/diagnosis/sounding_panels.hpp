// Panels over depth, one a sounding: their places, the shaded intervals and curves of cells.
#pragma once

#include "reports/axis.hpp"
#include "reports/diagnosis/input.hpp"
#include "reports/flow_legend.hpp"
#include "reports/svg.hpp"

namespace cpt::reports::diagnosed {

/// Where the panels lie; up to four in a row.
class SoundingPanels {
 public:
  /// Room for the legend is kept free below the panels.
  SoundingPanels(const DiagnosisInput& input, double panel_width, double panel_height, FlowLegend legend);

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] Box box(std::size_t sounding) const;
  /// Depth axis of a panel: all cells and baselines.
  [[nodiscard]] Axis depth(std::size_t sounding) const;

  /// Shaded intervals, axes with their grids, and the sounding's name; `across` is the horizontal axis.
  void draw_ground(Svg& svg, std::size_t sounding, const Axis& across, const Rich& title) const;
  void draw_legend(Svg& svg) const;

 private:
  const DiagnosisInput& input_;
  FlowLegend legend_;
  double panel_width_, panel_height_, width_ = 0.0, height_ = 0.0, legend_top_ = 0.0;
  Range range_{};  // [m]
};

/// A value in each cell of a sounding, as a line through the cells' middles, broken where cells lack.
[[nodiscard]] std::vector<Point> cell_line(const DiagnosisInput& input, std::size_t sounding,
                                           const VectorXd& values, const Axis& across, const Axis& depth);

/// Line of the k-th rival of the best effect; their entries of a legend.
[[nodiscard]] Pen rival_pen(std::size_t k);
void add_rivals(FlowLegend& legend, const DiagnosisInput& input);

/// Entries of a legend for the shaded intervals that there are.
void add_intervals(FlowLegend& legend, const DiagnosisInput& input);

/// "best effect: TITLE", with what must be known of it; one line for the head of a figure.
[[nodiscard]] std::string best_effect_line(const DiagnosisInput& input);

}  // namespace cpt::reports::diagnosed

// A plot of q_c over depth: depth downward, q_c along the top.
#pragma once

#include <vector>

#include "drawing/axis.hpp"
#include "drawing/svg.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::reports {

struct SoilTint {
  std::string soil;
  std::string_view colour;
};

struct DepthPlot {
  drawing::Box box;
  drawing::Axis q_c;    ///< kPa
  drawing::Axis depth;  ///< m

  /// Layers of tinted soils, then grid, tick labels and titles.
  void draw_ground(drawing::Svg& svg, const std::vector<results::LayerRow>& layers, int ticks_across = 5,
                   int ticks_down = 8) const;
  void draw_curve(drawing::Svg& svg, const solver::DepthProfile& profile, const drawing::Pen& pen) const;
  void draw_frame(drawing::Svg& svg) const;
  /// A bracket at the right edge where a window lies.
  void draw_window_mark(drawing::Svg& svg, const results::WindowRow& window) const;
  /// Soils that are tinted and seen in this range of depth, none where there is but one soil: all but sand,
  /// or the first.
  [[nodiscard]] std::vector<SoilTint> tinted(const std::vector<results::LayerRow>& layers) const;
};

/// Axes that hold all given curves from the soil's top, q_c from zero; spikes of single bins may leave the
/// frame.
[[nodiscard]] DepthPlot whole_profile(const results::Snapshot& campaign,
                                      const std::vector<results::CurveRow>& curves, const drawing::Box& box);

/// A column of entries, downward from a corner.
class Legend {
 public:
  Legend(drawing::Svg& svg, double x, double y, double width) : svg_(svg), x_(x), y_(y), width_(width) {}
  void line(const drawing::Rich& text, const drawing::Pen& pen);
  void patch(const drawing::Rich& text, std::string_view fill);
  void dot(const drawing::Rich& text, std::string_view fill);
  void mark(const drawing::Rich& text);  ///< the bracket of draw_window_mark
  void gap() { y_ += 6.0; }
  static constexpr double pitch = 13.0;  ///< [pt] from entry to entry

 private:
  static constexpr double glyph_width = 16.0, text_size = 7.5, line_pitch = 9.0;
  void entry(const drawing::Rich& text);
  drawing::Svg& svg_;
  double x_, y_, width_;
};

}  // namespace cpt::reports

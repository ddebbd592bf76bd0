// A legend whose entries follow each other and go on in the next row where one is full.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/svg.hpp"

namespace cpt::drawing {

class FlowLegend {
 public:
  /// `draw` puts the glyph with its left end, at half its height, where it is told.
  void add(double glyph_width, const Rich& text, std::function<void(Svg&, Point)> draw);

  void line(const Rich& text, const Pen& pen);
  void patch(const Rich& text, std::string_view fill);

  /// Height of all rows in so much room [pt].
  [[nodiscard]] double height(double room) const;
  /// From the middle of the first row's left end.
  void draw(Svg& svg, Point at, double room) const;

 private:
  static constexpr double text_size = 7.5, glyph_gap = 3.0, entry_gap = 11.0, row_pitch = 12.0;
  static constexpr double line_glyph = 16.0;
  struct Entry {
    double glyph_width;
    Rich text;
    std::function<void(Svg&, Point)> draw;
  };
  /// Where each entry goes, from the first row's left end.
  [[nodiscard]] std::vector<Point> places(double room) const;
  std::vector<Entry> entries_;
};

}  // namespace cpt::drawing

#include "drawing/flow_legend.hpp"

#include <utility>

namespace cpt::drawing {

void FlowLegend::add(double glyph_width, const Rich& text, std::function<void(Svg&, Point)> draw) {
  entries_.push_back({glyph_width, text, std::move(draw)});
}

void FlowLegend::line(const Rich& text, const Pen& pen) {
  add(line_glyph, text,
      [color = std::string(pen.color), wide = pen.width, dash = std::string(pen.dash)](Svg& svg, Point at) {
        svg.line(at, {at.x + line_glyph, at.y}, {color, wide, dash});
      });
}

void FlowLegend::patch(const Rich& text, std::string_view fill) {
  add(line_glyph, text, [fill = std::string(fill)](Svg& svg, Point at) {
    svg.rectangle({at.x, at.y - 4.0, line_glyph, 8.0}, fill);
  });
}

std::vector<Point> FlowLegend::places(double room) const {
  std::vector<Point> places;
  Point at{0.0, 0.0};
  for (const Entry& entry : entries_) {
    const double wide = entry.glyph_width + glyph_gap + width(entry.text, text_size);
    if (at.x > 0.0 && at.x + wide > room) at = {0.0, at.y + row_pitch};
    places.push_back(at);
    at.x += wide + entry_gap;
  }
  return places;
}

double FlowLegend::height(double room) const {
  return entries_.empty() ? 0.0 : places(room).back().y + row_pitch;
}

void FlowLegend::draw(Svg& svg, Point at, double room) const {
  const std::vector<Point> all = places(room);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Point here{at.x + all[k].x, at.y + all[k].y};
    entries_[k].draw(svg, here);
    svg.text({here.x + entries_[k].glyph_width + glyph_gap, here.y + 2.7}, entries_[k].text,
             {.size = text_size});
  }
}

}  // namespace cpt::drawing

#include "drawing/bar_rows.hpp"

#include <string>

#include "drawing/palette.hpp"

namespace cpt::drawing::bar_rows {

Box row(const Svg& svg, double y) { return {0.0, y - 0.5 * pitch, svg.width(), pitch}; }

void draw_label(Svg& svg, const Box& plot, double y, const Rich& label) {
  svg.text({plot.x - 8.0, y + 0.34 * label_size}, label, {.size = label_size, .anchor = Anchor::end});
}

void draw_whisker(Svg& svg, double from, double to, double y) {
  const Pen pen{palette::ink, 0.9, {}};
  svg.line({from, y}, {to, y}, pen);
  for (const double x : {from, to}) svg.line({x, y - 2.2}, {x, y + 2.2}, pen);
}

void add_patch(FlowLegend& legend, const Rich& text, std::string_view fill) {
  legend.add(9.0, text, [fill = std::string(fill)](Svg& svg, Point at) {
    svg.rectangle({at.x, at.y - 3.5, 9.0, 7.0}, fill);
  });
}

}  // namespace cpt::drawing::bar_rows

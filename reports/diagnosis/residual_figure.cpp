#include <algorithm>
#include <cmath>

#include "drawing/palette.hpp"
#include "reports/diagnosis/errors.hpp"
#include "reports/diagnosis/figures.hpp"
#include "reports/diagnosis/sounding_panels.hpp"
#include "reports/diagnosis/words.hpp"
#include "reports/labels.hpp"

namespace cpt::reports::diagnosed {
namespace {

using drawing::Axis, drawing::Box, drawing::FlowLegend, drawing::Pen, drawing::plain, drawing::Range,
    drawing::Svg, drawing::widened;
namespace palette = drawing::palette;

constexpr std::string_view noise_fill = "#e4e4e4";
const Pen before_pen{palette::blue, 1.0, {}};
const Pen after_pen{palette::vermillion, 1.2, {}};
const Pen after_solver_pen{palette::green, 1.0, "5 2"};

struct Residuals {
  VectorXd before, after, solver;  // [%]; empty where there is none
  std::vector<VectorXd> rivals;    // [%]
  VectorXd noise;                  // [ln q_c]
};

Residuals residuals_of(const DiagnosisInput& input) {
  Residuals r{percent_above(input.recorded, input.diagnosis.null.recalibrated.curve), {}, {}, {}, {}};
  if (input.diagnosis.best) r.after = percent_above(input.recorded, input.diagnosis.with_best().curve);
  if (const auto solver = solver_in_cells(input)) r.solver = percent_above(input.recorded, *solver);
  for (const std::size_t k : rivals(input))
    r.rivals.push_back(percent_above(input.recorded, input.diagnosis.mechanisms[k].recalibrated.curve));
  r.noise = noise_deviation(input);
  return r;
}

FlowLegend legend_of(const DiagnosisInput& input, const Residuals& r) {
  FlowLegend legend;
  legend.line(plain("before: parameters refitted"), before_pen);
  if (r.after.size() > 0) legend.line(plain("after: with the best effect (emulator)"), after_pen);
  if (r.solver.size() > 0) legend.line(plain("after: with the best effect (full solver)"), after_solver_pen);
  add_rivals(legend, input);
  legend.patch(plain("± 2 standard deviations of noise"), noise_fill);
  add_intervals(legend, input);
  return legend;
}

Range extent(const Residuals& r) {
  double low = -5.0, high = 5.0;  // [%] a good fit must not look rough
  for (const VectorXd* v : {&r.before, &r.after, &r.solver})
    for (Index i = 0; i < v->size(); ++i)
      if (std::isfinite((*v)(i))) {
        low = std::min(low, (*v)(i));
        high = std::max(high, (*v)(i));
      }
  return widened(low, high, 0.06);
}

// Two standard deviations of the noise to either side of zero, cell by cell.
void draw_noise(Svg& svg, const DiagnosisInput& input, std::size_t sounding, const VectorXd& noise,
                const Axis& across, const Axis& depth) {
  const std::vector<diagnosis::Cell>& cells = input.diagnosis.compared.cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const diagnosis::Cell& cell = cells[i];
    if (cell.sounding != static_cast<int>(sounding)) continue;
    const double two = 2.0 * noise(static_cast<Index>(i));
    const double x = across(percent_of(-two)), y = depth(cell.depth - 0.5 * cell.height);
    // A hair taller than the cell, so that no seams show.
    svg.rectangle({x, y, across(percent_of(two)) - x, depth(cell.depth + 0.5 * cell.height) - y + 0.15},
                  noise_fill);
  }
}

}  // namespace

std::string residual_figure(const DiagnosisInput& input) {
  const Residuals r = residuals_of(input);
  const SoundingPanels panels(input, 190.0, 320.0, legend_of(input, r));
  Svg svg(panels.width(), panels.height(), "residual");
  const Range range = extent(r);
  for (std::size_t s = 0; s < input.soundings.size(); ++s) {
    const Box box = panels.box(s);
    const Axis across{range.low, range.high, box.x, box.right()}, depth = panels.depth(s);
    panels.draw_ground(svg, s, across, plain("recorded less simulated (%)"));
    svg.begin_clip(box);
    draw_noise(svg, input, s, r.noise, across, depth);
    svg.line({across(0.0), box.y}, {across(0.0), box.bottom()}, {palette::ink, 0.6, {}});
    svg.polyline(cell_line(input, s, r.before, across, depth), before_pen);
    for (std::size_t k = 0; k < r.rivals.size(); ++k)
      svg.polyline(cell_line(input, s, r.rivals[k], across, depth), rival_pen(k));
    if (r.after.size() > 0) svg.polyline(cell_line(input, s, r.after, across, depth), after_pen);
    if (r.solver.size() > 0) svg.polyline(cell_line(input, s, r.solver, across, depth), after_solver_pen);
    svg.end_clip();
    svg.frame(box, {palette::ink, 0.6, {}});
  }
  draw_heading(svg, "What is left of the difference",
               plain(shortened(best_effect_line(input), panels.width() - 16.0, 8.0)));
  panels.draw_legend(svg);
  return svg.document("Residuals of " + input.title);
}

}  // namespace cpt::reports::diagnosed

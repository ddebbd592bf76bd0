#include <algorithm>
#include <cmath>

#include "drawing/palette.hpp"
#include "reports/diagnosis/figures.hpp"
#include "reports/diagnosis/sounding_panels.hpp"
#include "reports/labels.hpp"
#include "reports/units.hpp"
#include "results/push/push_start.hpp"

namespace cpt::reports::diagnosed {
namespace {

using drawing::Axis, drawing::Box, drawing::FlowLegend, drawing::Pen, drawing::plain, drawing::Point,
    drawing::Svg, drawing::symbolic;
namespace palette = drawing::palette;

const Pen recorded_pen{palette::ink, 1.1, {}};
const Pen baseline_pen{palette::muted, 0.8, "2 2"};
const Pen null_pen{palette::blue, 1.0, {}};
const Pen mechanism_pen{palette::vermillion, 1.2, {}};
const Pen solver_pen{palette::green, 1.2, "5 2"};

// Cells set the scale: a spike of a single reading may leave the frame.
double greatest(const DiagnosisInput& input) {
  double most = 0.0;
  const auto take = [&](const VectorXd& curve) {
    for (Index i = 0; i < curve.size(); ++i)
      if (std::isfinite(curve(i))) most = std::max(most, std::exp(curve(i)) / kPa);
  };
  take(input.recorded);
  take(input.baseline);
  take(input.diagnosis.null.recalibrated.curve);
  if (input.diagnosis.best) take(input.diagnosis.with_best().curve);
  for (const std::size_t k : rivals(input)) take(input.diagnosis.mechanisms[k].recalibrated.curve);
  return most > 0.0 ? 1.08 * most : 1.0;
}

void draw_curve(Svg& svg, const Curve& curve, const Axis& across, const Axis& depth, const Pen& pen,
                std::size_t first = 0) {
  std::vector<Point> points;
  for (std::size_t i = first; i < curve.depth.size(); ++i)
    points.push_back({across(curve.q_c[i] / kPa), depth(curve.depth[i])});
  svg.polyline(points, pen);
}

// A simulated curve without the start of its push, which no recording holds.
void draw_simulated(Svg& svg, const Curve& curve, const Axis& across, const Axis& depth, const Pen& pen) {
  draw_curve(svg, curve, across, depth, pen, results::bins_of_start({curve.depth, curve.q_c, {}}));
}

VectorXd in_kPa(const VectorXd& ln) {
  return ln.unaryExpr([](double x) { return std::exp(x) / kPa; });
}

FlowLegend legend_of(const DiagnosisInput& input) {
  FlowLegend legend;
  legend.line(plain("recording"), recorded_pen);
  legend.line(plain("simulation, baseline"), baseline_pen);
  legend.line(plain("study's parameters refitted"), null_pen);
  if (input.diagnosis.best) {
    legend.line(plain("with the best effect (emulator)"), mechanism_pen);
    if (std::ranges::any_of(input.soundings, [](const Sounding& s) { return s.solver.has_value(); }))
      legend.line(plain("with the best effect (full solver)"), solver_pen);
    add_rivals(legend, input);
  }
  add_intervals(legend, input);
  return legend;
}

}  // namespace

std::string profile_figure(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  const SoundingPanels panels(input, 190.0, 380.0, legend_of(input));
  Svg svg(panels.width(), panels.height(), "profile");
  const double most = greatest(input);
  const VectorXd null = in_kPa(d.null.recalibrated.curve);
  const VectorXd with = d.best ? in_kPa(d.with_best().curve) : VectorXd();
  const std::vector<std::size_t> others = rivals(input);
  for (std::size_t s = 0; s < input.soundings.size(); ++s) {
    const Box box = panels.box(s);
    const Axis across{0.0, most, box.x, box.right()}, depth = panels.depth(s);
    panels.draw_ground(svg, s, across, symbolic("q_c (kPa)"));
    svg.begin_clip(box);
    draw_simulated(svg, input.soundings[s].baseline, across, depth, baseline_pen);
    draw_curve(svg, input.soundings[s].recorded, across, depth, recorded_pen);
    svg.polyline(cell_line(input, s, null, across, depth), null_pen);
    for (std::size_t k = 0; k < others.size(); ++k)
      svg.polyline(cell_line(input, s, in_kPa(d.mechanisms[others[k]].recalibrated.curve), across, depth),
                   rival_pen(k));
    if (d.best) svg.polyline(cell_line(input, s, with, across, depth), mechanism_pen);
    if (input.soundings[s].solver) draw_simulated(svg, *input.soundings[s].solver, across, depth, solver_pen);
    svg.end_clip();
    svg.frame(box, {palette::ink, 0.6, {}});
  }
  draw_heading(svg, shortened("Cone resistance: recorded and simulated", panels.width() - 16.0, 10.0, true),
               plain(shortened(best_effect_line(input), panels.width() - 16.0, 8.0)));
  panels.draw_legend(svg);
  return svg.document("Cone resistance of " + input.title);
}

}  // namespace cpt::reports::diagnosed

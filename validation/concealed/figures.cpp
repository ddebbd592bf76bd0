#include "validation/concealed/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/depth_plot.hpp"
#include "reports/labels.hpp"
#include "validation/concealed/scores.hpp"

namespace cpt::validation::concealed {
namespace {

using drawing::Box, drawing::plain, drawing::Svg, drawing::XyPlot;
using reports::draw_heading, reports::Legend;
namespace palette = drawing::palette;

constexpr double figure_width = 420.0, figure_height = 300.0;
constexpr Box plot_box{52.0, 46.0, 350.0, 190.0};

// A mark with its interval at x.
void add(XyPlot& plot, double x, const Proportion& p, std::string_view colour) {
  if (p.of == 0) return;
  plot.curves.push_back({{{x, 100.0 * p.lower}, {x, 100.0 * p.upper}}, {colour, 1.0, {}}, 0.0});
  plot.curves.push_back({{{x, 100.0 * p.value}}, {colour, 1.2, {}}, 3.0});
}

}  // namespace

std::string strength_figure(const std::vector<Benchmark>& benchmarks) {
  Svg svg(figure_width, figure_height, "strength");
  XyPlot plot;
  plot.x_title = plain("strength of the true effect out of the null (standard deviations)");
  plot.y_title = plain("share of cases (%)");
  plot.room = {{0.0, 0.0}, {11.0, 100.0}};
  const std::size_t bins = std::size(strength_bounds);
  for (std::size_t b = 0; b < bins; ++b) {
    const double from = strength_bounds[b], to = b + 1 < bins ? strength_bounds[b + 1] : INFINITY;
    const Cases cases = select(benchmarks, [&](const Judged& judged) {
      return judged.truth.kind() == "single" && judged.strength >= from && judged.strength < to;
    });
    const double x = std::isfinite(to) ? 0.5 * (from + to) : from + 1.0;
    add(plot, x - 0.1, share(cases, [](const Judged& j) { return j.right(); }), palette::vermillion);
    add(plot, x + 0.1, share(cases, [](const Judged& j) { return among_first(j, 3); }), palette::blue);
  }
  draw(svg, plot_box, plot);
  draw_heading(svg, "One mechanism is missing: is it named?",
               plain("95 % intervals (Clopper–Pearson); the last group is open upwards"));
  Legend(svg, 60.0, 284.0, 130.0).dot(plain("named"), palette::vermillion);
  Legend(svg, 200.0, 284.0, 160.0).dot(plain("among the first three"), palette::blue);
  return svg.document("Share of cases named rightly by strength");
}

std::string reliability_figure(const std::vector<Benchmark>& benchmarks) {
  Svg svg(figure_width, figure_height, "reliability");
  XyPlot plot;
  plot.x_title = plain("probability claimed for the answer (%)");
  plot.y_title = plain("right answers (%)");
  plot.room = {{0.0, 0.0}, {100.0, 100.0}};
  plot.curves.push_back({{{0.0, 0.0}, {100.0, 100.0}}, {palette::muted, 1.0, "3 2"}, 0.0});
  const Cases all = select(benchmarks, [](const Judged&) { return true; });
  for (const auto& bin : reliability(labelled(benchmarks, all).cases))
    if (bin.correct.of > 0) add(plot, 100.0 * bin.claimed, bin.correct, palette::vermillion);
  draw(svg, plot_box, plot);
  draw_heading(
      svg, "Are the probabilities honest?",
      plain("all cases in five groups by the probability claimed; on the line: as often as claimed"));
  return svg.document("Right answers against claimed probability");
}

}  // namespace cpt::validation::concealed

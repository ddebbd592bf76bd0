#include <fmt/format.h>

#include <algorithm>

#include "drawing/axis.hpp"
#include "drawing/palette.hpp"
#include "reports/depth_plot.hpp"
#include "reports/diagnosis/figures.hpp"
#include "reports/diagnosis/sentences.hpp"
#include "reports/diagnosis/words.hpp"
#include "reports/labels.hpp"

namespace cpt::reports::diagnosed {
namespace {

using drawing::Anchor, drawing::Axis, drawing::Box, drawing::Edge, drawing::plain, drawing::Svg;
namespace palette = drawing::palette;

constexpr double bar_pitch = 17.0, bar_height = 10.0, title_room = 236.0, plot_width = 250.0, bars_top = 46.0;
constexpr double value_room = 66.0, title_size = 8.0;

}  // namespace

std::string probability_figure(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  const auto rows = static_cast<double>(d.hypotheses.size());
  const Box plot{title_room, bars_top, plot_width, rows * bar_pitch};
  Svg svg(title_room + plot_width + value_room, plot.bottom() + 60.0, "probability");
  const Axis across{0.0, 1.0, plot.x, plot.right()};
  draw_horizontal(svg, plot, across, Edge::bottom, plain("probability (-)"), 5);
  const bool full = stands_alone(input);
  double y = bars_top;
  for (const std::size_t k : by_probability(input, d.hypotheses.size())) {
    const diagnosis::Hypothesis& h = d.hypotheses[k];
    const bool answer = k == d.answer;
    const bool mechanism = k < input.mechanisms.size();
    const double middle = y + 0.5 * bar_pitch;
    svg.text({plot.x - 6.0, middle + 0.36 * title_size},
             plain(shortened(title_of(input, k), title_room - 14.0, title_size, answer)),
             {.size = title_size, .anchor = Anchor::end, .bold = answer});
    const Box bar{plot.x, middle - 0.5 * bar_height, across(h.probability) - plot.x, bar_height};
    const std::string_view color = mechanism ? palette::vermillion : palette::blue;
    svg.rectangle(bar, color, answer && full ? 1.0 : 0.3);
    if (std::ranges::find(d.set, k) != d.set.end()) svg.frame(bar, {color, 1.2, {}});
    svg.line({across(h.prior), middle - 0.5 * bar_pitch + 1.5},
             {across(h.prior), middle + 0.5 * bar_pitch - 1.5}, {palette::ink, 1.3, {}});
    svg.text({plot.right() + 6.0, middle + 0.36 * title_size}, plain(probability(h.probability)),
             {.size = title_size, .bold = answer});
    y += bar_pitch;
  }
  svg.frame(plot, {palette::ink, 0.6, {}});
  draw_heading(svg, "Probability of each explanation",
               plain(fmt::format("bold: the answer, after the predictive check; framed: not ruled out{}",
                                 full ? "" : "; no full bar: see the reservations")));
  const double bottom = plot.bottom() + 48.0;
  Legend(svg, 12.0, bottom, 150.0).patch(plain("effect of the catalogue"), palette::vermillion);
  Legend(svg, 182.0, bottom, 180.0).patch(plain("nothing, or something else"), palette::blue);
  svg.line({386.0, bottom - 6.0}, {386.0, bottom + 6.0}, {palette::ink, 1.3, {}});
  svg.text({394.0, bottom + 2.7}, plain("before the recording (prior)"), {.size = 7.5});
  return svg.document("Probabilities of " + input.title);
}

}  // namespace cpt::reports::diagnosed

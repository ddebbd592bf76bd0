#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "drawing/axis.hpp"
#include "drawing/column.hpp"
#include "drawing/flow_legend.hpp"
#include "drawing/palette.hpp"
#include "reports/diagnosis/figures.hpp"
#include "reports/diagnosis/sentences.hpp"
#include "reports/diagnosis/words.hpp"
#include "reports/labels.hpp"
#include "solver/mechanisms/catalogue.hpp"

namespace cpt::reports::diagnosed {
namespace {

using drawing::Anchor, drawing::Axis, drawing::Box, drawing::Edge, drawing::FlowLegend, drawing::Ground,
    drawing::plain, drawing::Point, drawing::Rich, drawing::Svg;
namespace palette = drawing::palette;

constexpr double bar_pitch = 17.0, bar_height = 10.0, value_room = 66.0, title_size = 8.0, side = 12.0;
constexpr double file_title_room = 236.0, file_plot_width = 250.0;

/// A hypothesis as it is drawn.
struct Bar {
  std::string label, title;
  double prior, probability;  // [-] 0 to 1
  bool answer, in_set, mechanism;
};

FlowLegend legend_of() {
  FlowLegend legend;
  legend.patch(plain("effect of the catalogue"), palette::vermillion);
  legend.patch(plain("nothing, or something else"), palette::blue);
  legend.add(4.0, plain("before the recording (prior)"), [](Svg& svg, Point at) {
    svg.line({at.x + 2.0, at.y - 6.0}, {at.x + 2.0, at.y + 6.0}, {palette::ink, 1.3, {}});
  });
  return legend;
}

void draw_bar(Svg& svg, const Box& plot, const Axis& across, const Bar& h, double middle, bool full) {
  svg.text({plot.x - 6.0, middle + 0.36 * title_size},
           plain(shortened(h.label, plot.x - 14.0, title_size, h.answer)),
           {.size = title_size, .anchor = Anchor::end, .bold = h.answer});
  const Box box{plot.x, middle - 0.5 * bar_height, across(h.probability) - plot.x, bar_height};
  const std::string_view color = h.mechanism ? palette::vermillion : palette::blue;
  svg.rectangle(box, color, h.answer && full ? 1.0 : 0.3);
  if (h.in_set) svg.frame(box, {color, 1.2, {}});
  svg.line({across(h.prior), middle - 0.5 * bar_pitch + 1.5},
           {across(h.prior), middle + 0.5 * bar_pitch - 1.5}, {palette::ink, 1.3, {}});
  svg.text({plot.right() + 6.0, middle + 0.36 * title_size}, plain(probability(h.probability)),
           {.size = title_size, .bold = h.answer});
}

/// `full`: one explanation alone is left, without reservations.
std::string drawn(const std::vector<Bar>& bars, bool full, const std::string& title, Ground ground) {
  const bool file = ground == Ground::file;
  double titles = 0.0;
  for (const Bar& h : bars) titles = std::max(titles, width(plain(h.label), title_size, h.answer) + 14.0);
  const double page_width = width_of(drawing::Column::single);
  const double title_room = file ? file_title_room : std::min(titles, 0.5 * page_width);
  const double plot_width = file ? file_plot_width : page_width - title_room - value_room;
  const double top = file ? 46.0 : 4.0;
  const Box plot{title_room, top, plot_width, static_cast<double>(bars.size()) * bar_pitch};
  const FlowLegend legend = legend_of();
  const double whole = title_room + plot_width + value_room, room = whole - 2.0 * side;
  Svg svg(whole, plot.bottom() + 48.0 + legend.height(room), "probability", ground);
  const Axis across{0.0, 1.0, plot.x, plot.right()};
  draw_horizontal(svg, plot, across, Edge::bottom, plain("probability (-)"), 5);
  double middle = top + 0.5 * bar_pitch;
  for (const Bar& h : bars) {
    svg.begin_part(
        {0.0, middle - 0.5 * bar_pitch, whole, bar_pitch},
        fmt::format("{}\nprobability {}, before the recording {}{}", h.title, probability(h.probability),
                    probability(h.prior), h.in_set ? "\nnot ruled out" : ""));
    draw_bar(svg, plot, across, h, middle, full);
    svg.end_part();
    middle += bar_pitch;
  }
  svg.frame(plot, {palette::ink, 0.6, {}});
  if (file)
    draw_heading(svg, "Probability of each explanation",
                 plain(fmt::format("bold: the answer, after the predictive check; framed: not ruled out{}",
                                   full ? "" : "; no full bar: see the reservations")));
  legend.draw(svg, {side, plot.bottom() + 48.0}, room);
  return svg.document("Probabilities of " + title);
}

}  // namespace

std::string probability_figure(const DiagnosisInput& input) {
  const diagnosis::Verdict& verdict = input.diagnosis.verdict;
  std::vector<Bar> bars;
  for (const Explanation explanation : verdict.by_probability()) {
    const diagnosis::Hypothesis& h = verdict.of(explanation);
    const std::string title = title_of(input, explanation);
    bars.push_back({title, title, h.prior, h.probability, explanation == verdict.answer,
                    verdict.in_set(explanation), explanation.is_mechanism()});
  }
  return drawn(bars, stands_alone(input), input.title, Ground::file);
}

std::optional<std::string> probability_figure(const diagnosis::StoredAnswer& answer) {
  std::vector<Bar> bars;
  for (const auto& h : answer.hypotheses) {
    const auto share = [](double p) { return p >= 0.0 && p <= 1.0; };
    if (!share(h.prior) || !share(h.probability)) continue;  // not of this program
    const solver::Mechanism* mechanism = solver::find_mechanism(h.name);
    std::string label = h.name;  // a mechanism's title is too long for a narrow page
    std::ranges::replace(label, '_', ' ');
    bars.push_back({label, mechanism != nullptr ? std::string(mechanism->title) : h.name, h.prior,
                    h.probability, h.name == answer.answer, h.in_set, mechanism != nullptr});
  }
  if (bars.empty()) return std::nullopt;
  std::ranges::stable_sort(bars, std::greater{}, &Bar::probability);
  const bool full = std::ranges::count(bars, true, &Bar::in_set) == 1 && answer.reservations.empty();
  return drawn(bars, full, answer.title, Ground::page);
}

}  // namespace cpt::reports::diagnosed

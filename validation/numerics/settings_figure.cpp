#include "validation/numerics/settings_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/depth_plot.hpp"
#include "reports/labels.hpp"
#include "validation/numerics/sentences.hpp"

namespace cpt::validation::numerics {
namespace {

using drawing::Box, drawing::plain, drawing::Point, drawing::Rich, drawing::Svg, drawing::symbolic,
    drawing::XyCurve, drawing::XyPlot;
namespace palette = drawing::palette;

constexpr int panels_across = 3;
constexpr Box first_panel = {46.0, 50.0, 132.0, 110.0};
constexpr double step_across = 186.0, step_down = 164.0;
constexpr double mark = 2.4;

bool is_refinement(const Setting& setting) { return setting.quantity->name == refinement; }

std::string_view color_of(std::size_t window) { return palette::series[window % palette::series.size()]; }

Rich x_title(const Setting& setting) {
  if (is_refinement(setting)) return plain("cell size / baseline's");
  const std::string_view unit = setting.quantity->unit;
  return plain(words(setting) + ", ") + symbolic(setting.quantity->symbol) +
         plain(unit == "-" ? "" : fmt::format(" ({})", unit));
}

// Over two decades and more a linear axis would put all but the largest value at its left end.
bool wants_log(const Setting& setting) {
  return setting.runs.front().value > 0.0 && setting.runs.back().value >= 100.0 * setting.runs.front().value;
}

// The ends of the axis, a little beyond the outermost marks.
std::vector<Point> room_for_marks(const Setting& setting) {
  const double low = setting.runs.front().value, high = setting.runs.back().value;
  if (wants_log(setting)) return {};
  if (is_refinement(setting)) return {{-0.03 / low, 0.0}, {1.03 / low, 0.0}};
  return {{low - 0.03 * (high - low), 0.0}, {high + 0.03 * (high - low), 0.0}};
}

void add_window(XyPlot& plot, const NumericsStudy& study, const Setting& setting, const std::string& window,
                std::string_view color) {
  const auto reference = reference_in(study, window);
  if (!reference) return;
  const auto change = [&](double q_c) { return 100.0 * (q_c / *reference - 1.0); };
  const auto x = [&](double value) { return is_refinement(setting) ? 1.0 / value : value; };
  XyCurve marks{{}, {color, 1.0, {}}, mark};
  for (const Run& run : setting.runs)
    if (const auto q_c = mean_in(study.campaign, run.realization, window))
      marks.points.push_back({x(run.value), change(*q_c)});
  plot.curves.push_back({marks.points, {color, 0.8, {}}});
  plot.curves.push_back(marks);
  if (const auto repeats = repeats_in(study, window)) {
    const double half = 100.0 * results::prediction_half_width(*repeats) / repeats->mean;
    const double from = x(setting.runs.front().value);
    const double to = is_refinement(setting) ? 0.0 : setting.runs.back().value;
    for (const double y : {-half, half}) plot.curves.push_back({{{from, y}, {to, y}}, {color, 0.7, "3 2"}});
  }
  if (!is_refinement(setting)) return;
  const auto triples = mesh_triples(study, window);
  if (!triples.empty() && triples.front().error.order >= results::least_order)
    plot.curves.push_back({{{0.0, change(triples.front().error.extrapolated)}}, {color, 1.0, {}}, mark});
}

}  // namespace

std::string settings_figure(const NumericsStudy& study) {
  const results::Snapshot& campaign = study.campaign;
  const auto panels = static_cast<int>(study.settings.size()) + 1;  // the legend is the last
  const int rows = (panels + panels_across - 1) / panels_across;
  Svg svg(first_panel.x + panels_across * step_across - 4.0, first_panel.y + rows * step_down - 10.0,
          "numerics_" + std::string(campaign.campaign.profile));
  reports::draw_heading(svg, campaign, campaign.campaign.title,
                        {plain(fmt::format("change of the average q")) + Rich{{"c", true}} +
                         plain(" against the mean of the repeats, each setting changed alone")});
  const auto place = [](int panel) {
    return Box{first_panel.x + panel % panels_across * step_across,
               first_panel.y + panel / panels_across * step_down, first_panel.width, first_panel.height};
  };
  int panel = 0;
  for (const Setting& setting : study.settings) {
    XyPlot plot{x_title(setting), plain("change (%)"), {}};
    plot.log_x = wants_log(setting);
    plot.x_ticks = 4;
    plot.room = room_for_marks(setting);
    for (std::size_t w = 0; w < campaign.windows.size(); ++w)
      add_window(plot, study, setting, campaign.windows[w].name, color_of(w));
    draw(svg, place(panel++), plot);
  }
  const Box corner = place(panel);
  reports::Legend legend{svg, corner.x - 20.0, corner.y + 8.0, step_across - 20.0};
  for (std::size_t w = 0; w < campaign.windows.size(); ++w) {
    const results::WindowRow& window = campaign.windows[w];
    legend.dot(plain(window.name + ", " + reports::depth_range(window.from_m, window.to_m)), color_of(w));
    legend.line(plain("repeats, 95 %"), {color_of(w), 0.7, "3 2"});
  }
  legend.dot(plain("at cell size zero: extrapolated, in the color of its window"), palette::ink);
  return svg.document(campaign.campaign.title);
}

}  // namespace cpt::validation::numerics

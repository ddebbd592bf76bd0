#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/prior_range.hpp"
#include "drawing/axis.hpp"
#include "drawing/palette.hpp"
#include "reports/depth_plot.hpp"
#include "reports/diagnosis/figures.hpp"
#include "reports/diagnosis/posterior.hpp"
#include "reports/diagnosis/words.hpp"
#include "reports/labels.hpp"

namespace cpt::reports::diagnosed {
namespace {

using diagnosis::prior_deviation, diagnosis::prior_value;
using drawing::Anchor, drawing::Axis, drawing::Box, drawing::Edge, drawing::plain, drawing::Point,
    drawing::Rich, drawing::Svg, drawing::symbolic;
namespace palette = drawing::palette;

constexpr double side_margin = 20.0, panel_gap = 24.0, posterior_width = 190.0, posterior_height = 120.0,
                 posterior_top = 66.0;
constexpr std::string_view interval_fill = "#f7dcc8";

Rich axis_title(const solver::Quantity& quantity) {
  const std::string unit = unit_after(quantity.unit);
  return symbolic(quantity.symbol) + plain(unit.empty() ? "" : " (" + unit.substr(1) + ")");
}

void draw_panel(Svg& svg, const Box& box, const solver::MechanismParameter& parameter,
                const diagnosis::MechanismEvidence& fit, Index k) {
  const auto [least, greatest] = std::minmax(parameter.prior_lower, parameter.prior_upper);
  const Axis across{least, greatest, box.x, box.right()};
  const auto x_of = [&](double phi) { return across(prior_value(parameter, phi)); };
  const double a = x_of(fit.lower(k)), b = x_of(fit.upper(k));
  svg.rectangle({std::min(a, b), box.y, std::abs(b - a), box.height}, interval_fill);
  draw_horizontal(svg, box, across, Edge::bottom, axis_title(parameter.quantity), 4);

  const Marginal posterior = marginal(fit, k);
  double most = 2.0;  // the prior's density is 1
  for (const double density : posterior.density) most = std::max(most, density);
  const auto y_of = [&](double density) { return box.bottom() - density / (1.1 * most) * box.height; };
  svg.begin_clip(box);
  svg.line({box.x, y_of(1.0)}, {box.right(), y_of(1.0)}, {palette::muted, 1.0, "3 2"});
  std::vector<Point> points;
  // A grid laid around the posterior ends where the density is nil.
  if (!posterior.phi.empty()) {
    points.push_back({x_of(0.0), posterior.phi.front() > 0.02 ? y_of(0.0) : y_of(posterior.density.front())});
    if (posterior.phi.front() > 0.02) points.push_back({x_of(posterior.phi.front()), y_of(0.0)});
    for (std::size_t i = 0; i < posterior.phi.size(); ++i)
      points.push_back({x_of(posterior.phi[i]), y_of(posterior.density[i])});
    if (posterior.phi.back() < 0.98) points.push_back({x_of(posterior.phi.back()), y_of(0.0)});
    points.push_back({x_of(1.0), posterior.phi.back() < 0.98 ? y_of(0.0) : y_of(posterior.density.back())});
  }
  svg.polyline(points, {palette::vermillion, 1.3, {}});
  svg.line({x_of(fit.mean(k)), box.y}, {x_of(fit.mean(k)), box.bottom()}, {palette::ink, 0.8, {}});
  svg.end_clip();
  svg.frame(box, {palette::ink, 0.6, {}});
  const std::string value =
      with_deviation(prior_value(parameter, fit.mean(k)),
                     prior_deviation(parameter, fit.mean(k), fit.deviation(k)), parameter.quantity.unit);
  svg.text({box.x + 0.5 * box.width, box.y - 6.0}, symbolic(parameter.quantity.symbol) + plain(" = " + value),
           {.size = 8.5, .anchor = Anchor::middle, .bold = true});
}

}  // namespace

std::optional<std::string> posterior_figure(const DiagnosisInput& input) {
  if (!input.diagnosis.best) return std::nullopt;
  const std::size_t best = input.diagnosis.best->mechanism;
  const auto& parameters = input.mechanisms[best].parameters;
  if (parameters.empty()) return std::nullopt;
  const auto count = static_cast<double>(parameters.size());
  const double width =
      std::max(420.0, 2.0 * side_margin + count * posterior_width + (count - 1.0) * panel_gap);
  const double across = (width - 2.0 * side_margin - (count - 1.0) * panel_gap) / count;
  Svg svg(width, posterior_top + posterior_height + 58.0, "posterior");
  for (std::size_t k = 0; k < parameters.size(); ++k)
    draw_panel(svg,
               {side_margin + static_cast<double>(k) * (across + panel_gap), posterior_top, across,
                posterior_height},
               parameters[k], input.diagnosis.mechanisms[best].evidence, static_cast<Index>(k));
  draw_heading(svg, shortened(capitalized(title_of(input, best)), width - 16.0, 10.0, true),
               plain("probability density over the ranges that were looked at; mean ± standard deviation"));
  const double y = posterior_top + posterior_height + 46.0;
  Legend(svg, 16.0, y, 110.0).line(plain("with the recording"), {palette::vermillion, 1.3, {}});
  Legend(svg, 136.0, y, 60.0).line(plain("prior"), {palette::muted, 1.0, "3 2"});
  Legend(svg, 206.0, y, 60.0).line(plain("mean"), {palette::ink, 0.8, {}});
  Legend(svg, 276.0, y, 130.0).patch(plain("90 % interval"), interval_fill);
  return svg.document("Parameters of " + title_of(input, best));
}

}  // namespace cpt::reports::diagnosed

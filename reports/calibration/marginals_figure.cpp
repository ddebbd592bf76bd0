#include <algorithm>
#include <cmath>
#include <vector>

#include "drawing/flow_legend.hpp"
#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/calibration/figures.hpp"
#include "reports/calibration/panel_grid.hpp"
#include "reports/labels.hpp"

namespace cpt::reports::calibrated {
namespace {

using drawing::plain, drawing::Point, drawing::Rich, drawing::Svg, drawing::symbolic;
using Eigen::Index;
using Eigen::VectorXd;
namespace palette = drawing::palette;

constexpr int histogram_bins = 30;

struct Histogram {
  double low, high;
};

// Steps of the density of what lies in the range, with all values counted.
std::vector<Point> density(const VectorXd& values, const Histogram& range) {
  std::vector<double> counts(histogram_bins, 0.0);
  const double width = (range.high - range.low) / histogram_bins;
  for (const double value : values) {
    const double bin = std::floor((value - range.low) / width);
    if (bin >= 0.0 && bin < histogram_bins) counts[static_cast<std::size_t>(bin)] += 1.0;
  }
  std::vector<Point> steps{{range.low, 0.0}};
  for (int k = 0; k < histogram_bins; ++k) {
    const double share = counts[static_cast<std::size_t>(k)] / (static_cast<double>(values.size()) * width);
    steps.push_back({range.low + k * width, share});
    steps.push_back({range.low + (k + 1) * width, share});
  }
  steps.push_back({range.high, 0.0});
  return steps;
}

Rich marginal_title(const CalibrationReport& report, std::size_t k) {
  if (k < report.inputs.size()) {
    const ReportedInput& input = report.inputs[k];
    return symbolic(input.symbol) + plain(input.unit == "-" ? "" : " (" + input.unit + ")");
  }
  // "discrepancy q_c", "discrepancy q_c first"
  const std::string& name = report.posterior.unknowns[k].name;
  const std::size_t channel = name.find(' ') + 1, end = std::min(name.find(' ', channel), name.size());
  return plain(name.substr(0, channel)) + symbolic(name.substr(channel, end - channel)) +
         plain(shortened(name.substr(end), 60.0, 8.5) + " (%)");
}

}  // namespace

std::string marginals_figure(const CalibrationReport& report) {
  const PanelGrid grid{report.posterior.unknowns.size()};
  drawing::FlowLegend legend;
  legend.line(plain("prior"), {palette::muted, 1.0, "3 2"});
  legend.line(plain("with the recordings"), {palette::vermillion, 1.3, {}});
  Svg svg(grid.width(), grid.bottom() + 14.0, "marginals");
  for (std::size_t k = 0; k < report.posterior.unknowns.size(); ++k) {
    const auto column = static_cast<Index>(k);
    const VectorXd prior = report.posterior.prior_draws.col(column),
                   found = report.posterior.draws.col(column);
    Histogram range{std::min(prior.minCoeff(), found.minCoeff()),
                    std::max(prior.maxCoeff(), found.maxCoeff())};
    if (!(range.low < range.high)) range.high = range.low + 1.0;
    drawing::XyPlot plot;
    plot.x_title = marginal_title(report, k);
    plot.y_title = plain(k % grid.columns == 0 ? "density" : "");
    plot.x_ticks = plot.y_ticks = 4;
    plot.curves = {{density(prior, range), {palette::muted, 1.0, "3 2"}},
                   {density(found, range), {palette::vermillion, 1.3, {}}}};
    drawing::draw(svg, grid.box(k), plot);
  }
  draw_heading(svg, shortened(report.title, grid.width() - 16.0, 10.0, true),
               plain("what the recordings leave of the inputs and of the deviations beside them"));
  legend.draw(svg, {14.0, grid.bottom()}, grid.width() - 28.0);
  return svg.document("Posterior: " + report.title);
}

}  // namespace cpt::reports::calibrated

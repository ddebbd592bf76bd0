#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/palette.hpp"
#include "reports/depth_plot.hpp"
#include "reports/figures.hpp"
#include "reports/labels.hpp"
#include "reports/push_start_mark.hpp"

namespace cpt::reports {
namespace {

using drawing::Anchor, drawing::Box, drawing::Column, drawing::decimals, drawing::number, drawing::plain,
    drawing::Range, drawing::Rich, drawing::Svg, drawing::symbolic, drawing::TextStyle, drawing::widened;
namespace palette = drawing::palette;

using results::Snapshot;
using results::WindowMeanRow;
using results::WindowRow;

constexpr double wide_inset = 118.0, narrow_inset = 76.0;
constexpr double inset_height = 120.0;
constexpr double inset_pitch = inset_height + 68.0;

struct Inset {
  const WindowRow* window;
  const WindowMeanRow* mean;
};

std::vector<Inset> insets_of(const Snapshot& campaign, int baseline) {
  std::vector<Inset> insets;
  for (const WindowRow& window : campaign.windows)
    for (const WindowMeanRow& mean : campaign.window_means)
      if (mean.realization == baseline && mean.window == window.name) insets.push_back({&window, &mean});
  std::stable_sort(insets.begin(), insets.end(),
                   [](const Inset& a, const Inset& b) { return a.window->from_m < b.window->from_m; });
  return insets;
}

/// Tops of the insets: each at its window's depth as far as those above and the plot's ends leave room.
std::vector<double> beside_windows(const std::vector<Inset>& insets, const DepthPlot& whole) {
  std::vector<double> tops;
  double least = whole.box.y;
  double most = whole.box.bottom() - inset_height - inset_pitch * (static_cast<double>(insets.size()) - 1.0);
  for (const Inset& inset : insets) {
    const double middle = whole.depth(0.5 * (inset.window->from_m + inset.window->to_m));
    tops.push_back(std::clamp(middle - 0.5 * inset_height, least, std::max(least, most)));
    least = tops.back() + inset_pitch;
    most += inset_pitch;
  }
  return tops;
}

/// The window's depths with as much again above and below, and the q_c found there.
DepthPlot enlarged(const solver::DepthProfile& profile, const Inset& inset, const Box& box) {
  const double thickness = inset.window->to_m - inset.window->from_m;
  const double from = std::max(inset.window->from_m - thickness, 0.0);
  const double to =
      std::min(inset.window->to_m + thickness, std::max(profile.depth.back(), inset.window->to_m));
  double least = inset.mean->q_c_min_kPa;
  double largest = inset.mean->q_c_max_kPa;
  for (std::size_t i = 0; i < profile.depth.size(); ++i) {
    const double q = profile.q_c[i] / 1.0e3;
    if (profile.depth[i] < from || profile.depth[i] > to || !std::isfinite(q)) continue;
    least = std::min(least, q);
    largest = std::max(largest, q);
  }
  const Range q = widened(least, largest, 0.15);
  return {box, {q.low, q.high, box.x, box.right()}, {from, to, box.y, box.bottom()}};
}

void draw_inset(Svg& svg, const Snapshot& campaign, const solver::DepthProfile& profile, const Inset& inset,
                const DepthPlot& whole, const Box& box, bool narrow) {
  const DepthPlot plot = enlarged(profile, inset, box);
  // Two thin lines tie the inset to its place on the profile.
  const double middle = whole.depth(0.5 * (inset.window->from_m + inset.window->to_m));
  for (const double y : {box.y, box.bottom()})
    if (!narrow) svg.line({whole.box.right() + 4.5, middle}, {box.x - 40.0, y}, {palette::faint, 0.5, {}});
  svg.text({box.x - 34.0, box.y - 32.0},
           plain(shortened(inset.window->name, box.right() - box.x + 34.0, 8.0, true)),
           {.size = 8.0, .bold = true});
  plot.draw_ground(svg, campaign.layers, narrow ? 2 : 3, 4);
  svg.rectangle({box.x, plot.depth(inset.window->from_m), box.width,
                 plot.depth(inset.window->to_m) - plot.depth(inset.window->from_m)},
                palette::sky, 0.3);
  svg.begin_clip(box);
  plot.draw_curve(svg, profile, {palette::ink, 0.9, {}});
  svg.end_clip();
  mark_start(svg, plot, profile);
  const double x = plot.q_c(inset.mean->q_c_mean_kPa);
  svg.line({x, plot.depth(inset.window->from_m)}, {x, plot.depth(inset.window->to_m)},
           {palette::vermillion, 1.4, {}});
  plot.draw_frame(svg);
  const double noise = (inset.mean->q_c_max_kPa - inset.mean->q_c_min_kPa) / inset.mean->q_c_max_kPa;
  const Rich average = symbolic("average q_c ") + plain(number(inset.mean->q_c_mean_kPa, 4) + " kPa"),
             index = symbolic("SI_noise ") + plain(decimals(noise, 4));
  const TextStyle style{.size = 7.0, .anchor = Anchor::end};
  svg.text({box.right(), box.bottom() + 11.0}, narrow ? average : average + plain(", ") + index, style);
  if (narrow) svg.text({box.right(), box.bottom() + 20.0}, index, style);
}

}  // namespace

std::optional<std::string> baseline_figure(const Snapshot& campaign, Column column) {
  const double figure_width = width_of(column);
  const bool narrow = column == Column::single;
  const double inset_width = narrow ? narrow_inset : wide_inset,
               inset_left = figure_width - inset_width - 14.0;
  const results::RealizationRow* baseline = baseline_run(campaign);
  const solver::DepthProfile* profile = baseline != nullptr ? curve_of(campaign, baseline->id) : nullptr;
  if (profile == nullptr) return std::nullopt;
  const std::vector<Inset> insets = insets_of(campaign, baseline->id);

  const double lines = all_completed(campaign) ? 1.0 : 2.0;
  const double head = 23.0 + 12.5 * lines + 40.0;
  const double plot_height = std::max(300.0, inset_pitch * static_cast<double>(insets.size()) - 52.0);
  Svg svg(figure_width, head + plot_height + 22.0, "baseline");
  const double top = draw_heading(svg, campaign, campaign.campaign.title,
                                  {symbolic("baseline q_c over depth; windows enlarged at the right")});
  const Box box{50.0, top + 36.0, inset_left - 118.0 + (narrow ? 26.0 : 0.0), plot_height};
  const DepthPlot whole = whole_profile(campaign, {{baseline->id, *profile}}, box);
  whole.draw_ground(svg, campaign.layers, narrow ? 2 : 3);
  svg.begin_clip(box);
  whole.draw_curve(svg, *profile, {palette::ink, 0.9, {}});
  svg.end_clip();
  mark_start(svg, whole, *profile);
  whole.draw_frame(svg);
  const std::vector<double> tops = beside_windows(insets, whole);
  for (std::size_t i = 0; i < insets.size(); ++i) {
    whole.draw_window_mark(svg, *insets[i].window);
    draw_inset(svg, campaign, *profile, insets[i], whole, {inset_left, tops[i], inset_width, inset_height},
               narrow);
  }
  return svg.document("Baseline: " + campaign.campaign.title);
}

}  // namespace cpt::reports

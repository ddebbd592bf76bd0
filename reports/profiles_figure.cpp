#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "drawing/palette.hpp"
#include "reports/depth_plot.hpp"
#include "reports/figures.hpp"
#include "reports/labels.hpp"
#include "reports/push_start_mark.hpp"

namespace cpt::reports {
namespace {

using drawing::Box, drawing::Column, drawing::plain, drawing::Svg, drawing::symbolic;
namespace palette = drawing::palette;

using results::RealizationRow;
using results::Snapshot;

constexpr double profiles_legend_width = 130.0;
constexpr double profiles_height = 330.0;

/// Completed realizations by their largest relative distance from the baseline in any window, furthest first.
std::vector<int> furthest_from_baseline(const Snapshot& campaign, const RealizationRow* baseline,
                                        std::size_t count) {
  std::map<std::string, double> base;
  for (const auto& mean : campaign.window_means)
    if (baseline != nullptr && mean.realization == baseline->id) base[mean.window] = mean.q_c_mean_kPa;
  std::map<int, double> distance;
  for (const auto& mean : campaign.window_means) {
    const auto at = base.find(mean.window);
    if (at == base.end() || mean.realization == baseline->id || at->second == 0.0) continue;
    double& d = distance[mean.realization];
    d = std::max(d, std::abs(mean.q_c_mean_kPa / at->second - 1.0));
  }
  std::vector<std::pair<int, double>> ranked(distance.begin(), distance.end());
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<int> ids;
  for (const auto& [id, d] : ranked)
    if (ids.size() < count) ids.push_back(id);
  return ids;
}

}  // namespace

std::optional<std::string> profiles_figure(const Snapshot& campaign, Column column) {
  const double figure_width = width_of(column);
  const bool narrow = column == Column::single;  // its legend lies below
  if (campaign.curves.empty()) return std::nullopt;
  const RealizationRow* baseline = baseline_run(campaign);
  const std::vector<int> marked = furthest_from_baseline(campaign, baseline, palette::series.size());
  const auto rank = [&](int id) { return std::find(marked.begin(), marked.end(), id) - marked.begin(); };

  const double lines = all_completed(campaign) ? 1.0 : 2.0;
  const auto entries = static_cast<double>(
      marked.size() + 3 +  // baseline, others, window
      static_cast<std::size_t>(std::ranges::any_of(campaign.realizations, &RealizationRow::failed)) +
      static_cast<std::size_t>(campaign.layers.size() > 1));
  const double below = narrow ? Legend::pitch * entries + 8.0 : 0.0;
  Svg svg(figure_width, 23.0 + 12.5 * lines + 40.0 + profiles_height + 14.0 + below, "profiles");
  const double top =
      draw_heading(svg, campaign, campaign.campaign.title, {symbolic("q_c of all realizations over depth")});
  const Box plot{50.0, top + 36.0, figure_width - 64.0 - (narrow ? 0.0 : profiles_legend_width),
                 profiles_height};
  const DepthPlot axes = whole_profile(campaign, campaign.curves, plot);
  axes.draw_ground(svg, campaign.layers);

  svg.begin_clip(plot);
  int others = 0;
  int partial = 0;
  for (const results::CurveRow& curve : campaign.curves) {
    const auto& run = *std::find_if(campaign.realizations.begin(), campaign.realizations.end(),
                                    [&](const RealizationRow& r) { return r.id == curve.realization; });
    if (&run == baseline || rank(run.id) < static_cast<long>(marked.size())) continue;
    (run.completed() ? others : partial) += 1;
    axes.draw_curve(svg, curve.profile, {palette::faint, 0.7, run.completed() ? "" : "2 1.5"});
  }
  for (std::size_t k = marked.size(); k-- > 0;)  // the furthest on top
    axes.draw_curve(svg, *curve_of(campaign, marked[k]), {palette::series[k], 1.0, {}});
  const solver::DepthProfile* base = baseline != nullptr ? curve_of(campaign, baseline->id) : nullptr;
  if (base != nullptr) axes.draw_curve(svg, *base, {palette::ink, 1.4, {}});
  svg.end_clip();
  mark_start(svg, axes, base != nullptr ? *base : campaign.curves.front().profile);
  axes.draw_frame(svg);

  Legend legend{svg, narrow ? plot.x : plot.right() + 12.0, narrow ? plot.bottom() + 14.0 : plot.y + 6.0,
                narrow ? plot.width : profiles_legend_width - 2.0};
  if (base != nullptr) legend.line(plain("baseline"), {palette::ink, 1.4, {}});
  for (std::size_t k = 0; k < marked.size(); ++k) {
    const auto& run = *std::find_if(campaign.realizations.begin(), campaign.realizations.end(),
                                    [&](const RealizationRow& r) { return r.id == marked[k]; });
    legend.line(run_label(campaign, run), {palette::series[k], 1.0, {}});
  }
  if (others > 0)
    legend.line(plain(fmt::format("{} other{}", others, others == 1 ? "" : "s")), {palette::faint, 0.7, {}});
  if (partial > 0)
    legend.line(plain(fmt::format("{} failed on the way", partial)), {palette::faint, 0.7, "2 1.5"});
  for (const SoilTint& tint : axes.tinted(campaign.layers)) legend.patch(plain(tint.soil), tint.colour);
  legend.gap();
  for (const results::WindowRow& window : campaign.windows) axes.draw_window_mark(svg, window);
  if (std::any_of(campaign.windows.begin(), campaign.windows.end(),
                  [](const auto& w) { return w.problem.empty(); }))
    legend.mark(plain("depth window"));
  return svg.document("q_c profiles: " + campaign.campaign.title);
}

}  // namespace cpt::reports

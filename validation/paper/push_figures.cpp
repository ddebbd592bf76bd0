#include <fmt/format.h>

#include <array>

#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/depth_plot.hpp"
#include "reports/labels.hpp"
#include "reports/units.hpp"
#include "validation/paper/figures.hpp"

namespace cpt::validation::paper {
namespace {

using drawing::Box, drawing::Pen, drawing::plain, drawing::Svg, drawing::symbolic, drawing::XyCurve,
    drawing::XyPlot;
using reports::draw_heading, reports::kPa, reports::Legend, reports::MPa, reports::NamedFigure;
namespace palette = drawing::palette;

using results::Histories;

constexpr std::array distance_labels = {"1 cone radius", "2 cone radii", "3 cone radii"};
constexpr std::string_view dashed = "3 2";

XyCurve path(const results::PointHistory& point, const Pen& pen) {
  XyCurve curve{{}, pen};
  const auto& p = point.columns.at("p").values;
  const auto& q = point.columns.at("q").values;
  for (std::size_t i = 0; i < p.size(); ++i) curve.points.push_back({p[i] / MPa, q[i] / MPa});
  return curve;
}

// The paths of both stresses behind one wall, alike in all points.
XyPlot paths(const Push& low, const Push& high) {
  XyPlot plot{symbolic("p' (MPa)"), plain("q (MPa)"), {}};
  plot.room = {{0.0, 0.0}};
  for (const Push* push : {&low, &high})
    for (std::size_t i = 0; i < std::min(distance_labels.size(), push->histories->points.size()); ++i)
      plot.curves.push_back(path(push->histories->points[i],
                                 {palette::series[i], 0.9, push == &low ? std::string_view{} : dashed}));
  return plot;
}

std::optional<std::string> stress_path_figure(const Pushes& pushes) {
  for (const Push* push : {&pushes.rigid, &pushes.rigid_90, &pushes.flexible, &pushes.flexible_90})
    if (!push->histories || push->histories->points.empty()) return std::nullopt;
  Svg svg(560.0, 300.0, "stress_paths");
  draw_heading(svg, "Stress paths beside the cone",
               plain(fmt::format("from {:g} m deep, ", pushes.rigid.histories->points[0].wanted.depth)) +
                   symbolic("sand of D_R = 60 %, σ'_v0 = 100 kPa"));
  XyPlot rigid = paths(pushes.rigid, pushes.rigid_90), flexible = paths(pushes.flexible, pushes.flexible_90);
  for (const XyCurve& curve : flexible.curves)  // the same axes for both
    rigid.room.insert(rigid.room.end(), curve.points.begin(), curve.points.end());
  for (const XyCurve& curve : rigid.curves)
    flexible.room.insert(flexible.room.end(), curve.points.begin(), curve.points.end());
  const Box left{46.0, 58.0, 180.0, 200.0}, right{272.0, 58.0, 180.0, 200.0};
  draw(svg, left, rigid);
  draw(svg, right, flexible);
  svg.text({left.x, left.y - 6.0}, plain("rigid wall"), {.size = 8.0, .bold = true});
  svg.text({right.x, right.y - 6.0}, plain("flexible wall"), {.size = 8.0, .bold = true});
  Legend legend{svg, right.right() + 10.0, right.y + 6.0, 96.0};
  for (std::size_t i = 0; i < distance_labels.size(); ++i)
    legend.line(plain(distance_labels[i]), {palette::series[i], 1.2, {}});
  legend.gap();
  legend.line(symbolic("σ'_h0 = 50 kPa"), {palette::ink, 0.9, {}});
  legend.line(symbolic("σ'_h0 = 90 kPa"), {palette::ink, 0.9, dashed});
  return svg.document("Stress paths beside the cone");
}

std::optional<std::string> wall_figure(const Push& push) {
  if (!push.histories || push.histories->walls.empty()) return std::nullopt;
  const Histories& h = *push.histories;
  Svg svg(560.0, 250.0, "wall");
  draw_heading(svg, "Stresses at the rigid wall during the push",
               symbolic("sand of D_R = 60 %, σ'_v0 = 100 kPa, σ'_h0 = 50 kPa"));
  XyPlot vertical{plain("depth of the tip (m)"), symbolic("σ'_v (kPa)"), {}};
  XyPlot horizontal{plain("depth of the tip (m)"), symbolic("σ'_h (kPa)"), {}};
  XyPlot ratio{plain("depth of the tip (m)"), symbolic("σ'_h/σ'_v"), {}};
  vertical.room = horizontal.room = {{0.0, 0.0}};
  ratio.room = {{0.0, 0.0}, {0.0, 1.0}};
  for (std::size_t w = 0; w < h.walls.size(); ++w) {
    const Pen pen{palette::series[w % palette::series.size()], 1.0, {}};
    XyCurve v{{}, pen}, r{{}, pen}, both{{}, pen};
    for (std::size_t i = 0; i < h.tip_depth.size(); ++i) {
      const double sigma_v = h.walls[w].columns.at("sigma_v").values[i];
      const double sigma_r = h.walls[w].columns.at("sigma_r").values[i];
      v.points.push_back({h.tip_depth[i], sigma_v / kPa});
      r.points.push_back({h.tip_depth[i], sigma_r / kPa});
      both.points.push_back({h.tip_depth[i], sigma_r / sigma_v});
    }
    vertical.curves.push_back(std::move(v));
    horizontal.curves.push_back(std::move(r));
    ratio.curves.push_back(std::move(both));
  }
  double x = 46.0;
  for (XyPlot* plot : {&vertical, &horizontal, &ratio}) {
    plot->x_ticks = 3;
    draw(svg, {x, 60.0, 130.0, 150.0}, *plot);
    x += 180.0;
  }
  x = 46.0;
  for (std::size_t w = 0; w < h.walls.size(); ++w, x += 130.0) {
    Legend legend{svg, x, 46.0, 130.0};
    legend.line(plain(fmt::format("{:g} to {:g} m deep", h.walls[w].between.from, h.walls[w].between.to)),
                {palette::series[w % palette::series.size()], 1.0, {}});
  }
  return svg.document("Stresses at the rigid wall");
}

}  // namespace

std::vector<NamedFigure> push_figures(const Pushes& pushes) {
  const bool ended = pushes.rigid.histories && !pushes.rigid.histories->end.r.empty();
  const auto at_end = [&](std::string (*figure)(const Histories&)) {
    return ended ? std::optional(figure(*pushes.rigid.histories)) : std::nullopt;
  };
  return {
      {"stress_paths",
       "Stress paths of material points that started at 1, 2 and 3 cone radii from the axis, behind either "
       "wall, for both initial horizontal stresses (Fig. 14).",
       stress_path_figure(pushes)},
      {"wall_stresses",
       "Vertical and horizontal stress beside the rigid wall and their ratio during the push (Fig. 15).",
       wall_figure(pushes.rigid)},
      {"void_ratio_profile", "Void ratio at the end of the push by distance from the axis (section 6.3.2).",
       at_end(void_ratio_profile_figure)},
      {"void_ratio_map", "Change of the void ratio over the whole push (section 6.3.2).",
       at_end(void_ratio_map_figure)}};
}

}  // namespace cpt::validation::paper

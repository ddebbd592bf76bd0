#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/depth_plot.hpp"
#include "reports/labels.hpp"
#include "validation/paper/compare.hpp"
#include "validation/paper/figures.hpp"
#include "validation/paper/published.hpp"
#include "validation/paper/push_measures.hpp"

namespace cpt::validation::paper {
namespace {

using drawing::Axis, drawing::Box, drawing::Edge, drawing::Pen, drawing::plain, drawing::Point, drawing::Svg,
    drawing::symbolic, drawing::XyCurve, drawing::XyPlot;
using reports::draw_heading, reports::Legend;
namespace palette = drawing::palette;

using results::Histories;

// Classes of the change of void ratio, each up to its bound: "RdBu" of Brewer (2003), safe for colour-blind
// readers. Blue is contraction, red dilation.
struct Shade {
  double up_to;
  std::string_view color;
};
constexpr std::array shades = {Shade{-0.020, "#2166ac"},  Shade{-0.010, "#67a9cf"}, Shade{-0.003, "#d1e5f0"},
                               Shade{0.003, "#f7f7f7"},   Shade{0.010, "#fddbc7"},  Shade{0.020, "#ef8a62"},
                               Shade{INFINITY, "#b2182b"}};

std::string_view color_of(double change) {
  for (const Shade& shade : shades)
    if (change <= shade.up_to) return shade.color;
  return shades.back().color;
}

// Mean change of void ratio in square cells, row by row from the top.
class Cells {
 public:
  Cells(const results::SoilAtEnd& soil, double size) {
    double r = 0.0, depth = 0.0;
    for (std::size_t k = 0; k < soil.r.size(); ++k)
      r = std::max(r, soil.r[k]), depth = std::max(depth, soil.depth[k]);
    columns_ = static_cast<std::size_t>(r / size) + 1;
    rows_ = static_cast<std::size_t>(depth / size) + 1;
    sums_.resize(columns_ * rows_);
    for (std::size_t k = 0; k < soil.r.size(); ++k) {
      if (soil.depth[k] < 0.0) continue;
      Sum& sum = sums_[static_cast<std::size_t>(soil.depth[k] / size) * columns_ +
                       static_cast<std::size_t>(soil.r[k] / size)];
      sum.volume += soil.volume[k];
      sum.change += soil.volume[k] * (soil.void_ratio[k] - soil.void_ratio_start[k]);
    }
  }

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Of the nearest cell of the row that holds a point; NaN if none does.
  [[nodiscard]] double operator()(std::size_t row, std::size_t column) const {
    for (std::size_t away = 0; away < columns_; ++away)
      for (const std::size_t c : {column + away, column - away}) {  // below zero it wraps around, far out
        if (c >= columns_) continue;
        const Sum& sum = sums_[row * columns_ + c];
        if (sum.volume > 0.0) return sum.change / sum.volume;
      }
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  struct Sum {
    double volume = 0.0, change = 0.0;
  };
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<Sum> sums_;
};

// One rectangle for each run of cells of a colour.
void draw_cells(Svg& svg, const Cells& cells, double size, const Axis& r, const Axis& depth) {
  for (std::size_t row = 0; row < cells.rows(); ++row) {
    const double top = depth(size * static_cast<double>(row));
    const double bottom = depth(size * static_cast<double>(row + 1));
    for (std::size_t from = 0, to = 0; from < cells.columns(); from = to) {
      const std::string_view color = color_of(cells(row, from));
      while (to < cells.columns() && color_of(cells(row, to)) == color) ++to;
      const double left = r(size * static_cast<double>(from));
      // A little lower than the cell, or thin white lines would show between rows.
      svg.rectangle({left, top, r(size * static_cast<double>(to)) - left, bottom - top + 0.3}, color);
    }
  }
}

void draw_penetrometer(Svg& svg, double tip_depth, const Axis& r, const Axis& depth) {
  const double shoulder = tip_depth - std::sqrt(3.0) * cone_radius;  // 60 degrees at the apex
  const std::array outline = {Point{r(0.0), depth(0.0)}, Point{r(cone_radius), depth(0.0)},
                              Point{r(cone_radius), depth(shoulder)}, Point{r(0.0), depth(tip_depth)}};
  svg.polygon(outline, palette::muted);
}

}  // namespace

std::string void_ratio_profile_figure(const Histories& push) {
  const results::DepthInterval between = middle_half(push);
  Svg svg(640.0, 290.0, "void_ratio_profile");
  draw_heading(svg, "Void ratio at the end of the push",
               plain(fmt::format("rings over {:.2f} to {:.2f} m depth, ", between.from, between.to)) +
                   symbolic("D_R = 60 %, σ'_v0 = 100 kPa, rigid wall; right: without the dilation"));
  const Pen start{palette::muted, 0.9, "4 2"}, mean{palette::ink, 1.2, {}}, extremes{palette::sky, 0.7, {}};
  const Pen theirs{palette::vermillion, 0.9, "2 2"};
  XyCurve before{{}, start}, after{{}, mean}, least{{}, extremes}, largest{{}, extremes};
  for (const results::Ring& ring : void_ratio_rings(push)) {
    before.points.push_back({ring.r, ring.void_ratio_start});
    after.points.push_back({ring.r, ring.void_ratio});
    least.points.push_back({ring.r, ring.void_ratio_min});
    largest.points.push_back({ring.r, ring.void_ratio_max});
  }
  const double outermost = after.points.empty() ? 0.0 : after.points.back().x;
  XyPlot whole{plain("distance from the axis (m)"), plain("e"), {}};
  whole.room = {{0.0, least_void_ratio.value}};
  whole.curves = {least, largest, before, after};
  XyPlot contraction = whole;
  for (XyCurve& curve : contraction.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      if (curve.points[i].y > before.points[i].y + 0.002)
        curve.points[i].y = std::numeric_limits<double>::quiet_NaN();
  const double top = before.points.empty() ? 1.0 : before.points.front().y;
  contraction.curves.push_back(
      {{{altered_to.value, least_void_ratio.value}, {altered_to.value, top}}, theirs});
  contraction.curves.push_back(
      {{{0.0, least_void_ratio.value}, {outermost, least_void_ratio.value}}, theirs});
  const Box left{52.0, 44.0, 190.0, 205.0}, right{302.0, 44.0, 190.0, 205.0};
  draw(svg, left, whole);
  draw(svg, right, contraction);
  Legend legend{svg, right.right() + 12.0, right.y + 6.0, 130.0};
  legend.line(plain("at the start"), start);
  legend.line(plain("at the end, mean"), mean);
  legend.line(plain("least, largest point"), extremes);
  legend.line(plain(fmt::format("paper: {:g} m; {:g}", altered_to.value, least_void_ratio.value)), theirs);
  return svg.document("Void ratio at the end of the push");
}

std::string void_ratio_map_figure(const Histories& push) {
  constexpr double size = cone_radius;  // [m] of a cell
  const Cells cells(push.end, size);
  const double width = size * static_cast<double>(cells.columns());
  const double height = size * static_cast<double>(cells.rows());
  constexpr double scale = 400.0;  // points per metre
  const Box box{52.0, 44.0, scale * width, scale * height};
  Svg svg(box.right() + 140.0, box.bottom() + 34.0, "void_ratio_map");
  draw_heading(svg, "Change of the void ratio", symbolic("D_R = 60 %, σ'_v0 = 100 kPa, rigid wall"));
  const Axis r{0.0, width, box.x, box.right()}, depth{0.0, height, box.y, box.bottom()};
  draw_horizontal(svg, box, r, Edge::bottom, plain("distance from the axis (m)"), 5);
  draw_vertical(svg, box, depth, plain("depth (m)"), 8);
  svg.begin_clip(box);
  draw_cells(svg, cells, size, r, depth);
  draw_penetrometer(svg, push.tip_depth.back(), r, depth);
  svg.end_clip();
  svg.frame(box, {palette::ink, 0.6, {}});
  Legend legend{svg, box.right() + 12.0, box.y + 6.0, 125.0};
  for (std::size_t i = shades.size(); i-- > 0;) {
    const bool last = i + 1 == shades.size();
    const std::string text =
        last     ? fmt::format("above {}", with_sign(shades[i - 1].up_to, 3))
        : i == 0 ? fmt::format("below {}", with_sign(shades[i].up_to, 3))
                 : fmt::format("{} to {}", with_sign(shades[i - 1].up_to, 3), with_sign(shades[i].up_to, 3));
    legend.patch(plain(text), shades[i].color);
  }
  return svg.document("Change of the void ratio");
}

}  // namespace cpt::validation::paper

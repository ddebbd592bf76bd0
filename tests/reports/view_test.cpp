// A view of a push: colours of known values, points to pixels, and the pixels of a whole frame.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reports/view/frame.hpp"

namespace cpt::reports::view {
namespace {

using drawing::Box, drawing::Picture, drawing::Tick;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ColourMaps, HaveTheirPublishedColours) {
  EXPECT_EQ(hex(colour_at(ColourMap::viridis, 0.0)), "#440154");
  EXPECT_EQ(hex(colour_at(ColourMap::viridis, 1.0)), "#fde725");
  EXPECT_EQ(hex(colour_at(ColourMap::viridis, 50.0 / 255.0)), "#414287");
  EXPECT_EQ(hex(colour_at(ColourMap::magma, 0.0)), "#fcfdbf");
  EXPECT_EQ(hex(colour_at(ColourMap::magma, 1.0)), "#000004");
  EXPECT_EQ(hex(colour_at(ColourMap::red_blue, 0.0)), "#053061");
  EXPECT_EQ(hex(colour_at(ColourMap::red_blue, 0.5)), "#f7f7f7");
  EXPECT_EQ(hex(colour_at(ColourMap::red_blue, 7.0)), "#67001f");
}

// Lightness as in CIE 1976 L*a*b*, from sRGB (IEC 61966-2-1).
double lightness(Colour colour) {
  const auto linear = [](std::uint8_t part) {
    const double c = part / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(ColourMaps, OrderIsSeenWithoutColours) {
  for (int i = 1; i < shades; ++i) {
    const double before = (i - 0.5) / shades, here = (i + 0.5) / shades;
    EXPECT_GT(lightness(shade_at(ColourMap::viridis, here)), lightness(shade_at(ColourMap::viridis, before)));
    EXPECT_LT(lightness(shade_at(ColourMap::magma, here)), lightness(shade_at(ColourMap::magma, before)));
  }
}

TEST(ColourScale, ValuesGoToTheirShades) {
  const ColourScale linear{ColourMap::viridis, ScaleKind::linear, 0.5, 0.9};
  EXPECT_DOUBLE_EQ(linear.place(0.7), 0.5);
  EXPECT_EQ(linear.place(0.4), 0.0);
  EXPECT_EQ(linear(2.0), colour_at(ColourMap::viridis, 1.0));
  EXPECT_EQ(linear(nan), no_value);

  const ColourScale log{ColourMap::viridis, ScaleKind::log, 10.0, 1000.0};
  EXPECT_DOUBLE_EQ(log.place(100.0), 0.5);
  EXPECT_EQ(log.place(0.0), 0.0);
  EXPECT_EQ(log.place(-5.0), 0.0);
  EXPECT_EQ(log(100.0), colour_at(ColourMap::viridis, 0.5)) << "31 of 0 to 62";

  const ColourScale diverging{ColourMap::red_blue, ScaleKind::diverging, -0.1, 0.1};
  EXPECT_EQ(hex(diverging(0.0)), "#f7f7f7") << "no change is white";
}

std::vector<std::string> labels(const ColourScale& scale) {
  std::vector<std::string> all;
  for (const Tick& tick : scale.ticks(5)) all.push_back(tick.label);
  return all;
}

TEST(ColourScale, TicksOfALogarithmicScale) {
  const auto log = [](double low, double high) {
    return labels({ColourMap::viridis, ScaleKind::log, low, high});
  };
  EXPECT_EQ(log(20.0, 200.0), (std::vector<std::string>{"20", "50", "100", "200"}));
  EXPECT_EQ(log(5.0, 5000.0), (std::vector<std::string>{"10", "100", "1000"}));
}

TEST(ColourScale, IsFittedToTheAreaButForAFewOddPoints) {
  std::vector<Weighted> values;
  for (int i = 0; i <= 1000; ++i) values.push_back({0.6 + i * 1e-4, 1.0});
  values.push_back({50.0, 1.0});
  values.push_back({nan, 100.0});
  values.push_back({-3.0, 0.0});
  const ColourScale linear = fitted(ColourMap::viridis, ScaleKind::linear, values);
  EXPECT_DOUBLE_EQ(linear.low, 0.6);
  EXPECT_DOUBLE_EQ(linear.high, 0.7);

  for (Weighted& one : values) one.value *= 100.0;
  const ColourScale log = fitted(ColourMap::viridis, ScaleKind::log, values);
  EXPECT_DOUBLE_EQ(log.low, 50.0);
  EXPECT_DOUBLE_EQ(log.high, 100.0);

  const ColourScale change =
      fitted(ColourMap::red_blue, ScaleKind::diverging, {{-0.07, 1.0}, {0.0, 1.0}, {0.03, 1.0}});
  EXPECT_DOUBLE_EQ(change.high, 0.07);
  EXPECT_DOUBLE_EQ(change.low, -change.high);

  const ColourScale none = fitted(ColourMap::viridis, ScaleKind::linear, {{nan, 1.0}});
  EXPECT_LT(none.low, none.high);
  const ColourScale one = fitted(ColourMap::viridis, ScaleKind::linear, {{0.7, 1.0}});
  EXPECT_LT(one.low, one.high);
}

constexpr std::size_t sand = 0, clay = 1, surcharge = 2;

// Points on a square lattice over a box; one field, and the two displacements that a view adds, at rest.
void fill(DrawnPoints& points, double r_from, double r_to, double from, double to, double spacing,
          std::size_t material, double value) {
  points.fields.resize(3);
  points.soils = 2;
  const int columns = static_cast<int>(std::round((r_to - r_from) / spacing));
  const int rows = static_cast<int>(std::round((to - from) / spacing));
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      points.r.push_back(r_from + (i + 0.5) * spacing);
      points.depth.push_back(from + (j + 0.5) * spacing);
      points.size.push_back(spacing);
      points.material.push_back(material);
      points.fields[0].push_back(value);
      points.fields[1].push_back(0.0);
      points.fields[2].push_back(0.0);
    }
}

TEST(Raster, PixelsHaveTheValueOfTheirSoilAndItsBoundaryIsSharp) {
  DrawnPoints points;
  fill(points, 0.0, 0.1, 0.0, 0.1, 0.005, sand, 0.75);
  fill(points, 0.0, 0.1, 0.1, 0.2, 0.005, clay, 0.25);
  const Raster raster(points, {0.1, 0.0, 0.2}, 50, 100);
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 50; ++column) {
      EXPECT_EQ(raster.material(column, row), row < 50 ? sand : clay);
      EXPECT_FLOAT_EQ(static_cast<float>(raster.value(0, column, row)), row < 50 ? 0.75F : 0.25F);
    }
  EXPECT_NEAR(raster.first_or_second({sand, clay}, 25, 10), 1.0, 1e-6);
  EXPECT_NEAR(raster.first_or_second({sand, clay}, 25, 90), -1.0, 1e-6);
}

TEST(Raster, IsTheAverageWeightedWithEachPointsOwnGaussian) {
  DrawnPoints points;
  points.r = {0.010, 0.022};
  points.depth = {0.020, 0.023};
  points.size = {0.010, 0.020};
  points.material = {sand, sand};
  points.soils = 2;
  points.fields = {{1.0, 5.0}};
  const Raster raster(points, {0.04, 0.0, 0.04}, 40, 40);  // pixels of 1 mm
  double weights = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double width = 0.7 * points.size[k];
    const double away = std::hypot(0.0145 - points.r[k], 0.0205 - points.depth[k]);
    const double weight = std::exp(-0.5 * away * away / (width * width));
    weights += weight;
    sum += weight * points.fields[0][k];
  }
  EXPECT_NEAR(raster.value(0, 14, 20), sum / weights, 1e-5);
}

TEST(Raster, NothingIsWhereNoPointIs) {
  DrawnPoints points;
  fill(points, 0.05, 0.1, 0.05, 0.1, 0.005, sand, nan);
  const Raster raster(points, {0.1, 0.0, 0.2}, 50, 100);
  EXPECT_FALSE(raster.material(5, 10));
  EXPECT_TRUE(std::isnan(raster.value(0, 5, 10)));
  EXPECT_TRUE(std::isnan(raster.first_or_second({sand, clay}, 5, 10)));
  EXPECT_EQ(raster.material(35, 35), sand);
  EXPECT_TRUE(std::isnan(raster.value(0, 35, 35))) << "sand, but without this quantity";
}

View a_view(const char* quantity, ColourScale scale) {
  View view;
  view.title = "Sand";
  view.geometry = {0.0127, 0.022, 0.09, 0.45, 1.0, false, {{0.0, 1.0, "sand"}}, 2};
  view.profile = {{0.1, 0.2, 0.3}, {1e6, 2e6, 3e6}, {0.0, 0.0, 0.0}};
  view.radius = 0.1;
  view.panels = {{find_view_quantity(quantity), scale}};
  view.width = 500;
  return view;
}

TEST(Frame, PanelShowsKnownValuesInTheirExactColours) {
  const ColourScale scale{ColourMap::viridis, ScaleKind::log, 10.0, 1000.0};
  const View view = a_view("p", scale);
  const Layout layout = layout_of(view);
  const double tip = 0.2;
  const Window window = window_at(view.geometry, view.radius, tip);
  DrawnPoints points;
  fill(points, 0.0, 0.06, 0.1, 0.4, 0.002, sand, 50.0);
  fill(points, 0.06, 0.12, 0.1, 0.4, 0.002, sand, 400.0);

  const Picture picture = drawing::render(frame(view, layout, tip, points), 72.0 * layout.pixels_per_point);
  EXPECT_EQ(picture.width, 500);
  const auto pixel = [&](double r, double depth) {
    const Box& box = layout.panels[0];
    const double x = box.x + r / window.radius * box.width;
    const double y = box.y + (depth - window.top) / (window.bottom - window.top) * box.height;
    return picture.at(static_cast<int>(x * layout.pixels_per_point),
                      static_cast<int>(y * layout.pixels_per_point));
  };
  for (const double depth : {0.15, 0.2, 0.3}) {
    EXPECT_EQ(pixel(0.03, depth), scale(50.0).value()) << depth;
    EXPECT_EQ(pixel(0.08, depth), scale(400.0).value()) << depth;
  }
  EXPECT_EQ(pixel(0.005, 0.25), scale(50.0).value()) << "below the tip";
  EXPECT_NE(pixel(0.005, 0.15), scale(50.0).value()) << "the penetrometer";
}

TEST(Frame, SurchargeAndEmptyPlacesHaveNoColourOfTheScale) {
  const ColourScale scale{ColourMap::viridis, ScaleKind::linear, 0.0, 1.0};
  const View view = a_view("void_ratio", scale);
  DrawnPoints points;
  fill(points, 0.0, 0.05, 0.0, 0.1, 0.002, sand, 0.5);
  fill(points, 0.0, 0.05, -0.1, 0.0, 0.002, surcharge, nan);
  const Window window{0.1, -0.1, 0.1};
  const Picture picture = panel_picture(view, 0, Raster(points, window, 100, 200), window);
  EXPECT_EQ(picture.at(20, 150), scale(0.5).value());
  EXPECT_EQ(picture.at(20, 50), no_value.value());
  EXPECT_EQ(picture.at(80, 100), 0xffffffU);
}

TEST(Frame, GridLinesMoveWithTheSoil) {
  const ColourScale scale{ColourMap::magma, ScaleKind::from_zero, 0.0, 10.0};
  View view = a_view("displacement", scale);
  view.grid = 0.02;
  const Window window{0.1, 0.0, 0.2};
  // Dark rows of pixels along a column that lies between the lines of constant radius.
  const auto dark_rows = [&](double moved_down) {
    DrawnPoints points;
    fill(points, 0.0, 0.1, 0.0, 0.2, 0.002, sand, 0.0);
    points.fields[2].assign(points.r.size(), moved_down);
    const Picture picture = panel_picture(view, 0, Raster(points, window, 100, 200), window);
    std::vector<int> rows;
    for (int row = 30; row < 78; ++row)
      if (picture.at(50, row) != scale(0.0).value() && (rows.empty() || row > rows.back() + 1))
        rows.push_back(row);
    return rows;
  };
  const std::vector<int> still = dark_rows(0.0), moved = dark_rows(0.007);
  ASSERT_EQ(still.size(), 2U);
  EXPECT_EQ(still[1] - still[0], 20);
  ASSERT_EQ(moved.size(), 2U);
  EXPECT_EQ(moved[0] - still[0], 7);
  view.grid = 0.0;
  EXPECT_TRUE(dark_rows(0.0).empty());
}

TEST(Frame, SoilBoundaryIsDrawn) {
  const ColourScale scale{ColourMap::viridis, ScaleKind::linear, 0.0, 1.0};
  DrawnPoints points;
  fill(points, 0.0, 0.1, 0.0, 0.1, 0.005, sand, 0.8);
  fill(points, 0.0, 0.1, 0.1, 0.2, 0.005, clay, 0.2);
  const Window window{0.1, 0.0, 0.2};
  const Picture picture =
      panel_picture(a_view("void_ratio", scale), 0, Raster(points, window, 100, 200), window);
  EXPECT_EQ(picture.at(50, 90), scale(0.8).value());
  EXPECT_EQ(picture.at(50, 110), scale(0.2).value());
  EXPECT_NE(picture.at(50, 99), scale(0.8).value());
}

TEST(Frame, LayoutFitsThePanelsToWholePixels) {
  View view = a_view("p", {});
  for (const int panels : {1, 2, 3, 4}) {
    view.panels.resize(panels, view.panels[0]);
    for (const auto& radius : {std::optional<double>{0.1}, std::optional<double>{}}) {
      view.radius = radius;
      const Layout layout = layout_of(view);
      for (const Box& box : layout.panels) {
        const double x = box.x * layout.pixels_per_point;
        EXPECT_NEAR(x, std::round(x), 1e-9);
        EXPECT_LE(box.right(), layout.width);
        EXPECT_NEAR(box.width * layout.pixels_per_point, layout.columns, 1e-9);
      }
      const Window window = window_at(view.geometry, radius, 0.2);
      EXPECT_NEAR(layout.columns / window.radius, layout.rows / (window.bottom - window.top),
                  0.02 * layout.columns / window.radius)
          << "lengths are as long across as down";
    }
  }
}

TEST(Quantities, ComeFromTheStoredArraysInTheirUnits) {
  results::VtkPoints points;
  points.ids = {1, 2};
  points.positions = {0.1, -0.2, 0.0, 0.2, 0.3, 0.0};
  points.arrays = {{"volume_m3", {}, 1, {2.0 * M_PI * 0.1 * 0.01 * 0.01, 1.0}},
                   {"material", {}, 1, {0.0, 2.0}},
                   {"displacement_m", {}, 3, {0.003, -0.004, 0.0, 0.0, 0.0, 0.0}},
                   {"stress_Pa", {}, 6, {-9e3, -7e3, -5e3, 1e3, 0.0, 0.0, 0, 0, 0, 0, 0, 0}},
                   {"p_Pa", {}, 1, {7e3, 0.0}}};
  View view = a_view("displacement", {});
  for (const char* name : {"sigma_r", "sigma_v", "p"}) view.panels.push_back({find_view_quantity(name), {}});
  const DrawnPoints drawn = drawn_points(view, points);
  EXPECT_DOUBLE_EQ(drawn.fields[0][0], 5.0);  // mm
  EXPECT_DOUBLE_EQ(drawn.fields[1][0], 9.0);  // kPa, compression-positive
  EXPECT_DOUBLE_EQ(drawn.fields[2][0], 7.0);
  EXPECT_DOUBLE_EQ(drawn.fields[3][0], 7.0);
  EXPECT_EQ(drawn.fields[4][0], 0.003);
  EXPECT_EQ(drawn.fields[5][0], 0.004) << "downward";
  EXPECT_DOUBLE_EQ(drawn.size[0], 0.01);
  EXPECT_EQ(drawn.depth[0], 0.2);
  EXPECT_EQ(drawn.material[1], surcharge);

  view.panels = {{find_view_quantity("q"), {}}};
  EXPECT_THROW((void)drawn_points(view, points), results::Error);
  EXPECT_EQ(find_view_quantity("porosity"), nullptr);
}

}  // namespace
}  // namespace cpt::reports::view

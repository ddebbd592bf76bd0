#include "drawing/axis.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::drawing {
namespace {

std::vector<std::string> labels(double low, double high, int count) {
  std::vector<std::string> out;
  for (const Tick& tick : ticks(low, high, count)) out.push_back(tick.label);
  return out;
}

TEST(Axis, MapsLinearlyAlsoDownward) {
  const Axis axis{0.0, 10.0, 100.0, 50.0};
  EXPECT_EQ(axis(0.0), 100.0);
  EXPECT_EQ(axis(10.0), 50.0);
  EXPECT_EQ(axis(5.0), 75.0);
}

TEST(Axis, TicksAreRoundAndCarryTheDecimalsOfTheirStep) {
  EXPECT_EQ(labels(0.0, 8400.0, 5), (std::vector<std::string>{"0", "2000", "4000", "6000", "8000"}));
  EXPECT_EQ(labels(0.0, 0.55, 6), (std::vector<std::string>{"0.0", "0.1", "0.2", "0.3", "0.4", "0.5"}));
  EXPECT_EQ(labels(0.304, 0.3117, 4), (std::vector<std::string>{"0.304", "0.306", "0.308", "0.310"}));
  EXPECT_EQ(labels(-1.2, 1.2, 5), (std::vector<std::string>{"−1.0", "−0.5", "0.0", "0.5", "1.0"}));
}

TEST(Axis, TicksStayInsideAndNearTheWantedNumber) {
  for (const double high : {1e-7, 3e-3, 0.9, 1.0, 17.0, 3.3e4, 9.99e8})
    for (const int count : {3, 6, 10}) {
      const auto found = ticks(0.0, high, count);
      EXPECT_GE(found.size(), 2u) << high;
      EXPECT_LE(found.size(), 2u * count + 1u) << high;
      EXPECT_LE(found.back().value, high * (1.0 + 1e-8));
    }
}

TEST(Axis, ThereAreNoTicksWhereADoubleCannotTellThemApart) {
  EXPECT_TRUE(ticks(0.0, 1e-320, 5).empty());
  EXPECT_TRUE(ticks(2.0, 2.0, 5).empty());
  EXPECT_TRUE(ticks(1e18, 1e18 + 256.0, 5).empty());
  EXPECT_FALSE(ticks(1e6, 1e6 + 1e-3, 5).empty());
}

TEST(Axis, RangeWithoutWidthIsOpened) {
  EXPECT_EQ(widened(0.0, 10.0, 0.1).low, -1.0);
  EXPECT_EQ(widened(0.0, 10.0, 0.1).high, 11.0);
  EXPECT_LT(widened(5.0, 5.0, 0.1).low, 5.0);
  EXPECT_GT(widened(0.0, 0.0, 0.1).high, 0.0);
}

TEST(Axis, LabelsDoNotTouch) {
  const auto labels = [](double width_of_plot) {
    Svg svg(300.0, 60.0, "axis");
    const Box plot{20.0, 10.0, width_of_plot, 20.0};
    draw_horizontal(svg, plot, {0.0, 16000.0, plot.x, plot.right()}, Edge::bottom, {}, 8);
    const std::string text = svg.document("");
    std::size_t count = 0;
    for (auto at = text.find("000<"); at != std::string::npos; at = text.find("000<", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(labels(280.0), 8U);  // 2000 to 16000
  EXPECT_LE(labels(140.0), 4U);
  EXPECT_GE(labels(140.0), 2U);
}

}  // namespace
}  // namespace cpt::drawing

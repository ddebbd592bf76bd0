// The figure of a measured sounding.
#include "reports/depth_panels.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::reports {
namespace {

using drawing::plain, drawing::symbolic;

DepthPanels two_panels() {
  DepthPanels figure;
  figure.title = "A & B";
  figure.lines = {"GEF-CPT"};
  figure.depth = {0.5, 1.0, 1.5};
  figure.panels = {{symbolic("q_c (MPa)"), {1.0, std::nan(""), 3.0}, "#123456"},
                   {symbolic("u_2 (kPa)"), {-5.0, 0.0, 5.0}, "#654321"}};
  return figure;
}

TEST(DepthPanels, DrawsOneCurveAPanelAndEscapesTexts) {
  const std::string svg = depth_panels(two_panels());
  EXPECT_NE(svg.find("A &amp; B"), std::string::npos);
  EXPECT_NE(svg.find("#123456"), std::string::npos);
  EXPECT_NE(svg.find("#654321"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos) << "a void breaks the curve";
}

TEST(DepthPanels, ShadesThePredrilledPart) {
  DepthPanels figure = two_panels();
  const std::size_t bare = depth_panels(figure).size();
  figure.shaded_to = 0.7;
  EXPECT_GT(depth_panels(figure).size(), bare);
}

TEST(DepthPanels, ASecondCurveAndBandsBeside) {
  DepthPanels figure = two_panels();
  figure.panels[0].beside = {1.5, 2.0, 9.0};
  figure.panels[0].beside_color = "#abcdef";
  figure.panels[1].circled = {2};
  figure.bands_title = plain("zone");
  figure.bands = {{0.5, 1.0, "3", "#0000aa"}, {1.0, 1.5, "6", "#00aa00"}, {7.0, 8.0, "9", "#aa0000"}};
  const std::string svg = depth_panels(figure);
  for (const char* part : {"#abcdef", ">zone<", ">3<", ">6<", "#0000aa", "#00aa00"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  EXPECT_NE(svg.find("<circle"), std::string::npos);
  EXPECT_EQ(svg.find("#aa0000"), std::string::npos) << "below the sounding";
}

TEST(DepthPanels, ASingleReadingIsAFigureToo) {
  DepthPanels figure = two_panels();
  figure.depth = {2.0};
  figure.panels = {{symbolic("q_c (MPa)"), {1.0}, "#123456"}};
  const std::string svg = depth_panels(figure);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace cpt::reports

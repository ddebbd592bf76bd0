#include "reports/figures.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/labels.hpp"
#include "reports/notes.hpp"
#include "solver/quantities.hpp"
#include "tests/reports/made_up_campaigns.hpp"

namespace cpt::reports {
namespace {

using drawing::Box, drawing::Column, drawing::escape, drawing::plain, drawing::Svg, drawing::XyPlot;
namespace palette = drawing::palette;

class Figures : public ::testing::Test {
 protected:
  Figures() {
    std::string name = (std::filesystem::temp_directory_path() / "cpt_figures_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    folder = name;
  }
  ~Figures() override { std::filesystem::remove_all(folder); }

  static std::size_t count(const std::string& text, std::string_view part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
  }
  static bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
  }
  /// Where a text starts in a document; beyond any place if it is not there.
  static std::size_t place(const std::string& text, std::string_view part) { return text.find(part); }

  std::filesystem::path folder;
};

TEST_F(Figures, TornadoIsSortedByRangeWithBoundsAtTheEnds) {
  const auto campaign = run_made_up(sand_study(folder));
  const std::string svg = tornado_figure(campaign, campaign.windows[0]).value();
  EXPECT_LT(place(svg, ">H<"), place(svg, ">χ<"));
  EXPECT_LT(place(svg, ">χ<"), place(svg, ">ν<"));
  for (const char* bound : {">75<", ">26<", ">46<", ">flexible<", ">rigid<", ">0.015<", ">0.009<"})
    EXPECT_TRUE(has(svg, bound)) << bound;
  EXPECT_FALSE(has(svg, "×"));
  EXPECT_FALSE(has(svg, "nan"));
}

TEST_F(Figures, FailuresAndWaitingRunsAreShown) {
  // Ids 14 and 15 are the lower and upper bound of D_R; 13 is H's upper bound.
  const auto campaign = run_made_up(sand_study(folder), {{13, "pending"}, {14, "did_not_converge"}});
  const std::string tornado = tornado_figure(campaign, campaign.windows[0]).value();
  EXPECT_TRUE(has(tornado, "19 of 21 realizations completed, 1 failed, 1 still to run"));
  EXPECT_TRUE(has(tornado, "× 26: did_not_converge"));
  EXPECT_TRUE(has(tornado, ">75: not run yet<"));
  const std::string indices = sensitivity_figure(campaign, campaign.windows[0]).value();
  EXPECT_TRUE(has(indices, "× undefined: lower run failed (did_not_converge)"));
  const std::string profiles = profiles_figure(campaign).value();
  EXPECT_TRUE(has(profiles, "1 failed on the way"));
}

TEST_F(Figures, SensitivityMarksNegativeAndBelowNoise) {
  const auto campaign = run_made_up(sand_study(folder));
  const std::string svg = sensitivity_figure(campaign, campaign.windows[0]).value();
  EXPECT_TRUE(has(svg, ">−0.050<"));     // the chamber's radius
  EXPECT_GT(count(svg, "#e69f00"), 1u);  // in the plot, not in the legend alone
  EXPECT_GT(count(svg, "fill-opacity=\"0.4\""), 2u);
  EXPECT_TRUE(has(svg, "stroke-dasharray=\"4 2.5\""));
}

TEST_F(Figures, ProfilesShadeClayAndTellTheFurthestApart) {
  const auto layered = run_made_up(layered_study(folder));
  const std::string svg = profiles_figure(layered).value();
  EXPECT_GT(count(svg, "#f1e7d4"), 2u);
  EXPECT_EQ(count(svg, "<path "), layered.curves.size());
  EXPECT_TRUE(has(svg, " = 75<"));
  const auto sand = run_made_up(sand_study(folder));
  EXPECT_EQ(count(profiles_figure(sand).value(), "#f1e7d4"), 0u);
  const auto clay = run_made_up(clay_study(folder));  // one soil: nothing to tell apart
  EXPECT_EQ(count(profiles_figure(clay).value(), "#f1e7d4"), 0u);
}

TEST_F(Figures, SpikeOfOneBinDoesNotSetTheScale) {
  auto campaign = run_made_up(clay_study(folder));
  const std::string calm = profiles_figure(campaign).value();
  campaign.curves[0].profile.q_c[0] = 1e9;
  campaign.curves[3].profile.q_c[400] = -1e9;
  const std::string spiky = profiles_figure(campaign).value();
  const auto axis_labels = [](const std::string& svg) { return svg.substr(0, svg.find("<path")); };
  EXPECT_EQ(axis_labels(spiky), axis_labels(calm));
}

TEST_F(Figures, BaselineEnlargesEveryWindow) {
  const auto campaign = run_made_up(layered_study(folder));
  const std::string svg = baseline_figure(campaign).value();
  EXPECT_EQ(count(svg, "<path "), 3u);
  EXPECT_EQ(count(svg, "average q"), 2u);
  EXPECT_TRUE(has(svg, "embedded clay"));
}

TEST_F(Figures, EveryBarTellsItsNumbers) {
  const auto campaign = run_made_up(sand_study(folder));
  for (const auto& figure :
       {tornado_figure(campaign, campaign.windows[0]), sensitivity_figure(campaign, campaign.windows[0])}) {
    EXPECT_EQ(count(figure.value(), "<title>"), 1 + campaign.sensitivity.size());
    for (const auto& row : campaign.sensitivity)
      EXPECT_TRUE(has(figure.value(),
                      "<title>" + escape(input_words(campaign, campaign.windows[0], row)) + "</title>"));
  }
  const auto& row = campaign.sensitivity.front();
  EXPECT_TRUE(has(input_words(campaign, campaign.windows[0], row),
                  drawing::number(row.q_lower_kPa, 4) + " kPa\nupper "));
  EXPECT_TRUE(has(input_words(campaign, campaign.windows[0], row), "\nSI " + drawing::decimals(row.si, 4)));
}

// The style sheet colours what stands in the page, and the page says whose it is.
TEST_F(Figures, InThePageHaveNeitherColoursNorHeadingOfTheirOwn) {
  const auto campaign = run_made_up(sand_study(folder), {{13, "pending"}, {14, "did_not_converge"}});
  const Place page{Column::single, drawing::Ground::page};
  for (const auto& figure : {tornado_figure(campaign, campaign.windows[0], page),
                             sensitivity_figure(campaign, campaign.windows[0], page)}) {
    const std::string& svg = figure.value();
    EXPECT_FALSE(has(svg, "\"#")) << svg;
    EXPECT_TRUE(has(svg, "var(--blue)") && has(svg, "var(--warn)") && has(svg, "var(--muted)"));
    EXPECT_EQ(count(svg, escape(campaign.campaign.title)), 1U) << "in its name alone";
    EXPECT_FALSE(has(svg, " id=\""));
  }
}

TEST_F(Figures, NothingToDrawIsNoFigure) {
  Mishaps all;
  for (int id = 1; id <= 21; ++id) all[id] = "pending";
  const auto campaign = run_made_up(sand_study(folder), all);
  EXPECT_FALSE(tornado_figure(campaign, campaign.windows[0]));
  EXPECT_FALSE(sensitivity_figure(campaign, campaign.windows[0]));
  EXPECT_FALSE(profiles_figure(campaign));
  EXPECT_FALSE(baseline_figure(campaign));
}

TEST_F(Figures, EqualSymbolsAreToldApartByTheirGroup) {
  auto study = layered_study(folder);
  study.rows.push_back({solver::find_quantity("sand.rho_grains_kg_per_m3"), 2650, 2600, 2700});
  auto campaign = run_made_up(study);
  campaign.parameters.back().symbol = "G";  // as the clay's shear modulus
  EXPECT_EQ(html(symbol_of(campaign, campaign.parameters.back())), "G (sand)");
  EXPECT_EQ(html(symbol_of(campaign, parameter_of(campaign, "clay.G_kPa"))), "G (clay)");
  EXPECT_EQ(html(symbol_of(campaign, parameter_of(campaign, "sand.H"))), "H");
  // Soils of the study's own are always named; a study of one soil needs no name for it.
  std::string& setup = campaign.campaign.baseline_setup;
  setup = "soils = sand norsand\n" + setup;
  EXPECT_EQ(html(symbol_of(campaign, parameter_of(campaign, "sand.H"))), "H");
  setup = "soils = seam norsand\n" + setup;
  EXPECT_EQ(html(symbol_of(campaign, parameter_of(campaign, "sand.H"))), "H (sand)");
}

TEST_F(Figures, LongTextsAreCutAtWholeCharacters) {
  const std::string cut = shortened("σσσσσσσσσσσσσσσσσσσσ", 40.0, 8.0);
  EXPECT_LE(width(plain(cut), 8.0), 40.0);
  EXPECT_TRUE(cut.ends_with("σ…"));
  EXPECT_EQ(escape(cut), cut);
  EXPECT_EQ(shortened("short", 400.0, 8.0), "short");
}

TEST_F(Figures, AreAsWideAsTheColumn) {
  const auto campaign = run_made_up(sand_study(folder));
  for (const Column column : {Column::single, Column::one_and_half, Column::full})
    for (const auto& svg : {tornado_figure(campaign, campaign.windows[0], column),
                            sensitivity_figure(campaign, campaign.windows[0], column),
                            profiles_figure(campaign, column), baseline_figure(campaign, column)}) {
      const std::string box = "viewBox=\"0 0 ";
      const auto at = svg.value().find(box);
      ASSERT_NE(at, std::string::npos);
      EXPECT_NEAR(std::stod(svg->substr(at + box.size())), width_of(column), 0.01);
    }
}

TEST_F(Figures, RepeatsShowAsIntervals) {
  auto study = sand_study(folder);
  const auto without = run_made_up(study);
  EXPECT_FALSE(has(sensitivity_figure(without, without.windows[0]).value(), "95 %, repeats"));
  add_repeats(study, 4);
  study.database = folder / "repeats.sqlite";
  const auto campaign = run_made_up(study);
  EXPECT_TRUE(has(sensitivity_figure(campaign, campaign.windows[0]).value(), "95 %, repeats"));
}

// The pale bars are those within the intervals of the repeats, not those below SI_noise.
TEST_F(Figures, RepeatsDecideWhatIsPale) {
  auto study = sand_study(folder);
  add_repeats(study, 4);
  auto campaign = run_made_up(study);
  const auto pale = [&] {
    const std::string svg = sensitivity_figure(campaign, campaign.windows[0]).value();
    return count(svg, "fill-opacity=\"0.4\"");
  };
  std::size_t noise = 0, noise_of_the_paper = 0;
  for (const auto& row : campaign.sensitivity) {
    noise += row.above_noise == false ? 1 : 0;
    noise_of_the_paper += row.above_si_noise == false ? 1 : 0;
    EXPECT_EQ(row.above_noise, row.above_repeats);
  }
  ASSERT_NE(noise, noise_of_the_paper);
  EXPECT_EQ(pale(), noise + 2) << "two in the legend";
  for (auto& row : campaign.sensitivity) row.above_noise = false;
  EXPECT_EQ(pale(), campaign.sensitivity.size() + 2);
}

/// Every curve begins with a blow, as the solver's do.
results::Snapshot with_start(results::Snapshot campaign, double q_Pa) {
  for (results::CurveRow& curve : campaign.curves) {
    auto& p = curve.profile;
    while (p.depth.front() < 0.0215)
      for (auto* values : {&p.depth, &p.q_c, &p.f_s}) values->erase(values->begin());
    p.q_c[0] = q_Pa;
    p.q_c[1] = 0.4 * q_Pa;
  }
  return campaign;
}

TEST_F(Figures, TheStartOfThePushIsDrawnApartAndSetsNoScale) {
  const auto plain_campaign = run_made_up(clay_study(folder));
  const auto campaign = with_start(plain_campaign, 5e6);
  for (const auto& figure : {profiles_figure(campaign), baseline_figure(campaign)}) {
    EXPECT_TRUE(has(figure.value(), "start of the push"));
    EXPECT_FALSE(has(figure.value(), ">1000<")) << "clay of 300 kPa on an axis for the blow";
  }
  EXPECT_FALSE(has(profiles_figure(plain_campaign).value(), "start of the push"));
  const auto dashes = count(profiles_figure(campaign).value(), "stroke-dasharray=\"1.5 1.5\"");
  EXPECT_EQ(dashes, campaign.curves.size());
}

TEST_F(Figures, AWindowThatHoldsTheStartOfThePushSaysSo) {
  auto study = clay_study(folder);
  study.windows.push_back({"surface", parameters::Window::Kind::fixed, 0.0, 0.03, 0.0});
  const auto campaign = with_start(run_made_up(study), 5e6);
  EXPECT_EQ(window_remark(campaign, campaign.windows[0]), "");
  const std::string remark = window_remark(campaign, campaign.windows[1]);
  EXPECT_TRUE(has(remark, "holds the start of the push (to 0.0222 m)") || has(remark, "(to 0.0223 m)"))
      << remark;
  EXPECT_TRUE(has(remark, "in 12 of 12 curves")) << remark;
}

TEST_F(Figures, MarksAreNotCutByTheFrame) {
  XyPlot plot;
  plot.x_title = plot.y_title = plain("share (%)");
  plot.room = {{0.0, 0.0}, {100.0, 100.0}};
  plot.curves.push_back({{{100.0, 100.0}}, {palette::blue, 1.0, {}}, 3.0});
  Svg svg(300.0, 200.0, "marks");
  const Box box{50.0, 20.0, 200.0, 140.0};
  draw(svg, box, plot);
  const std::string text = svg.document("marks");
  const auto number_after = [&](std::string_view part) {
    return std::stod(text.substr(text.find(part) + part.size()));
  };
  EXPECT_LE(number_after("cx=\"") + 3.0, box.right());
  EXPECT_GE(number_after("cy=\"") - 3.0, box.y);
}

}  // namespace
}  // namespace cpt::reports

// The report's page in a headless Chromium, as a reader meets it. CPT_SCREENSHOTS=FOLDER keeps the pictures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

#include "reports/figure_files.hpp"
#include "reports/page.hpp"
#include "tests/reports/made_up_campaigns.hpp"
#include "tests/reports/page_fixture.hpp"

namespace cpt::reports {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

int id_of(const results::Snapshot& campaign, const std::string& parameter, const std::string& side) {
  for (const auto& run : campaign.realizations)
    if (run.parameter == parameter && run.side == side) return run.id;
  return 0;
}

TEST_F(Page, ShowsWhatTheDesignSays) {
  for (const char* design :
       {"kind = \"morris\"\ntrajectories = 8", "kind = \"latin_hypercube\"\nruns = 40"}) {
    const auto campaign = run_made_up_design(folder / "study.toml", design);
    auto effects = results::design_effects(campaign);
    results::add_index_convergence(campaign, effects);
    PageContext context;
    context.effects = effects;
    show(campaign, context);
    EXPECT_FALSE(value("document.getElementById('effects').hidden").get<bool>());
    EXPECT_EQ(count("#effects table tbody tr"), static_cast<int>(effects.rows.size()));
    EXPECT_EQ(count("#effects figure svg g > title"), 4) << design;
    EXPECT_NE(text("#effects figure svg g > title").find("95 %: "), std::string::npos) << design;
    EXPECT_EQ(count("#effects figure svg"), 2) << design;  // effects and their convergence
    if (const char* keep = std::getenv("CPT_SCREENSHOTS"))
      browser->screenshot(fs::path(keep) / (effects.design + ".png"));
    fs::remove(folder / "study.sqlite");
  }
}

TEST_F(Page, ShowsTheWholeCampaign) {
  const auto campaign = run_made_up(layered_study(folder));
  show(campaign, {{}, {"report.json"}, 0});
  EXPECT_EQ(text("h1"), "Layered sand and clay");
  EXPECT_EQ(text("#state").find("28 of 28 realizations completed"), 0U);
  EXPECT_EQ(count("#glance p"), 2);
  for (const char* section : {"glance", "sensitivity", "profiles", "realizations", "provenance"})
    EXPECT_EQ(count(std::string("#") + section + ":not([hidden]) h2"), 1) << section;
  EXPECT_EQ(count("#failures:not([hidden]), #diagnosis:not([hidden])"), 0);
  EXPECT_EQ(count("#sensitivity figure svg"), 4) << "tornado and indices of two windows";
  EXPECT_EQ(count("#sensitivity svg[role='img'][aria-label^='Tornado: '] g > title"), 2 * 16);
  EXPECT_EQ(count("#sensitivity svg[role='img'][aria-label^='Sensitivity index: '] g > title"), 2 * 16);
  EXPECT_EQ(count("#figures figure"), 0) << "each is in its section";
  EXPECT_EQ(count("path.curve"), 28);
  EXPECT_EQ(rows().size(), 28U);
  EXPECT_EQ(count("a[href='report.json']"), 1);
  EXPECT_NE(text("#provenance dl").find("layered_sand_clay"), std::string::npos);
  EXPECT_NE(text("#profile-help").find("where two layers meet"), std::string::npos);
  EXPECT_EQ(value("[-0.0004, 0.0004, 0.0006].map(percent)"), json({"0.0 %", "0.0 %", "+0.1 %"}));
}

TEST_F(Page, HasTheNumbersOfTheDatabase) {
  const auto campaign = run_made_up(sand_study(folder));
  show(campaign);
  const json data = value("data");
  ASSERT_EQ(data.at("curves").size(), campaign.curves.size());
  for (std::size_t k = 0; k < campaign.curves.size(); ++k) {
    const auto& profile = campaign.curves[k].profile;
    EXPECT_EQ(data.at("curves")[k].at("depth_m"), profile.depth);
    for (std::size_t i = 0; i < profile.q_c.size(); ++i)
      ASSERT_EQ(data.at("curves")[k].at("q_c_kPa")[i].get<double>(), profile.q_c[i] / 1e3);
  }
  for (std::size_t k = 0; k < campaign.window_means.size(); ++k)
    EXPECT_EQ(data.at("window_means")[k].at("q_c_mean_kPa").get<double>(),
              campaign.window_means[k].q_c_mean_kPa);
  // What the reader sees: the sixth column, to five digits.
  for (const auto& mean : campaign.window_means) {
    const std::string shown =
        text("#table tr[data-id=\"" + std::to_string(mean.realization) + "\"] td:nth-child(6)");
    EXPECT_NEAR(std::stod(shown), mean.q_c_mean_kPa,
                0.5 * std::pow(10.0, std::floor(std::log10(mean.q_c_mean_kPa)) - 4));
  }
}

// The sentence at the top, the colours and the table of realizations, against the numbers.
TEST_F(Page, SaysWhatIsNoiseAndWhatIsOutOfLine) {
  auto study = sand_study(folder);
  add_repeats(study, 4);
  auto campaign = run_made_up(study);
  campaign.realizations[2].out_of_line = "energy error -18 %";
  show(campaign);
  int loud = 0, paper = 0;
  for (const auto& row : campaign.sensitivity) {
    loud += row.above_noise == true ? 1 : 0;
    paper += row.above_si_noise == true ? 1 : 0;
  }
  ASSERT_NE(loud, paper);
  const std::string words = text("#glance p");
  EXPECT_NE(
      words.find(fmt::format("The index of {} of {} inputs exceeds the noise of the baseline's 4 repeats",
                             loud, campaign.sensitivity.size())),
      std::string::npos)
      << words;
  EXPECT_NE(words.find(fmt::format("the spread inside the window, {} would.", paper)), std::string::npos)
      << words;
  EXPECT_EQ(count("#sensitivity_0 rect[fill-opacity='0.4']"),
            static_cast<int>(campaign.sensitivity.size()) - loud + 2)
      << "two in the legend";
  EXPECT_EQ(count("#table tr.doubtful"), 1);
  EXPECT_NE(text("#table tr.doubtful").find("energy error -18 %"), std::string::npos);
}

TEST_F(Page, AnyChannelThatWasRecordedIsDrawn) {
  show(run_made_up(sand_study(folder)));
  EXPECT_EQ(value("[...document.querySelectorAll('#channel option')].map((option) => option.value)"),
            json({"q_c", "f_s"}))
      << "nobody recorded the wall's stress";
  const auto there = [&](const std::string& channel) {
    return value("value_at(curves[0], curves[0].depth_m[100]) === curves[0]." + channel + "_kPa[100]");
  };
  EXPECT_TRUE(there("q_c").get<bool>());
  (void)value(
      "(() => { const choice = document.getElementById('channel'); choice.value = 'f_s';"
      "choice.dispatchEvent(new Event('change')); return 0; })()");
  EXPECT_TRUE(there("f_s").get<bool>());
  EXPECT_NE(value("document.getElementById('profile-plot').getAttribute('aria-label')")
                .get<std::string>()
                .find("sleeve friction over depth"),
            std::string::npos);
  EXPECT_NE(text("#profile-plot svg").find("(kPa)"), std::string::npos);
}

TEST_F(Page, PointerReadsAndHighlightsTheNearestCurve) {
  const auto campaign = run_made_up(sand_study(folder));
  const int hard = id_of(campaign, "sand.H", "upper");
  show(campaign);
  browser->move(on_curve(hard, 0.3));
  EXPECT_EQ(value("[...document.querySelectorAll('path.lit')].map((p) => Number(p.dataset.id))"),
            json({hard}));
  EXPECT_EQ(text(".tip").find("H = 75"), 0U) << text(".tip");
  const double q = value("value_at(curve_of.get(" + std::to_string(hard) + "), shown.depth)");
  EXPECT_NE(text(".tip").find(value("number(" + std::to_string(q) + ")").get<std::string>()),
            std::string::npos);

  const bool before = value("shown.pins.has(" + std::to_string(hard) + ")");
  EXPECT_TRUE(before) << "the furthest from the baseline stands out from the start";
  browser->click(on_curve(hard, 0.3));
  EXPECT_EQ(count("path.pinned[data-id=\"" + std::to_string(hard) + "\"]"), 0);
  browser->click(on_curve(hard, 0.3));
  EXPECT_EQ(count("path.pinned[data-id=\"" + std::to_string(hard) + "\"]"), 1);
  EXPECT_EQ(count("#table tr[data-id=\"" + std::to_string(hard) + "\"] input:checked"), 1);

  browser->move({5, 5});
  EXPECT_EQ(count("path.lit"), 0);
}

TEST_F(Page, DraggingZoomsIntoDepthAndDoubleClickShowsAll) {
  const auto campaign = run_made_up(sand_study(folder));
  show(campaign);
  browser->drag(on_curve(1, 0.2), on_curve(1, 0.3));
  browser->settle();
  const json domain = depths_shown();
  EXPECT_NEAR(domain.at(0), 0.2, 2e-3);
  EXPECT_NEAR(domain.at(1), 0.3, 2e-3);
  EXPECT_NEAR(std::stod(value("document.querySelector('#profiles input').value").get<std::string>()), 0.2,
              2e-3);
  browser->click(on_curve(1, 0.25), 2);
  EXPECT_NEAR(depths_shown().at(0), 0.0, 1e-12);
  // The same by number.
  browser->run(
      "const i = document.querySelectorAll('#profiles input')[1]; i.value = 0.1; "
      "i.dispatchEvent(new Event('change'))");
  EXPECT_NEAR(depths_shown().at(1), 0.1, 1e-12);
}

TEST_F(Page, TableSortsAndFiltersAndTheCurvesFollow) {
  const auto campaign = run_made_up(sand_study(folder), {{5, "crashed"}});
  show(campaign);
  std::vector<int> by_mean;
  {
    std::vector<std::pair<double, int>> means;
    for (const auto& mean : campaign.window_means) means.emplace_back(mean.q_c_mean_kPa, mean.realization);
    std::stable_sort(means.begin(), means.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [mean, id] : means) by_mean.push_back(id);
    by_mean.push_back(5);  // what is not known comes last, either way
  }
  browser->click(browser->centre("#table th:nth-child(6) button"));
  EXPECT_EQ(rows(), by_mean);
  EXPECT_EQ(count("#table th:nth-child(6)[aria-sort='ascending']"), 1);
  browser->click(browser->centre("#table th:nth-child(6) button"));
  EXPECT_EQ(rows().front(), by_mean[by_mean.size() - 2]);
  EXPECT_EQ(rows().back(), 5);

  browser->click(browser->centre("#filter"));
  browser->type("wall flex");
  EXPECT_EQ(rows(), std::vector<int>{id_of(campaign, "chamber.wall", "lower")});
  EXPECT_EQ(text("#count").find("1 of 21"), 0U);
  EXPECT_EQ(count("path.curve:not(.out):not(.pinned):not(.baseline)"), 0);
  browser->run("filter.value = ''; filter.dispatchEvent(new Event('input'))");
  browser->run(
      "const s = document.getElementById('status'); s.value = 'crashed'; s.dispatchEvent(new "
      "Event('change'))");
  EXPECT_EQ(rows(), std::vector<int>{5});

  browser->open(folder / "page.html");
  EXPECT_EQ(rows(), std::vector<int>{5}) << "what the reader chose outlives a reload";
}

TEST_F(Page, EverythingCanBeDoneWithTheKeyboard) {
  const auto campaign = run_made_up(sand_study(folder));
  show(campaign);
  std::set<std::string> reached;
  for (int k = 0; k < 60 && !reached.contains("filter"); ++k) {
    browser->press("Tab");
    reached.insert(value("document.activeElement.id").get<std::string>());
    EXPECT_NE(value("getComputedStyle(document.activeElement).outlineStyle"), "none");
  }
  for (const char* id : {"theme", "whole", "profile-plot", "filter"}) EXPECT_TRUE(reached.contains(id)) << id;

  browser->run("document.getElementById('profile-plot').focus()");
  browser->press("ArrowRight");
  const int first = value("shown.lit");
  browser->press("ArrowRight");
  const int second = value("shown.lit");
  EXPECT_NE(first, second);
  EXPECT_LE(value("value_at(curve_of.get(" + std::to_string(first) + "), shown.depth)").get<double>(),
            value("value_at(curve_of.get(" + std::to_string(second) + "), shown.depth)").get<double>());
  EXPECT_NE(text("#readout").find("kPa"), std::string::npos);
  const double depth = value("shown.depth");
  browser->press("ArrowDown");
  EXPECT_GT(value("shown.depth").get<double>(), depth);
  const bool pinned = value("shown.pins.has(shown.lit)");
  browser->press("Enter");
  EXPECT_NE(value("shown.pins.has(shown.lit)").get<bool>(), pinned);
  browser->press("+");
  const json zoomed = value("shown.zoom");
  ASSERT_TRUE(zoomed.is_array());
  EXPECT_LT(zoomed.at(1).get<double>() - zoomed.at(0).get<double>(), 0.3);
  browser->press("Escape");
  EXPECT_TRUE(value("shown.zoom").is_null());
}

TEST_F(Page, FailuresHaveTheirReasonsAndDiagnosesTheirAnswers) {
  const auto campaign = run_made_up(sand_study(folder), {{5, "crashed"}, {6, "pending"}});
  diagnosis::StoredAnswer answer{};
  answer.title = "First push";
  answer.headline = "A wall that gives way explains it.";
  answer.answer = "compliant_wall";
  answer.file = "first.sqlite";
  answer.held_out_gain = std::nan("");
  answer.hypotheses = {{"compliant_wall", 0.05, -3.0, 0.93, true},
                       {"nothing is missing", 0.3, -9.0, 0.07, false}};
  answer.mismatches = {{0, 0.1, 0.2, -12.0, 0.01}};
  answer.fitted = {{"compliant_wall", "compliant_wall.gap_mm", "mm", 0.04, 0.01, 0.02, 0.06}};
  show(campaign, {{answer}, {}, 0});
  EXPECT_EQ(text("#state").find("19 of 21 realizations completed, 1 failed, 1 still to run"), 0U);
  EXPECT_EQ(count("#failures tbody tr"), 1);
  EXPECT_NE(text("#failures tbody tr").find("energy error 0.31 at 0.212 m exceeds 0.1"), std::string::npos);
  EXPECT_NE(text("#sensitivity").find("crashed"), std::string::npos);
  EXPECT_NE(text("#diagnosis").find("A wall that gives way explains it."), std::string::npos);
  EXPECT_NE(text("#diagnosis figure svg").find("0.93"), std::string::npos);
  EXPECT_EQ(text("#diagnosis figure svg g > title").find("a chamber wall that gives way\nprobability 0.93"),
            0U);
  EXPECT_NE(text("#diagnosis").find("−12.0 %"), std::string::npos);
  EXPECT_NE(text("#diagnosis").find("0.02 to 0.06"), std::string::npos);
  const char* opacity =
      "Number(document.querySelector('#diagnosis g > [pointer-events] ~ rect').getAttribute('fill-opacity') "
      "?? 1)";
  EXPECT_EQ(value(opacity), 1.0) << "one explanation without reservations: a full bar";
  answer.reservations = {"Not ruled out: a looser lens (0.07)."};
  answer.mismatches[0].percent = std::nan("");
  show(campaign, {{answer}, {}, 0});
  EXPECT_NE(text("#diagnosis").find("Not ruled out: a looser lens (0.07)."), std::string::npos);
  EXPECT_LT(value(opacity).get<double>(), 0.5) << "with reservations an outline";
  EXPECT_EQ(text("#diagnosis").find("0.0 %"), std::string::npos) << "what is not known is no zero";
  if (const char* keep = std::getenv("CPT_SCREENSHOTS"))
    browser->screenshot(fs::path(keep) / "diagnosis.png");
}

TEST_F(Page, HostileNamesStayText) {
  const std::string hostile =
      "</script><script>window.hacked=1</script><img src=x onerror='window.hacked=1'>\"'; DROP TABLE "
      "realization;-- \xE2\x80\xA8\xE2\x80\xA9 <!-- {{data}} \xF0\x9F\x92\xA5";
  auto study = sand_study(folder);
  study.title = hostile;
  study.windows[0].name = hostile;
  study.points = {{hostile, {{solver::find_quantity("sand.H"), 50.0}}}};
  auto campaign = run_made_up(study, {{5, "crashed"}});
  campaign.realizations[4].reason = hostile;
  campaign.campaign.study_text = hostile + " \xFF";
  diagnosis::StoredAnswer answer{};
  answer.title = answer.headline = answer.file = hostile;
  answer.hypotheses = {{hostile, 0.5, -1.0, 0.5, true}};
  show(campaign, {{answer}, {hostile}, 0});
  EXPECT_TRUE(value("window.hacked").is_null());
  EXPECT_EQ(count("img"), 0);
  EXPECT_EQ(count("script"), 5);
  EXPECT_EQ(text("h1"), hostile);
  EXPECT_EQ(value("document.title").get<std::string>().substr(0, 20), hostile.substr(0, 20));
  EXPECT_NE(text("#failures").find(hostile), std::string::npos);
  EXPECT_NE(text("#diagnosis h3").find(hostile), std::string::npos);
  EXPECT_NE(text("#table").find(hostile), std::string::npos);
  EXPECT_EQ(text("#provenance pre").find(hostile), 0U);
  EXPECT_EQ(rows().size(), 22U);
  EXPECT_TRUE(value("document.querySelector('#provenance li a').href.startsWith('file:')"));
}

TEST_F(Page, OpenPageFollowsARunningCampaign) {
  fs::create_directory(folder / "finished");
  const auto study = sand_study(folder), finished = sand_study(folder / "finished");
  show(run_made_up(study, {{20, "pending"}, {21, "pending"}}), {{}, {}, 10});
  EXPECT_NE(text("#tornado_0 svg").find("not run yet"), std::string::npos);
  EXPECT_TRUE(
      eventually("document.getElementById('state').textContent.startsWith('19 of 21') && "
                 "!document.getElementById('live').hidden"));
  write_text(folder / "page.html", page(run_made_up(finished), {}));
  EXPECT_TRUE(
      eventually("document.getElementById('state').textContent.startsWith('21 of 21') && "
                 "document.getElementById('live').hidden"));
  EXPECT_EQ(text("#tornado_0 svg").find("not run yet"), std::string::npos) << "the figures follow, too";
}

// Contrast of text after WCAG 2.2, success criterion 1.4.3: at least 4.5.
constexpr const char* contrast = R"js((selector) => {
  const light = (color) => {
    const c = color.match(/[\d.]+/g).slice(0, 3).map((v) => v / 255)
      .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
  };
  const [a, b] = [getComputedStyle(document.querySelector(selector)).color,
                  getComputedStyle(document.body).backgroundColor].map(light);
  return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
})js";

TEST_F(Page, IsLegibleInLightAndDarkOnAPhoneAndOnPaper) {
  show(run_made_up(layered_study(folder), {{5, "crashed"}}));
  std::set<std::string> grounds;
  for (const char* scheme : {"light", "dark"}) {
    browser->set_media("", scheme);
    grounds.insert(value("getComputedStyle(document.body).backgroundColor").get<std::string>());
    for (const char* selector : {"body", "#state", "figcaption", "nav a", "tr.failed td"})
      EXPECT_GE(value(fmt::format("({})('{}')", contrast, selector)).get<double>(), 4.5)
          << scheme << " " << selector;
  }
  EXPECT_EQ(grounds.size(), 2U);
  EXPECT_EQ(value("getComputedStyle(document.querySelector('.drawn svg text')).fill"),
            value("getComputedStyle(document.body).color"))
      << "figures have the colours of the page";
  browser->click(browser->centre("#theme"));
  EXPECT_EQ(text("#theme"), "Colours: light");
  EXPECT_EQ(value("getComputedStyle(document.body).backgroundColor"), "rgb(255, 255, 255)");

  browser->resize(390, 844);
  EXPECT_LE(value("document.documentElement.scrollWidth").get<int>(), 390);
  for (const char* button : {"#theme", "#whole", "#status"})
    EXPECT_GE(value(fmt::format("document.querySelector('{}').getBoundingClientRect().height", button)),
              24.0);
  EXPECT_GE(
      value("Math.min(...[...document.querySelectorAll('figure svg text')].filter((t) => "
            "t.getBoundingClientRect().width > 0).map((t) => "
            "parseFloat(getComputedStyle(t).fontSize) * Math.hypot(t.getScreenCTM().a, t.getScreenCTM().b)))")
          .get<double>(),
      9.0)
      << "subscripts aside, no type below 9 px";

  const char* keep = std::getenv("CPT_SCREENSHOTS");
  const fs::path pictures = keep != nullptr ? fs::path(keep) : folder;
  browser->screenshot(pictures / "phone.png");
  browser->resize(1280, 900);
  browser->screenshot(pictures / "wide.png");
  browser->click(browser->centre("#theme"));
  browser->screenshot(pictures / "dark.png");
  for (const char* name : {"phone.png", "wide.png", "dark.png"})
    EXPECT_GT(fs::file_size(pictures / name), 50000U);
  const std::string pdf = browser->pdf();
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  write_text(pictures / "print.pdf", pdf);
  browser->set_media("print", "dark");
  EXPECT_EQ(value("getComputedStyle(document.body).backgroundColor"), "rgb(255, 255, 255)");
  EXPECT_EQ(count("#sensitivity details:not([open])"), 0) << "printing opens the tables";
  EXPECT_EQ(value("getComputedStyle(document.querySelector('.controls')).display"), "none");
}

}  // namespace
}  // namespace cpt::reports

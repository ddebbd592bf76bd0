// What the page says in sentences, held against the numbers; and the page on paper.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "results/ledger/interrupted.hpp"
#include "tests/reports/page_fixture.hpp"

namespace cpt::reports {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The window's sentences at a glance.
class Glance : public Page {
 protected:
  std::string said(const results::Snapshot& campaign, const results::Effects& effects = {}) {
    PageContext context;
    context.effects = effects;
    show(campaign, context);
    return text("#glance p");
  }
  static void expect(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
  }
  std::string symbol(const std::string& parameter) {
    return value("plain(parameter_of.get(" + json(parameter).dump() + ").label)");
  }
  std::string shown(double number, int digits = 4) {
    return value(fmt::format("number({}, {})", number, digits));
  }
};

TEST_F(Glance, SaysWhichInputChangesMostWithTheNumbersOfTheTable) {
  const auto campaign = run_made_up(sand_study(folder));
  const std::string text = said(campaign);
  const auto most = std::ranges::max_element(
      campaign.sensitivity, {}, [](const auto& row) { return std::abs(row.q_upper_kPa - row.q_lower_kPa); });
  expect(text, symbol(most->parameter) + " changes it most of all inputs alone, from " +
                   shown(most->q_lower_kPa) + " kPa at its lower to " + shown(most->q_upper_kPa) +
                   " kPa at its upper bound.");
  const auto loud = std::ranges::count_if(campaign.sensitivity,
                                          [](const auto& row) { return row.above_noise.value_or(false); });
  expect(text, fmt::format("The index of {} of 12 inputs exceeds the noise of the baseline", loud));
  EXPECT_EQ(text.find("Changed together"), std::string::npos);
}

TEST_F(Glance, NamesTheDesignsLargestEffect) {
  for (const auto& [design, quantity, words] :
       {std::tuple{"kind = \"pairs\"", "interaction", "act together most: their interaction is "},
        std::tuple{"kind = \"morris\"\ntrajectories = 4", "mu_star",
                   "has the largest elementary effects: their mean size μ* is "},
        std::tuple{"kind = \"latin_hypercube\"\nruns = 40", "total_order",
                   "holds the largest share of its variance, interactions included: "},
        std::tuple{"kind = \"sobol\"\nruns = 16", "total_order",
                   "holds the largest share of its variance, interactions included: "}}) {
    const auto campaign = run_made_up_design(folder / "study.toml", design);
    const auto effects = results::design_effects(campaign);
    const results::EffectRow* most = nullptr;
    for (const auto& row : effects.rows)
      if (row.quantity == quantity && std::isfinite(row.value) &&
          (most == nullptr || std::abs(row.value) > std::abs(most->value)))
        most = &row;
    ASSERT_NE(most, nullptr);
    const std::string text = said(campaign, effects);
    std::string name = symbol(most->parameter);
    if (!most->other_parameter.empty()) name += " × " + symbol(most->other_parameter);
    expect(text, "Changed together (");
    expect(text, name + " " + words + shown(most->value, 3));
    fs::remove(folder / "study.sqlite");
  }
}

TEST_F(Glance, CountsRunsOutOfLine) {
  auto campaign = run_made_up(sand_study(folder));
  said(campaign);
  EXPECT_EQ(text("#glance").find("out of line"), std::string::npos);
  campaign.realizations[2].out_of_line = campaign.realizations[4].out_of_line = "energy error -18 %";
  said(campaign);
  EXPECT_NE(text("#glance").find("completed, out of line"), std::string::npos) << text("#glance");
  EXPECT_EQ(value("[...document.querySelectorAll('#glance dt')].find((dt) => dt.textContent === "
                  "'completed, out of line').nextElementSibling.textContent"),
            "2");
}

TEST_F(Glance, SaysWhatAPropagationFinds) {
  const auto campaign = run_made_up_design(folder / "study.toml", "kind = \"propagation\"\nruns = 40");
  const auto effects = results::design_effects(campaign);
  const auto row = [&](std::string_view quantity) {
    return *std::ranges::find(effects.rows, quantity, &results::EffectRow::quantity);
  };
  const std::string text = said(campaign, effects);
  expect(text, fmt::format("it averages {} kPa (95 %: {} to {})", shown(row("mean").value),
                           shown(row("mean").lower), shown(row("mean").upper)));
  expect(text, fmt::format("nine of ten values lie between {} and {} kPa", shown(row("quantile_05").value),
                           shown(row("quantile_95").value)));
  const results::EffectRow* most = nullptr;
  for (const auto& one : effects.rows)
    if (one.quantity == "shapley" && (most == nullptr || one.value > most->value)) most = &one;
  ASSERT_NE(most, nullptr);
  expect(text,
         fmt::format("Most of its variance comes from {}: a share of {} (95 %: {} to {})",
                     symbol(most->parameter), shown(most->value), shown(most->lower), shown(most->upper)));
}

TEST_F(Glance, SaysHowLikelyAThresholdIsExceededAndWhyADesignStopped) {
  const auto campaign = run_made_up_design(
      folder / "study.toml",
      "kind = \"propagation\"\nruns = 100\nuntil = { half_width_percent = 90 }\n[[windows]]\nname = \"low\"\n"
      "from_m = 0.2\nto_m = 0.22\nthresholds_kPa = [300]");
  const auto effects = results::design_effects(campaign);
  const auto row = *std::ranges::find(effects.rows, "exceedance", &results::EffectRow::quantity);
  static_cast<void>(said(campaign, effects));
  const std::string all = text("#glance");
  const auto percent = [](double share) { return drawing::number(100.0 * share, 3); };
  expect(all, fmt::format("above 300 kPa with a probability of {} % (95 %: {} to {})", percent(row.value),
                          percent(row.lower), percent(row.upper)));
  EXPECT_EQ(row.used + row.dropped, 50);
  expect(
      all,
      "By the study's rule, the mean is known to ± 90 % in every window after 50 runs: 50 of the design are "
      "not needed.");
}

TEST_F(Glance, SaysWhichNoiseAndHowManyRepeatsAreStillToCome) {
  const auto grey = [&]() -> std::string {
    return value("document.querySelector('#sensitivity details p').textContent");
  };
  expect(said(run_made_up(sand_study(folder))),
         "exceeds the noise of the baseline, its spread inside the window");
  expect(grey(), "SI no larger than SInoise, the spread of the baseline inside the window");
  fs::create_directory(folder / "repeated");
  auto study = sand_study(folder / "repeated");
  add_repeats(study, 4);
  auto campaign = run_made_up(study);
  EXPECT_EQ(said(campaign).find("so far"), std::string::npos);
  EXPECT_EQ(text("#sensitivity").find("so far"), std::string::npos);
  expect(grey(), "SI no larger than its ± from the repeats");
  std::ranges::find(campaign.realizations, "repeat", &results::RealizationRow::side)->status = "pending";
  expect(said(campaign), "exceeds the noise of the baseline's 3 of 4 repeats so far");
  expect(text("#sensitivity"), "of the baseline with shifted material points, 3 of 4 repeats so far");
}

TEST_F(Glance, SaysThatNothingChangesWhereNothingDoes) {
  auto campaign = run_made_up(sand_study(folder));
  for (auto& mean : campaign.window_means) mean.q_c_mean_kPa = mean.q_c_min_kPa = mean.q_c_max_kPa = 1000.0;
  for (auto& row : campaign.sensitivity) {
    row.q_lower_kPa = row.q_upper_kPa = row.q_baseline_kPa = 1000.0;
    row.si = row.si_abs = row.si_noise = 0.0;
    row.above_noise = false;
  }
  const std::string text = said(campaign);
  expect(text, "No input alone changes it: it is the same at all bounds.");
  EXPECT_EQ(text.find("from 1000 kPa"), std::string::npos) << text;
  EXPECT_LT(value("d3.max(document.querySelectorAll('#tornado_0 g > [pointer-events] ~ rect'), "
                  "(r) => r.getBoundingClientRect().width)")
                .get<double>(),
            1.0)
      << "bars as wide as nothing";
}

TEST_F(Glance, SaysWhyThereIsNoBaseline) {
  expect(said(run_made_up(sand_study(folder), {{1, "crashed"}})),
         "nothing to compare with, the baseline failed (crashed: energy error 0.31");
  EXPECT_EQ(text("#glance").find("yet"), std::string::npos);
  expect(text("#sensitivity"), "Nothing to compare with: the baseline failed (crashed");
  fs::create_directory(folder / "later");
  auto campaign = run_made_up(sand_study(folder / "later"), {{1, "pending"}});
  expect(said(campaign), "the baseline has not been run yet.");
  campaign.realizations[0].status = "running";
  expect(said(campaign), "the baseline is being run.");
  campaign.realizations[0].status = "pending";
  campaign.realizations[0].reason = results::was_interrupted;
  expect(said(campaign), "the baseline was running when the campaign ended.");
  expect(text("#state"), "(1 was running when the campaign ended)");
}

TEST_F(Glance, SpeaksOfTheInputsThatHaveResultsWhileOthersWait) {
  std::map<int, std::string> mishaps;
  for (int id = 6; id <= 21; ++id) mishaps[id] = "pending";
  const auto campaign = run_made_up(sand_study(folder), mishaps);
  expect(said(campaign),
         "Of the 2 inputs (of 12) with results at both bounds, λ alone changes it most, from ");
  EXPECT_EQ(value("[...document.querySelectorAll('#sensitivity figure')].map((f) => f.textContent).join()")
                .get<std::string>()
                .find("undefined"),
            std::string::npos)
      << "what is to come is no failure";
  expect(text("#sensitivity"), "not run yet");
}

// Words that a line's end cuts in two, and labels of an axis that touch, on a page that is shown now.
constexpr const char* split_words = R"js((() => {
  const cut = [], range = document.createRange();
  for (const place of document.querySelectorAll('main h1, main h2, main h3, main p, main dt, main dd, main td, main th, figcaption')) {
    if (place.closest('pre') || !place.offsetParent) continue;
    const walker = document.createTreeWalker(place, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode())
      for (const word of node.data.matchAll(/[^\s–\/-]+/g)) {
        range.setStart(node, word.index);
        range.setEnd(node, word.index + word[0].length);
        if (new Set([...range.getClientRects()].map((r) => Math.round(r.bottom / 6))).size > 1) cut.push(word[0]);
      }
  }
  return cut;
})())js";
constexpr const char* touching_ticks = R"js((() => {
  const touching = [];
  for (const axis of document.querySelectorAll('[aria-label$="axis tick label"]')) {
    const boxes = [...axis.querySelectorAll('text')].map((t) => t.getBoundingClientRect());
    boxes.forEach((a, i) => boxes.slice(i + 1).forEach((b, k) => {
      if (a.left < b.right && b.left < a.right && a.top + 3 < b.bottom && b.top + 3 < a.bottom)
        touching.push(`${axis.getAttribute('aria-label')} ${i} ${i + 1 + k}`);
    }));
  }
  return touching;
})())js";

TEST_F(Page, PaperSplitsNoWordAndNoTicksTouch) {
  auto study = layered_study(folder);
  study.windows.push_back({"embedded sand once more", parameters::Window::Kind::fixed, 0.28, 0.29, 0.0});
  show(run_made_up(study, {{5, "crashed"}}));
  // What A4 and Letter leave between margins of 15 mm; and a phone.
  for (const int width : {680, 703, 390}) {
    browser->set_media(width == 390 ? "" : "print", "light");
    browser->resize(width, 1000);
    EXPECT_EQ(value(split_words), json::array()) << width;
    EXPECT_EQ(value(touching_ticks), json::array()) << width;
    if (width != 390) {
      EXPECT_LE(value("document.documentElement.scrollWidth").get<int>(), width) << "nothing hangs over";
    }
  }
  EXPECT_EQ(text("footer").find("Written 20"), 0U) << "dates as ISO 8601 has them: " << text("footer");
}

}  // namespace
}  // namespace cpt::reports

// From a study with a [design] over its ledger to the table of its estimator.
#include "results/statistics/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

#include "parameters/designs/design.hpp"
#include "parameters/designs/propagation.hpp"
#include "parameters/read_study.hpp"
#include "results/statistics/stored_design.hpp"
#include "results/tables/query.hpp"
#include "tests/results/campaign_fixture.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::results {
namespace {

using parameters::Realization;
using parameters::Study;

class EffectsOf : public ScratchFolder {
 protected:
  // A study of three rows with a design, all of whose runs end; q_c = 1000 nu + 10 H + 50 wall + 4 nu H
  // [kPa], up to the shape of the curve. Ids in `failing` fail.
  Snapshot run(const std::string& design, const std::set<std::string>& failing = {},
               const std::string& top = "") {
    const std::string text = top +
                             "profile = \"homogeneous_sand\"\npreset = \"quick\"\n"
                             "[parameters]\n"
                             "sand.nu = { baseline = 0.2, lower = 0.1, upper = 0.3 }\n"
                             "sand.H = { baseline = 25, upper = 75 }\n"
                             "chamber.wall = { baseline = \"rigid\", alternative = \"flexible\" }\n"
                             "[[windows]]\nname = \"deep\"\nfrom_m = 0.30\nto_m = 0.32\n" +
                             design;
    auto parsed = parameters::parse_study(text, folder / "study.toml");
    if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed))
      throw std::runtime_error(parameters::format(*errors));
    study = std::get<Study>(std::move(parsed));
    const auto realizations = parameters::all_realizations(study);
    Ledger ledger = Ledger::open_for_run(study, realizations, {text, false});
    for (const Realization& realization : realizations) {
      const std::string name(parameter_name(study, realization));
      if (failing.contains("pending " + name)) continue;
      const solver::Setup setup = make_setup(study, realization);
      const double wall = setup.chamber.wall == solver::Wall::rigid ? 1.0 : 0.0;
      const double level = 1e6 * solver::sand_of(setup).nu + 1e4 * solver::sand_of(setup).H + 5e4 * wall +
                           4e3 * solver::sand_of(setup).nu * solver::sand_of(setup).H +
                           1e3 * setup.numerics.point_shift;
      ledger.record(realization.id, failing.contains(name)
                                        ? failed(solver::Status::did_not_converge, "made up")
                                        : completed(level));
    }
    return read_snapshot(study.database);
  }
  // q_c in the window of a level of 1 kPa.
  static double shape() {
    const solver::DepthProfile profile = curve(1.0);
    double sum = 0.0;
    int bins = 0;
    for (std::size_t i = 0; i < profile.depth.size(); ++i)
      if (profile.depth[i] >= 0.30 && profile.depth[i] <= 0.32) sum += profile.q_c[i], ++bins;
    return sum / bins;
  }
  static const EffectRow& row(const Effects& effects, std::string_view quantity, std::string_view parameter,
                              std::string_view other = "") {
    for (const EffectRow& r : effects.rows)
      if (r.quantity == quantity && r.parameter == parameter && r.other_parameter == other) return r;
    throw std::runtime_error("no such row");
  }
  Study study;
};

TEST_F(EffectsOf, PairsFindTheOnlyInteraction) {
  const Effects effects = design_effects(run("[design]\nkind = \"pairs\"\n", {}, "repeats = 2\n"));
  ASSERT_EQ(effects.rows.size(), 3U);
  const EffectRow& both = row(effects, "interaction", "sand.nu", "sand.H");
  EXPECT_NEAR(both.value, 0.5 * 4.0 * 0.2 * 50.0 * shape(), 1e-6);
  EXPECT_EQ(both.used, 4);
  EXPECT_EQ(both.note, "");
  // Repeats at -0.4, 0 and 0.4 kPa times the shape about a baseline of 520: each result scatters by 0.4/520
  // of itself; Student's t of 2 degrees of freedom is 4.303. The corners: 410, 630, 930 and 1190.
  const double corners = std::sqrt(410.0 * 410.0 + 630.0 * 630.0 + 930.0 * 930.0 + 1190.0 * 1190.0);
  EXPECT_NEAR(both.upper - both.value, 4.303 * 0.4 / 520.0 * 0.5 * corners * shape(), 0.001);
  const EffectRow& none = row(effects, "interaction", "sand.H", "chamber.wall");
  EXPECT_NEAR(none.value, 0.0, 1e-9);
  EXPECT_LT(none.lower, 0.0);
  EXPECT_GT(none.upper, 0.0);
}

TEST_F(EffectsOf, AFailedCornerLeavesItsPairUndefined) {
  const Effects effects = design_effects(run("[design]\nkind = \"pairs\"\n", {"pairs 1.3"}));
  const EffectRow& broken = row(effects, "interaction", "sand.nu", "sand.H");
  EXPECT_TRUE(std::isnan(broken.value));
  EXPECT_EQ(broken.dropped, 1);
  EXPECT_EQ(broken.note, "undefined: 1 of 4 runs failed");
  const EffectRow& whole = row(effects, "interaction", "sand.H", "chamber.wall");
  EXPECT_NEAR(whole.value, 0.0, 1e-9);
  EXPECT_TRUE(std::isnan(whole.lower));
  EXPECT_EQ(whole.note, "no interval: the study has no repeats");
}

TEST_F(EffectsOf, AnIntervalThatIsMissingSaysWhy) {
  const auto note = [&](const std::set<std::string>& failing) {
    std::filesystem::remove(folder / "study.sqlite");
    const Effects effects = design_effects(run("[design]\nkind = \"pairs\"\n", failing, "repeats = 4\n"));
    return row(effects, "interaction", "sand.H", "chamber.wall").note;
  };
  EXPECT_EQ(note({"pending repeat 1", "pending repeat 2", "pending repeat 3", "pending repeat 4"}),
            "no interval until the repeats have run");
  EXPECT_EQ(note({"pending repeat 4"}), "interval of 3 of 4 repeats so far");
  EXPECT_EQ(note({"repeat 1", "repeat 2", "repeat 3", "repeat 4"}), "no interval: too few repeats completed");
  EXPECT_EQ(note({}), "");
}

TEST_F(EffectsOf, MorrisGivesWhatABoundToBoundChangeDoes) {
  const Effects effects = design_effects(run("[design]\nkind = \"morris\"\ntrajectories = 8\n"));
  EXPECT_EQ(effects.design, "morris");
  ASSERT_EQ(effects.rows.size(), 9U);
  // The choice from flexible to rigid, without interaction.
  EXPECT_NEAR(row(effects, "mu", "chamber.wall").value, 50.0 * shape(), 1e-6);
  EXPECT_NEAR(row(effects, "sigma", "chamber.wall").value, 0.0, 1e-6);
  EXPECT_GT(row(effects, "sigma", "sand.nu").value, 1.0);
  EXPECT_EQ(row(effects, "mu_star", "sand.H").used, 8);
  EXPECT_EQ(row(effects, "mu_star", "sand.H").unit, "kPa");
}

TEST_F(EffectsOf, MorrisCountsWhatFailedAndWhatIsStillToRun) {
  const Effects effects = design_effects(run("[design]\nkind = \"morris\"\nlevels = 8\ntrajectories = 8\n",
                                             {"morris 2.1", "pending morris 5.4"}));
  int dropped = 0;
  for (const char* parameter : {"sand.nu", "sand.H", "chamber.wall"}) {
    const EffectRow& of = row(effects, "mu_star", parameter);
    EXPECT_EQ(of.used + of.dropped, 8);
    EXPECT_NE(of.note.find(" runs failed, 1 still to run"), std::string::npos) << of.note;
    dropped += of.dropped;
  }
  EXPECT_EQ(dropped, 2);
}

// The exact shares of q_c = 1000 nu + 10 H + 50 wall + 4 nu H in the box, to which the interaction adds
// little.
struct Shares {
  double nu, H, wall, both;
};
Shares shares() {
  const double nu = (1000.0 + 4.0 * 50.0) * 0.2, H = (10.0 + 4.0 * 0.2) * 50.0, both = 4.0 * 0.2 * 50.0;
  const Shares v{nu * nu / 12.0, H * H / 12.0, 50.0 * 50.0 / 4.0, both * both / 144.0};
  const double all = v.nu + v.H + v.wall + v.both;
  return {v.nu / all, v.H / all, v.wall / all, v.both / all};
}

TEST_F(EffectsOf, LatinHypercubeGivesTheShares) {
  const Effects effects =
      design_effects(run("[design]\nkind = \"latin_hypercube\"\nruns = 40\n", {"latin hypercube 3"}));
  const Shares exact = shares();
  EXPECT_NEAR(row(effects, "first_order", "sand.H").value, exact.H, 1e-6);
  EXPECT_NEAR(row(effects, "first_order", "chamber.wall").value, exact.wall, 1e-6);
  EXPECT_NEAR(row(effects, "total_order", "sand.nu").value, exact.nu + exact.both, 1e-6);
  EXPECT_NEAR(row(effects, "Q2", "").value, 1.0, 1e-9);
  EXPECT_EQ(row(effects, "Q2", "").used, 39);
  EXPECT_EQ(row(effects, "Q2", "").dropped, 1);
  EXPECT_NE(row(effects, "Q2", "").note.find("1 of 40 runs failed; degree"), std::string::npos)
      << row(effects, "Q2", "").note;
}

TEST_F(EffectsOf, SobolGivesTheSharesWithinItsIntervals) {
  const Effects effects = design_effects(run("[design]\nkind = \"sobol\"\nruns = 64\n", {"sobol 9.B"}));
  const Shares exact = shares();
  const auto held = [&](const char* quantity, const char* parameter, double share) {
    const EffectRow& of = row(effects, quantity, parameter);
    EXPECT_LE(of.lower, share) << quantity << ' ' << parameter;
    EXPECT_GE(of.upper, share) << quantity << ' ' << parameter;
    EXPECT_EQ(of.used, 63);
    EXPECT_EQ(of.dropped, 1);
  };
  held("first_order", "sand.nu", exact.nu);
  held("first_order", "chamber.wall", exact.wall);
  held("total_order", "sand.H", exact.H + exact.both);
  held("total_order", "chamber.wall", exact.wall);
}

// Inputs within their bounds are uniform: mean and variance of the made-up result are known.
TEST_F(EffectsOf, PropagationTellsWhatTheResultIsWorth) {
  const Effects effects =
      design_effects(run("[design]\nkind = \"propagation\"\nruns = 200\n", {"propagation 3"}));
  ASSERT_EQ(effects.rows.size(), 7U + 3U * 3U + 1U);
  const double nu = 0.04 / 12.0, H = 2500.0 / 12.0;  // variances
  const double variance = 1200.0 * 1200.0 * nu + 10.8 * 10.8 * H + 50.0 * 50.0 / 4.0 + 16.0 * nu * H;
  const auto held = [&](const char* quantity, double truth) {
    const EffectRow& of = row(effects, quantity, "");
    EXPECT_LE(of.lower, truth * shape()) << quantity;
    EXPECT_GE(of.upper, truth * shape()) << quantity;
    EXPECT_LT(of.upper - of.lower, 0.2 * truth * shape()) << quantity;
    EXPECT_EQ(of.used, 199);
    EXPECT_EQ(of.dropped, 1);
    EXPECT_EQ(of.note, "1 of 200 runs failed");
  };
  held("mean", 765.0);
  held("standard_deviation", std::sqrt(variance));
  double before = 0.0;
  for (const char* quantile : {"quantile_05", "quantile_25", "quantile_50", "quantile_75", "quantile_95"}) {
    EXPECT_GT(row(effects, quantile, "").value, before);
    before = row(effects, quantile, "").value;
  }
  // Of an interaction each of its two inputs has half.
  const double both = 16.0 * nu * H / variance;
  const auto shared = [&](const char* input, double alone, double interaction) {
    const EffectRow& of = row(effects, "shapley", input);
    EXPECT_NEAR(of.value, alone / variance + 0.5 * interaction, 0.02) << input;
    EXPECT_LT(of.upper - of.lower, 0.1) << input;
    EXPECT_NEAR(row(effects, "first_order", input).value, alone / variance, 0.04) << input;
    EXPECT_NEAR(row(effects, "total_order", input).value, alone / variance + interaction, 0.04) << input;
  };
  shared("sand.nu", 1200.0 * 1200.0 * nu, both);
  shared("sand.H", 10.8 * 10.8 * H, both);
  shared("chamber.wall", 50.0 * 50.0 / 4.0, 0.0);
  EXPECT_GT(row(effects, "Q2", "").value, 0.99);
}

TEST_F(EffectsOf, PropagationTellsHowOftenAThresholdIsExceeded) {
  const Effects effects =
      design_effects(run("thresholds_kPa = [1, 400, 1e6]\n[design]\nkind = \"propagation\"\nruns = 100\n"));
  std::vector<EffectRow> rows;
  std::ranges::copy_if(effects.rows, std::back_inserter(rows),
                       [](const EffectRow& r) { return r.quantity == "exceedance"; });
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].value, 1.0);
  EXPECT_EQ(rows[2].value, 0.0);
  EXPECT_EQ(rows[1].threshold_kPa, 400.0);
  EXPECT_EQ(rows[1].unit, "-");
  EXPECT_LT(rows[1].lower, rows[1].value);
  EXPECT_LT(rows[1].value, rows[1].upper);
  EXPECT_LT(rows[0].lower, 1.0);
}

// The rule looks at the first runs alone, whatever else has run or failed behind them.
TEST_F(EffectsOf, PropagationThatStopsCountsTheRunsThatSufficed) {
  const std::string design =
      "[design]\nkind = \"propagation\"\nruns = 200\nuntil = { half_width_percent = 20 }\n";
  const Snapshot whole = run(design);
  const StoredDesign all = stored_design(whole);
  ASSERT_TRUE(all.enough);
  EXPECT_GE(*all.enough, 50U);
  EXPECT_LT(*all.enough, 200U);
  EXPECT_EQ(*all.enough % 10, 0U);
  const Effects effects = design_effects(whole);
  EXPECT_EQ(effects.runs.size(), *all.enough);
  EXPECT_EQ(row(effects, "mean", "").used, static_cast<int>(*all.enough));
  EXPECT_NE(effects.stopped.find(fmt::format("± 20 % in every window after {} runs: {} of the design are not "
                                             "needed",
                                             *all.enough, 200 - *all.enough)),
            std::string::npos)
      << effects.stopped;

  std::set<std::string> later;
  for (std::size_t k = *all.enough + 1; k <= 200; ++k) later.insert(fmt::format("pending propagation {}", k));
  std::filesystem::remove(folder / "study.sqlite");
  const Effects fewer = design_effects(run(design, later));
  EXPECT_EQ(fewer.runs.size(), *all.enough);
  EXPECT_EQ(row(fewer, "mean", "").value, row(effects, "mean", "").value);
  EXPECT_EQ(row(fewer, "mean", "").upper, row(effects, "mean", "").upper);
  EXPECT_EQ(row(fewer, "mean", "").note, "");

  later.insert("pending propagation 3");
  std::filesystem::remove(folder / "study.sqlite");
  EXPECT_FALSE(stored_design(run(design, later)).enough);
}

TEST_F(EffectsOf, BandsHoldTheChannelsAtEveryDepth) {
  const Snapshot snapshot = run("[design]\nkind = \"propagation\"\nruns = 100\n", {"propagation 7"});
  const Effects effects = design_effects(snapshot);
  ASSERT_FALSE(effects.bands.empty());
  std::vector<double> mine;  // q_c of the completed runs at the depth of a row
  const DepthBandRow& band = effects.bands[effects.bands.size() / 4];
  EXPECT_EQ(band.channel, "q_c");
  EXPECT_EQ(band.runs, 99);
  for (const int id : effects.runs)
    for (const CurveRow& curve : snapshot.curves)
      if (curve.realization == id && snapshot.realizations[static_cast<std::size_t>(id - 1)].completed()) {
        const auto at = std::ranges::find(curve.profile.depth, band.depth_m) - curve.profile.depth.begin();
        mine.push_back(curve.profile.q_c[static_cast<std::size_t>(at)] / 1e3);
      }
  ASSERT_EQ(mine.size(), 99U);
  const Eigen::Map<const Eigen::VectorXd> sample(mine.data(), 99);
  EXPECT_NEAR(band.mean.value, sample.mean(), 1e-9);
  EXPECT_NEAR(band.standard_deviation, parameters::sample_deviation(sample), 1e-9);
  EXPECT_NEAR(band.quantiles[4].value, parameters::sample_quantile(sample, 0.95), 1e-9);
  EXPECT_LT(band.quantiles[0].value, band.quantiles[4].value);
  EXPECT_EQ(bands_table(effects).rows.size(), effects.bands.size());
  EXPECT_EQ(bands_table(effects).rows.front().size(), bands_table(effects).columns.size());
}

// The mean stays, the rest is wider, each channel by its own error; the words say so.
TEST_F(EffectsOf, NumericalErrorWidensWindowsAndBands) {
  const std::string design = "[design]\nkind = \"propagation\"\nruns = 50\n";
  const Effects without = design_effects(run(design));
  std::filesystem::remove(folder / "study.sqlite");
  const Effects with = design_effects(run(design + "numerical_error_percent = { q_c = 30 }\n"));
  EXPECT_EQ(with.numerical_error, "30 % of q_c");
  EXPECT_EQ(without.numerical_error, "");
  EXPECT_EQ(row(with, "mean", "").value, row(without, "mean", "").value);
  EXPECT_GT(row(with, "standard_deviation", "").value, 1.2 * row(without, "standard_deviation", "").value);
  EXPECT_GT(row(with, "quantile_95", "").value, row(without, "quantile_95", "").value);
  EXPECT_NE(row(with, "mean", "").method.find("with a numerical error of 30 %"), std::string::npos);
  EXPECT_EQ(with.convergence.back().estimate.value, row(with, "quantile_95", "").value);
  for (std::size_t k = 0; k < with.rows.size(); ++k)
    EXPECT_TRUE(with.rows[k].parameter.empty() || with.rows[k].value == without.rows[k].value);
  ASSERT_EQ(with.bands.size(), without.bands.size());
  for (std::size_t k = 0; k < with.bands.size(); ++k) {
    const bool of_tip = with.bands[k].channel == "q_c";
    EXPECT_EQ(with.bands[k].standard_deviation > without.bands[k].standard_deviation, of_tip);
  }
}

TEST_F(EffectsOf, ConvergenceEndsWithTheNumbersOfAllRuns) {
  const Effects effects = design_effects(run("[design]\nkind = \"propagation\"\nruns = 100\n"));
  std::vector<ConvergenceRow> means;
  for (const ConvergenceRow& of : effects.convergence)
    if (of.quantity == "mean") means.push_back(of);
  ASSERT_EQ(means.size(), 10U);
  EXPECT_EQ(means.front().runs, 10);
  EXPECT_EQ(means.back().runs, 100);
  EXPECT_EQ(means.back().estimate.value, row(effects, "mean", "").value);
  EXPECT_EQ(means.back().estimate.upper, row(effects, "mean", "").upper);
}

// A constant result has a mean, and no index that would be undefined.
TEST_F(EffectsOf, PropagationOfAConstantResultIsItsValue) {
  Snapshot snapshot = run("[design]\nkind = \"propagation\"\nruns = 40\n");
  for (WindowMeanRow& mean : snapshot.window_means) mean.q_c_mean_kPa = 815.15;
  const Effects effects = design_effects(snapshot);
  EXPECT_EQ(effects.runs.size(), 40U);
  EXPECT_NEAR(row(effects, "mean", "").value, 815.15, 1e-9);
  EXPECT_NEAR(row(effects, "standard_deviation", "").value, 0.0, 1e-9);
  for (const EffectRow& of : effects.rows)
    EXPECT_EQ(of.note, std::isfinite(of.value) ? "" : "undefined: the result does not vary") << of.quantity;
  EXPECT_TRUE(std::isnan(row(effects, "Q2", "").value));
}

// Every design of results that are the same but for their last digits: no number, and the reason.
TEST_F(EffectsOf, ResultsThatDoNotVaryAreUndefined) {
  for (const char* kind : {"pairs", "morris", "latin_hypercube", "sobol"}) {
    std::filesystem::remove(folder / "study.sqlite");
    Snapshot snapshot = run(fmt::format("[design]\nkind = \"{}\"\n{}", kind,
                                        std::string_view(kind) == "sobol" ? "runs = 4\n" : ""),
                            {}, "repeats = 2\n");
    double last_digits = 0.0;
    for (WindowMeanRow& mean : snapshot.window_means) mean.q_c_mean_kPa = 815.15 + (last_digits += 1e-13);
    const Effects effects = design_effects(snapshot);
    ASSERT_FALSE(effects.rows.empty()) << kind;
    for (const EffectRow& of : effects.rows) {
      EXPECT_TRUE(std::isnan(of.value) && std::isnan(of.lower) && std::isnan(of.upper))
          << kind << ' ' << of.quantity << ' ' << of.value;
      EXPECT_EQ(of.note, "undefined: the result does not vary") << kind << ' ' << of.quantity;
      EXPECT_EQ(of.dropped, 0) << kind;
    }
  }
}

TEST_F(EffectsOf, SaysWhatElseIsMissingBesideAConstantResult) {
  Snapshot snapshot = run("[design]\nkind = \"morris\"\ntrajectories = 6\n", {"morris 2.1"});
  for (WindowMeanRow& mean : snapshot.window_means) mean.q_c_mean_kPa = 815.15;
  const Effects effects = design_effects(snapshot);
  EXPECT_TRUE(std::isnan(effects.rows.front().value));
  EXPECT_TRUE(effects.rows.front().note.starts_with("undefined: the result does not vary; 1 of "))
      << effects.rows.front().note;
}

TEST_F(EffectsOf, SaysWhichRunsAreOutOfLine) {
  Snapshot snapshot = run("[design]\nkind = \"latin_hypercube\"\nruns = 20\n");
  snapshot.realizations.back().out_of_line = "energy error -18 %";
  EXPECT_TRUE(
      row(design_effects(snapshot), "first_order", "sand.nu").note.ends_with("1 of 20 runs out of line"));
}

TEST_F(EffectsOf, EveryNumberSaysHowItWasEstimatedAndFromHowManyRuns) {
  struct Case {
    const char *design, *quantity, *method;
    int runs;
  };
  for (const Case& of :
       {Case{"kind = \"pairs\"", "interaction", "second difference, interval from repeats", 4},
        Case{"kind = \"morris\"\ntrajectories = 8", "mu_star",
             "elementary effects, bootstrap over trajectories", 16},
        Case{"kind = \"latin_hypercube\"\nruns = 40", "total_order",
             "sparse polynomial chaos, jackknife over ten folds", 40},
        Case{"kind = \"latin_hypercube\"\nruns = 40", "Q2", "ten-fold cross-validation", 40},
        Case{"kind = \"sobol\"\nruns = 8", "first_order", "Saltelli, bootstrap over rows", 40},
        Case{"kind = \"sobol\"\nruns = 8", "total_order", "Jansen, bootstrap over rows", 40},
        Case{"kind = \"sobol\"\nruns = 20\nsections = 5\nestimator = \"martinez\"", "total_order",
             "Martinez, 5 sections", 100},
        Case{"kind = \"propagation\"\nruns = 40", "mean", "randomized Sobol' points, ten sections", 40}}) {
    std::filesystem::remove(folder / "study.sqlite");
    const Effects effects = design_effects(run(fmt::format("[design]\n{}\n", of.design)));
    const auto found = std::ranges::find(effects.rows, of.quantity, &EffectRow::quantity);
    ASSERT_NE(found, effects.rows.end()) << of.design;
    EXPECT_EQ(found->method, of.method) << of.design;
    EXPECT_EQ(found->runs, of.runs) << of.design;
  }
}

// What the first runs alone would say is what a study of these runs says.
TEST_F(EffectsOf, ConvergenceIsThatOfTheFirstRuns) {
  struct Case {
    const char *whole, *sixth, *quantity;
  };
  for (const Case& of :
       {Case{"kind = \"morris\"\ntrajectories = 18", "kind = \"morris\"\ntrajectories = 3", "mu_star"},
        Case{"kind = \"sobol\"\nruns = 48", "kind = \"sobol\"\nruns = 8", "total_order"}}) {
    std::filesystem::remove(folder / "study.sqlite");
    const Effects small = design_effects(run(fmt::format("[design]\n{}\n", of.sixth)));
    std::filesystem::remove(folder / "study.sqlite");
    const Snapshot snapshot = run(fmt::format("[design]\n{}\n", of.whole));
    Effects effects = design_effects(snapshot);
    EXPECT_TRUE(effects.index_convergence.empty());
    add_index_convergence(snapshot, effects);
    ASSERT_EQ(effects.index_convergence.size(), 18U) << of.whole;  // six steps of three inputs
    for (std::size_t j = 0; j < 3; ++j) {
      const EffectRow &first = effects.index_convergence[j], &last = effects.index_convergence[15 + j];
      const EffectRow& alone = row(small, of.quantity, first.parameter);
      const EffectRow& all = row(effects, of.quantity, last.parameter);
      EXPECT_EQ(first.value, alone.value) << of.whole;
      EXPECT_DOUBLE_EQ(first.lower, alone.lower) << of.whole;
      EXPECT_EQ(first.runs, alone.runs) << of.whole;
      EXPECT_EQ(first.dropped, 0) << of.whole;
      EXPECT_EQ(last.value, all.value) << of.whole;
      EXPECT_EQ(last.upper, all.upper) << of.whole;
      EXPECT_EQ(last.runs, 6 * first.runs) << of.whole;
    }
    EXPECT_EQ(index_convergence_table(effects).rows.size(), 18U);
  }
}

TEST_F(EffectsOf, ConvergenceOfALatinHypercubeGoesOverItsRuns) {
  const Snapshot snapshot = run("[design]\nkind = \"latin_hypercube\"\nruns = 60\n");
  Effects effects = design_effects(snapshot);
  add_index_convergence(snapshot, effects);
  ASSERT_EQ(effects.index_convergence.size(), 18U);
  for (std::size_t step = 0; step < 6; ++step)
    EXPECT_EQ(effects.index_convergence[3 * step].used, static_cast<int>(10 * (step + 1)));
  const Snapshot pairs = [&] {
    std::filesystem::remove(folder / "study.sqlite");
    return run("[design]\nkind = \"pairs\"\n");
  }();
  Effects of_pairs = design_effects(pairs);
  add_index_convergence(pairs, of_pairs);
  EXPECT_TRUE(of_pairs.index_convergence.empty());
}

TEST_F(EffectsOf, AStudyWithoutDesignHasNone) {
  EXPECT_TRUE(design_effects(run("")).rows.empty());
  EXPECT_TRUE(query(study.database, "effects").rows.empty());
}

TEST_F(EffectsOf, TextThatIsNoStudyIsTold) {
  Snapshot snapshot = run("[design]\nkind = \"pairs\"\n");
  snapshot.campaign.study_text = "[study]\n";
  EXPECT_TRUE(design_effects(snapshot).rows.empty());
  EXPECT_NE(design_effects(snapshot).problem, "");
}

// A ledger whose rows are not those of its text: no number is taken for another.
TEST_F(EffectsOf, RowsThatAreOthersDoNotCount) {
  Snapshot snapshot = run("[design]\nkind = \"latin_hypercube\"\nruns = 20\n");
  for (RealizationRow& realization : snapshot.realizations)
    if (realization.parameter == "latin hypercube 4") realization.value_text = "sand.nu = 0.25";
  EXPECT_EQ(row(design_effects(snapshot), "Q2", "").dropped, 1);
  for (RealizationRow& realization : snapshot.realizations) realization.value_text = "other";
  EXPECT_TRUE(design_effects(snapshot).rows.empty());
}

TEST_F(EffectsOf, QueryPrintsThem) {
  run("[design]\nkind = \"morris\"\ntrajectories = 3\n");
  const Table table = query(study.database, "effects");
  EXPECT_EQ(table.rows.size(), 9U);
  EXPECT_EQ(table.columns.front(), "window");
  EXPECT_TRUE(
      format(table, Format::csv)
          .starts_with("window,parameter,other_parameter,quantity,unit,threshold_kPa,value,lower,upper,used,"
                       "dropped,note,method,runs\n"
                       "deep,sand.nu,,mu_star,kPa,"));
}

}  // namespace
}  // namespace cpt::results

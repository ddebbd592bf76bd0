// Equation 3 of Yost et al. (2023), by hand, and the ledger's view against it.
#include "results/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "results/query.hpp"
#include "results/repeat_noise.hpp"
#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

TEST(SensitivityIndex, HandValues) {
  EXPECT_DOUBLE_EQ(sensitivity_index(3000.0, 4000.0), 0.25);
  EXPECT_DOUBLE_EQ(sensitivity_index(4000.0, 3000.0), -1.0 / 3.0);  // falls: negative, and not -0.25
  EXPECT_DOUBLE_EQ(sensitivity_index(9000.0, 3000.0), -2.0);        // no lower bound of -1
  EXPECT_DOUBLE_EQ(sensitivity_index(3000.0, 3000.0), 0.0);
}

TEST(SensitivityIndex, UndefinedWithoutAPositiveUpper) {
  EXPECT_TRUE(std::isnan(sensitivity_index(1.0, 0.0)));
  EXPECT_TRUE(std::isnan(sensitivity_index(1.0, -5.0)));
  EXPECT_TRUE(std::isnan(sensitivity_index(1.0, std::nan(""))));
  EXPECT_TRUE(std::isnan(sensitivity_index(std::nan(""), 1.0)));
}

TEST(NoiseIndex, EmbeddedSandOfThePaper) { EXPECT_NEAR(noise_index(1552.0, 1637.0), 0.0519, 5e-5); }

TEST(NoiseIndex, UndefinedWithoutAPositiveMaximum) { EXPECT_TRUE(std::isnan(noise_index(-1.0, 0.0))); }

class SensitivityView : public ScratchFolder {
 protected:
  parameters::Study study = sand_study(folder);
  /// Records every realization at its level in Pa; those without one are left pending.
  Snapshot run(const std::map<int, double>& levels, const std::map<int, solver::Outcome>& others = {}) {
    Ledger ledger = open(study);
    for (const auto& [id, level] : levels) ledger.record(id, completed(level));
    for (const auto& [id, outcome] : others) ledger.record(id, outcome);
    return read_snapshot(study.database);
  }
  static const SensitivityRow& find(const Snapshot& s, std::string_view window, std::string_view parameter) {
    return *std::find_if(s.sensitivity.begin(), s.sensitivity.end(),
                         [&](const auto& r) { return r.window == window && r.parameter == parameter; });
  }
};

// Ids: 1 baseline, 2/3 H lower/upper, 4 N upper, 5 radius lower, 6 wall lower, 7/8 sigma_h0 lower/upper.
const std::map<int, double> all_levels = {{1, 4e6},   {2, 3.6e6}, {3, 8e6},    {4, 4.01e6},
                                          {5, 4.2e6}, {6, 3e6},   {7, 4.05e6}, {8, 3.95e6}};

TEST_F(SensitivityView, AgreesWithThePureFunctionsEverywhere) {
  const Snapshot s = run(all_levels);
  ASSERT_EQ(s.sensitivity.size(), study.rows.size() * study.windows.size());
  std::map<std::pair<int, std::string>, WindowMeanRow> means;
  for (const auto& mean : s.window_means) means[{mean.realization, mean.window}] = mean;
  const std::vector<std::pair<int, int>> bounds = {{2, 3}, {1, 4}, {5, 1}, {6, 1}, {7, 8}};
  for (std::size_t i = 0; i < s.sensitivity.size(); ++i) {
    const SensitivityRow& row = s.sensitivity[i];
    const auto [lower, upper] = bounds[i % bounds.size()];
    const double q_lower = means.at({lower, row.window}).q_c_mean_kPa;
    const double q_upper = means.at({upper, row.window}).q_c_mean_kPa;
    const WindowMeanRow& base = means.at({1, row.window});
    EXPECT_EQ(row.q_lower_kPa, q_lower);
    EXPECT_EQ(row.q_upper_kPa, q_upper);
    EXPECT_EQ(row.q_baseline_kPa, base.q_c_mean_kPa);
    EXPECT_EQ(row.si, sensitivity_index(q_lower, q_upper));
    EXPECT_EQ(row.si_abs, std::abs(row.si));
    EXPECT_EQ(row.si_noise, noise_index(base.q_c_min_kPa, base.q_c_max_kPa));
    EXPECT_EQ(row.above_noise, std::optional(row.si_abs > row.si_noise));
  }
}

TEST_F(SensitivityView, WindowsFollowTheBaselinesPeak) {
  const Snapshot s = run(all_levels);
  ASSERT_EQ(s.windows.size(), 2u);
  EXPECT_EQ(s.windows[0].from_m, 0.30);
  EXPECT_NEAR(0.5 * (s.windows[1].from_m + s.windows[1].to_m), 0.15, 0.004);
  EXPECT_NEAR(s.windows[1].to_m - s.windows[1].from_m, 0.010, 1e-12);
}

TEST_F(SensitivityView, SaysWhereTheIndexIsNegative) {
  const Snapshot s = run(all_levels);
  const auto& radius = find(s, "deep", "chamber.radius_m");
  EXPECT_LT(radius.si, 0.0);
  EXPECT_EQ(radius.note, "negative: q_c is larger at the lower bound");
  EXPECT_EQ(find(s, "deep", "sand.H").note, "");
}

TEST_F(SensitivityView, SaysWhereBothBoundsRaiseTheResistance) {
  auto levels = all_levels;
  levels[2] = 7e6;
  EXPECT_EQ(find(run(levels), "deep", "sand.H").note, "one-sided: both bounds raise q_c");
}

TEST_F(SensitivityView, SaysWhichRunIsMissingAndWhy) {
  auto levels = all_levels;
  levels.erase(3);
  levels.erase(7);
  levels.erase(8);
  const Snapshot s = run(levels, {{3, failed(solver::Status::did_not_converge, "no")},
                                  {7, failed(solver::Status::crashed, "signal 11")}});
  const auto& h = find(s, "deep", "sand.H");
  EXPECT_TRUE(std::isnan(h.si));
  EXPECT_TRUE(std::isnan(h.q_upper_kPa));
  EXPECT_FALSE(h.above_noise.has_value());
  EXPECT_EQ(h.note, "undefined: upper run failed (did_not_converge)");
  EXPECT_EQ(find(s, "deep", "initial.sigma_h0_kPa").note,
            "undefined: lower run failed (crashed), upper run pending");
}

TEST_F(SensitivityView, UndefinedWhereTheUpperResistanceIsZero) {
  auto levels = all_levels;
  levels[3] = 0.0;
  const Snapshot s = run(levels);
  EXPECT_TRUE(std::isnan(find(s, "deep", "sand.H").si));
  EXPECT_EQ(find(s, "deep", "sand.H").note, "undefined: q_c at the upper bound is not positive");
}

TEST_F(SensitivityView, FailedBaselineLeavesNoiseAndPeakWindowsUndefined) {
  auto levels = all_levels;
  levels.erase(1);
  const Snapshot s = run(levels, {{1, failed(solver::Status::energy_drift, "drift")}});
  EXPECT_FALSE(std::isnan(find(s, "deep", "sand.H").si));
  EXPECT_EQ(find(s, "deep", "sand.H").note, "noise undefined: baseline run failed (energy_drift)");
  EXPECT_EQ(find(s, "deep", "sand.N").note, "undefined: baseline run failed (energy_drift)");
  EXPECT_EQ(find(s, "peak", "sand.H").note,
            "undefined: baseline run failed (energy_drift), which places the window");
}

TEST_F(SensitivityView, WindowBelowThePushIsToldNotHidden) {
  study.windows[0].from = 0.55;
  study.windows[0].to = 0.56;
  EXPECT_EQ(find(run(all_levels), "deep", "sand.H").note,
            "undefined: lower run has no q_c in the window, upper run has no q_c in the window, "
            "baseline run has no q_c in the window");
}

TEST_F(SensitivityView, TornadoIsSortedBySwingWithMissingLast) {
  auto levels = all_levels;
  levels.erase(7);
  run(levels, {{7, failed(solver::Status::time_limit, "too slow")}});
  const Table tornado =
      query_sql(study.database, "SELECT rank, parameter, swing_kPa FROM tornado WHERE window='deep'");
  std::vector<std::string> order;
  for (const auto& row : tornado.rows) order.push_back(std::get<std::string>(row[1]));
  EXPECT_EQ(order, (std::vector<std::string>{"sand.H", "chamber.wall", "chamber.radius_m", "sand.N",
                                             "initial.sigma_h0_kPa"}));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(tornado.rows.back()[2]));
}

TEST_F(SensitivityView, HasTheDocumentedColumnsInOrder) {
  run({});
  EXPECT_EQ(query(study.database, "sensitivity").columns,
            (std::vector<std::string>{"window", "parameter", "q_lower_kPa", "q_upper_kPa", "q_baseline_kPa",
                                      "si", "si_abs", "si_noise", "above_noise", "si_half_width",
                                      "above_repeats", "note"}));
}

// Four repeats follow the eight bounds; with the baseline they are five runs.
TEST_F(SensitivityView, RepeatsGiveTheIndexAnInterval) {
  for (int k = 1; k <= 4; ++k)
    study.points.push_back(
        {fmt::format("repeat {}", k), {{solver::find_quantity("numerics.point_shift"), 0.1 * k}}, true});
  auto levels = all_levels;
  levels.insert({{9, 3.9e6}, {10, 4.1e6}});
  const SensitivityRow some = find(run(levels), "deep", "sand.H");
  const std::vector<double> three = {4.0, 3.9, 4.1}, five = {4.0, 3.9, 4.1, 3.95, 4.06};
  EXPECT_NEAR(some.si_half_width, index_half_width(repeat_noise(three).value()), 1e-12);

  Ledger ledger = open(study);
  ledger.record(11, completed(3.95e6));
  ledger.record(12, completed(4.06e6));
  const Snapshot s = read_snapshot(study.database);
  const RepeatNoise noise = repeat_noise(five).value();
  ASSERT_EQ(s.repeat_noise.size(), 2U);
  EXPECT_EQ(s.repeat_noise[0].window, "deep");
  EXPECT_EQ(s.repeat_noise[0].runs, 5);
  EXPECT_NEAR(s.repeat_noise[0].q_c_deviation_kPa / s.repeat_noise[0].q_c_mean_kPa,
              noise.deviation / noise.mean, 1e-12);
  EXPECT_EQ(find(s, "deep", "sand.H").above_repeats, std::optional(true));
  EXPECT_EQ(find(s, "deep", "sand.N").above_repeats, std::optional(false));
  EXPECT_NEAR(find(s, "deep", "sand.N").si_half_width, index_half_width(noise), 1e-12);
}

TEST_F(SensitivityView, HasNoIntervalWithoutRepeats) {
  const Snapshot s = run(all_levels);
  EXPECT_TRUE(s.repeat_noise.empty());
  EXPECT_TRUE(std::isnan(s.sensitivity[0].si_half_width));
  EXPECT_FALSE(s.sensitivity[0].above_repeats.has_value());
}

}  // namespace
}  // namespace cpt::results

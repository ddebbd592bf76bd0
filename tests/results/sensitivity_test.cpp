// Equation 3 of Yost et al. (2023), by hand, and the ledger's view against it.
#include "results/statistics/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "results/files/database.hpp"
#include "results/ledger/audit_bounds.hpp"
#include "results/statistics/repeat_noise.hpp"
#include "results/tables/query.hpp"
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
                                      "above_repeats", "above_si_noise", "pairs", "note"}));
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
  EXPECT_NEAR(some.si_half_width, index_half_width(repeat_noise(three).value(), 3.6, 8.0), 1e-12);

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
  for (const SensitivityRow& row : s.sensitivity) {
    if (row.window != "deep") continue;
    EXPECT_NEAR(row.si_half_width, index_half_width(noise, row.q_lower_kPa, row.q_upper_kPa), 1e-12)
        << row.parameter;
  }
  EXPECT_NEAR(s.repeat_noise[0].si_half_width, index_half_width(noise), 1e-12);
}

TEST_F(SensitivityView, HasNoIntervalWithoutRepeats) {
  const Snapshot s = run(all_levels);
  EXPECT_TRUE(s.repeat_noise.empty());
  EXPECT_TRUE(std::isnan(s.sensitivity[0].si_half_width));
  EXPECT_FALSE(s.sensitivity[0].above_repeats.has_value());
}

// Both bounds again with the shifts of the repeats: the scatter of the pairs' indices is the row's interval.
// Here the shift moves all runs alike, which an interval from the baseline's scatter alone cannot know.
TEST_F(SensitivityView, PairsGiveTheirRowItsInterval) {
  const auto* shift = solver::find_quantity("numerics.point_shift");
  const auto* H = solver::find_quantity("sand.H");
  const auto* N = solver::find_quantity("sand.N");
  for (int k = 1; k <= 3; ++k)
    study.points.push_back({fmt::format("repeat {}", k), {{shift, 0.1 * k}}, true});
  for (int k = 1; k <= 3; ++k) {
    study.points.push_back({fmt::format("repeat {}, sand.H lower", k), {{shift, 0.1 * k}, {H, 20}}});
    study.points.push_back({fmt::format("repeat {}, sand.H upper", k), {{shift, 0.1 * k}, {H, 75}}});
    study.points.push_back({fmt::format("repeat {}, sand.N upper", k), {{shift, 0.1 * k}, {N, 0.3}}});
  }
  // Baseline 4, lower H 3.6, upper H 8, upper N 4.01; repeats 3.9, 4.1, 4.2.
  auto levels = all_levels;
  levels.insert({{9, 3.9e6}, {10, 4.1e6}, {11, 4.2e6}});
  const double H_lower[] = {3.51e6, 3.68e6, 3.80e6}, H_upper[] = {7.80e6, 8.22e6, 8.38e6},
               N_upper[] = {3.93e6, 4.10e6, 4.20e6};
  for (int k = 0; k < 3; ++k) {
    levels[12 + 3 * k] = H_lower[k];
    levels[13 + 3 * k] = H_upper[k];
    levels[14 + 3 * k] = N_upper[k];
  }
  levels.erase(19);  // of the third pair of H: two pairs and its own run are left
  const Snapshot s = run(levels, {{19, failed(solver::Status::crashed, "made up")}});
  const auto expected = [](const std::vector<std::pair<double, double>>& runs) {
    std::vector<double> indices;
    for (const auto& [lower, upper] : runs) indices.push_back(sensitivity_index(lower, upper));
    return paired_half_width(indices);
  };
  const SensitivityRow &of_H = find(s, "deep", "sand.H"), &of_N = find(s, "deep", "sand.N");
  EXPECT_EQ(of_H.pairs, 3);
  EXPECT_NEAR(of_H.si_half_width, expected({{3.6, 8.0}, {3.51, 7.80}, {3.68, 8.22}}), 1e-9);
  EXPECT_EQ(of_N.pairs, 4) << "its lower bound is the baseline, whose repeats are there";
  EXPECT_NEAR(of_N.si_half_width, expected({{4.0, 4.01}, {3.9, 3.93}, {4.1, 4.10}, {4.2, 4.20}}), 1e-9);
  const SensitivityRow& alone = find(s, "deep", "initial.sigma_h0_kPa");
  EXPECT_EQ(alone.pairs, 0);
  EXPECT_NEAR(alone.si_half_width, s.repeat_noise[0].si_half_width * alone.q_lower_kPa / alone.q_upper_kPa,
              1e-12);
  EXPECT_EQ(s.repeat_noise[0].runs, 4) << "pairs are no repeats of the baseline";
  EXPECT_LT(of_H.si_half_width, 0.3 * s.repeat_noise[0].si_half_width * of_H.q_lower_kPa / of_H.q_upper_kPa);
}

// Where there are repeats they say what is noise; SI_noise, which holds the trend of q_c with depth, is shown
// beside.
TEST_F(SensitivityView, RepeatsDecideWhatIsNoise) {
  const SensitivityRow alone = find(run(all_levels), "deep", "initial.sigma_h0_kPa");  // |SI| 0.025
  EXPECT_LT(alone.si_abs, alone.si_noise);
  EXPECT_EQ(alone.above_noise, std::optional(false));
  EXPECT_EQ(alone.above_si_noise, std::optional(false));
  EXPECT_FALSE(alone.above_repeats.has_value());

  for (int k = 1; k <= 2; ++k)
    study.points.push_back(
        {fmt::format("repeat {}", k), {{solver::find_quantity("numerics.point_shift"), 0.1 * k}}, true});
  const auto with_repeats = [&](double a, double b) {
    std::filesystem::remove(study.database);
    auto levels = all_levels;
    levels.insert({{9, a}, {10, b}});
    return run(levels);
  };
  const SensitivityRow quiet = find(with_repeats(4.001e6, 3.999e6), "deep", "initial.sigma_h0_kPa");
  EXPECT_EQ(quiet.above_repeats, std::optional(true));
  EXPECT_EQ(quiet.above_noise, std::optional(true));
  EXPECT_EQ(quiet.above_si_noise, std::optional(false));
  const Snapshot loud = with_repeats(8e6, 2e6);
  EXPECT_EQ(find(loud, "deep", "sand.H").above_noise, std::optional(false));
  EXPECT_EQ(find(loud, "deep", "sand.H").above_si_noise, std::optional(true));
}

// All averages the same but for their last digits, as another program's table may have them.
TEST_F(SensitivityView, ResultsThatDoNotVaryHaveNoIndex) {
  auto levels = all_levels;
  for (auto& [id, level] : levels) level = 4e6 * (1.0 + 1e-14 * id);
  const Snapshot s = run(levels);
  for (const SensitivityRow& row : s.sensitivity) {
    EXPECT_TRUE(std::isnan(row.si)) << row.parameter;
    EXPECT_EQ(row.note, "undefined: the result does not vary") << row.parameter;
    EXPECT_FALSE(row.above_noise.has_value());
    EXPECT_FALSE(row.above_si_noise.has_value());
  }
  const Table tornado = query_sql(study.database, "SELECT swing_kPa FROM tornado");
  for (const auto& row : tornado.rows) EXPECT_EQ(std::get<double>(row[0]), 0.0);
}

TEST_F(SensitivityView, AnInputThatChangesTheLastDigitsHasTheIndexZero) {
  auto levels = all_levels;
  levels[8] = levels[7] * (1.0 - 1e-14);
  const Snapshot s = run(levels);
  const SensitivityRow& same = find(s, "deep", "initial.sigma_h0_kPa");
  EXPECT_EQ(same.si, 0.0);
  EXPECT_EQ(same.note, "");
  EXPECT_EQ(same.above_noise, std::optional(false));
  EXPECT_NE(find(s, "deep", "sand.H").si, 0.0);
}

// The notes against the bounds that are documented.
TEST_F(SensitivityView, SaysWhichRunsOfAnIndexAreOutOfLine) {
  solver::Outcome off = completed(8e6), rough = completed(4.05e6), fine = completed(3.95e6),
                  base = completed(4e6);
  off.audit.energy_error = -(most_energy_error + 0.08);
  off.audit.kinetic_fraction = most_kinetic_fraction + 0.05;
  off.audit.limited_share = 2.5 * most_limited_share;
  off.audit.safeguarded_share = 3.0 * most_safeguarded_share;
  fine.audit.limited_share = most_limited_share;
  fine.audit.safeguarded_share = most_safeguarded_share;
  rough.audit.momentum_error = most_momentum_error + 0.01;
  fine.audit.energy_error = -most_energy_error;  // at the bound: in line
  base.audit.max_empty_cells =
      1 + static_cast<int>(most_empty_share * static_cast<double>(base.material_points));
  auto levels = all_levels;
  for (const int id : {1, 3, 7, 8}) levels.erase(id);
  const Snapshot s = run(levels, {{1, base}, {3, off}, {7, rough}, {8, fine}});
  EXPECT_EQ(find(s, "deep", "sand.H").note,
            "upper run out of line: energy error -18 %, kinetic energy 15 %, "
            "0.25 % of the motion of mixed cells limited, 0.30 % of the points at a safeguard of their law");
  EXPECT_EQ(find(s, "deep", "initial.sigma_h0_kPa").note,
            "negative: q_c is larger at the lower bound; lower run out of line: momentum error 11 %");
  EXPECT_EQ(find(s, "deep", "sand.N").note, "baseline run out of line: 3 empty cells");
  EXPECT_EQ(s.realizations[2].out_of_line,
            "energy error -18 %, kinetic energy 15 %, "
            "0.25 % of the motion of mixed cells limited, 0.30 % of the points at a safeguard of their law");
  EXPECT_EQ(s.realizations[7].out_of_line, "");
  const Table audit =
      query_sql(study.database, "SELECT out_of_line FROM audit WHERE realization IN (2, 3, 6)");
  EXPECT_EQ(std::get<std::string>(audit.rows[0][0]), "");
  EXPECT_EQ(std::get<std::string>(audit.rows[1][0]), s.realizations[2].out_of_line);
  const Table tornado = query_sql(study.database, "SELECT note FROM tornado WHERE parameter = 'sand.H'");
  EXPECT_EQ(std::get<std::string>(tornado.rows[0][0]), find(s, "deep", "sand.H").note);
}

// A database that was finished by an earlier program is read with this program's views.
TEST_F(SensitivityView, ViewsInTheFileDoNotMatter) {
  const Snapshot own = run(all_levels);
  {
    const Database database(study.database, Database::Mode::read_write);
    database.execute(
        "DROP VIEW tornado; DROP VIEW sensitivity; DROP VIEW audit;"
        "CREATE VIEW sensitivity AS SELECT 'x' AS window, 'y' AS parameter, 1.0 AS si");
  }
  const Snapshot read = read_snapshot(study.database);
  ASSERT_EQ(read.sensitivity.size(), own.sensitivity.size());
  for (std::size_t i = 0; i < own.sensitivity.size(); ++i)
    EXPECT_EQ(read.sensitivity[i].si, own.sensitivity[i].si);
  EXPECT_EQ(query(study.database, "tornado").rows.size(), own.sensitivity.size());
}

}  // namespace
}  // namespace cpt::results

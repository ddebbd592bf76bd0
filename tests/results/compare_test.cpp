#include "results/tables/compare.hpp"

#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

class Compare : public ScratchFolder {
 protected:
  /// A finished campaign whose q_c is everywhere this high [Pa], but at H = 75, where it is twice that.
  Snapshot run(const std::string& name, double level, double upper_H = 75.0, double sigma_v0 = 50.0e3) {
    parameters::Study study = sand_study(folder);
    study.name = name;
    study.database = folder / (name + ".sqlite");
    study.rows[0] = row("sand.H", 20, 25, upper_H);
    study.baseline.initial.sigma_v0 = sigma_v0;
    Ledger ledger = open(study);
    for (const int id : ledger.pending()) ledger.record(id, completed(id == 3 ? 2.0 * level : level));
    return read_snapshot(study.database);
  }
  static std::string text(const Cell& cell) { return std::get<std::string>(cell); }
  static double number(const Cell& cell) { return std::get<double>(cell); }
};

TEST_F(Compare, MeansOfTheSameRealizationsStandSideBySide) {
  const Table table = compare_means(run("a", 4e6), run("b", 5e6));
  ASSERT_EQ(table.rows.size(), 16U);  // eight realizations in two windows
  for (const auto& cells : table.rows) {
    EXPECT_NEAR(number(cells[6]), 0.25, 1e-12);
    EXPECT_NEAR(number(cells[5]) / number(cells[4]), 1.25, 1e-12);
    EXPECT_EQ(text(cells[7]), "");
  }
  EXPECT_EQ(text(table.rows[0][2]), "baseline");
}

TEST_F(Compare, WhatOneLacksIsSaid) {
  const Table table = compare_means(run("a", 4e6), run("b", 4e6, 60.0));
  std::map<std::string, std::string> notes;
  for (const auto& cells : table.rows)
    if (text(cells[0]) == "deep" && text(cells[1]) == "sand.H" && text(cells[2]) == "upper")
      notes[text(cells[3])] = text(cells[7]);
  EXPECT_EQ(notes, (std::map<std::string, std::string>{{"75", "only in a"}, {"60", "only in b"}}));
}

TEST_F(Compare, AFailedOrWaitingRunIsNotCalledAbsent) {
  const Snapshot a = run("a", 4e6);
  parameters::Study study = sand_study(folder);
  study.name = "b";
  study.database = folder / "b.sqlite";
  {
    Ledger ledger = open(study);
    ledger.record(1, completed(5e6));
    ledger.record(2, failed(solver::Status::crashed, "signal 11"));
    ledger.mark_running(3);
  }
  const Snapshot b = read_snapshot(study.database);
  const auto notes = [](const Table& table) {
    std::map<std::string, std::string> found;
    for (const auto& cells : table.rows)
      if (text(cells[0]) == "deep") found[text(cells[1]) + " " + text(cells[3])] = text(cells[7]);
    return found;
  };
  auto of = notes(compare_means(a, b));
  EXPECT_EQ(of[" "], "");
  EXPECT_EQ(of["sand.H 20"], "b failed (crashed)");
  EXPECT_EQ(of["sand.H 75"], "b interrupted");
  EXPECT_EQ(of["sand.N 0.3"], "b not run yet");
  of = notes(compare_means(b, b));
  EXPECT_EQ(of["sand.H 20"], "a failed (crashed), b failed (crashed)") << "no row is lost in silence";
  EXPECT_EQ(of.size(), 8U);
  const Table indices = compare_sensitivity(a, b);
  const std::string note = text(indices.rows[0].back());
  EXPECT_NE(note.find("b: undefined: lower run failed (crashed), upper run interrupted"), std::string::npos)
      << note;
}

TEST_F(Compare, IndicesAndTheirNoise) {
  const Snapshot a = run("a", 4e6), b = run("b", 5e6);
  const Table table = compare_sensitivity(a, b);
  ASSERT_EQ(table.rows.size(), a.sensitivity.size());
  EXPECT_EQ(text(table.rows[0][1]), "sand.H");
  EXPECT_NEAR(number(table.rows[0][2]), 0.5, 1e-12);
  EXPECT_NEAR(number(table.rows[0][2]), number(table.rows[0][3]), 1e-12);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(table.rows[0][4])) << "no repeats, no interval";
  EXPECT_EQ(std::get<std::int64_t>(table.rows[0][6]), std::int64_t{*a.sensitivity[0].above_noise});
  EXPECT_NEAR(number(table.rows[0][8]), a.sensitivity[0].si_noise, 1e-15);
}

TEST_F(Compare, IndicesHaveTheirIntervalsVerdictsAndNotes) {
  Snapshot a = run("a", 4e6), b = run("b", 5e6);
  a.sensitivity[0].si_half_width = 0.125;
  a.sensitivity[0].above_noise = true;
  b.sensitivity[0].above_noise = false;
  b.sensitivity[0].note = "upper run out of line: energy error -18 %";
  const auto row = compare_sensitivity(a, b).rows[0];
  EXPECT_EQ(number(row[4]), 0.125);
  EXPECT_EQ(std::get<std::int64_t>(row[6]), 1);
  EXPECT_EQ(std::get<std::int64_t>(row[7]), 0);
  EXPECT_EQ(text(row[10]), "b: upper run out of line: energy error -18 %");
}

TEST_F(Compare, SettingsThatDiffer) {
  const Snapshot a = run("a", 4e6), b = run("b", 4e6, 60.0, 60.0e3);
  const Table table = compare_settings(a, b);
  ASSERT_EQ(table.rows.size(), 2U) << format(table, Format::table);
  EXPECT_EQ(text(table.rows[0][0]), "initial.sigma_v0_kPa");
  EXPECT_EQ(text(table.rows[1][0]), "sand.H, bounds");
  EXPECT_EQ(text(table.rows[1][2]), "20 to 60");
  EXPECT_TRUE(compare_settings(a, a).rows.empty());
}

}  // namespace
}  // namespace cpt::results

// Results made elsewhere as a database of a study.
#include <fmt/format.h>

#include <algorithm>

#include "parameters/read_study.hpp"
#include "results/statistics/effects.hpp"
#include "results/tables/import_results.hpp"
#include "results/tables/samples.hpp"
#include "tests/results/campaign_fixture.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::results {
namespace {

using parameters::FieldTable;
using parameters::Sample;

class ImportSamples : public ScratchFolder {
 protected:
  ImportSamples() { study.windows.pop_back(); }  // a peak has no place without a curve

  [[nodiscard]] Sample sample(const std::string& name, std::vector<parameters::Change> changes,
                              double mean) const {
    return {name, {}, std::move(changes), "completed", "", {{mean, nan, nan}}};
  }
  static parameters::Change change(const char* name, double value) {
    return {solver::find_quantity(name), value};
  }

  Snapshot import(const std::vector<Sample>& samples) {
    remarks = import_samples(study, "[study]\n", samples, {"other.csv", std::string(64, 'b')}, target);
    return read_snapshot(target);
  }

  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  parameters::Study study = sand_study(folder);
  std::filesystem::path target = folder / "other.sqlite";
  Remarks remarks;
};

TEST_F(ImportSamples, StandForTheRealizationsWhoseInputsTheyHave) {
  const Snapshot s =
      import({sample("x", {change("sand.H", 75)}, 1500.0), sample("y", {change("sand.H", 25)}, 1000.0),
              sample("z", {change("sand.H", 20)}, 900.0), sample("w", {change("sand.H", 33)}, 1100.0)});
  ASSERT_EQ(s.realizations.size(), 9U);
  EXPECT_EQ(s.realizations[0].status, "completed");  // y: the baseline
  EXPECT_EQ(s.realizations[2].side, "upper");
  EXPECT_EQ(s.realizations[2].status, "completed");
  EXPECT_EQ(s.realizations[3].status, "pending");
  EXPECT_EQ(s.realizations[8].side, "point");
  EXPECT_EQ(s.realizations[8].parameter, "w");
  EXPECT_EQ(s.realizations[8].value_text, "sand.H = 33");
  const auto row = std::ranges::find(s.sensitivity, "sand.H", &SensitivityRow::parameter);
  EXPECT_EQ(row->si, (1500.0 - 900.0) / 1500.0);
  EXPECT_TRUE(std::isnan(row->si_noise));
  EXPECT_EQ(row->note, "noise undefined: only the average of the baseline was imported");
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_EQ(remarks[1], "5 realizations of the study without a row: pending");
}

TEST_F(ImportSamples, ClaimNoSettingsAndNoSolver) {
  const Snapshot s = import({sample("y", {change("sand.H", 25)}, 1000.0)});
  for (const RealizationRow& run : s.realizations) {
    EXPECT_EQ(run.settings_hash, "");
    EXPECT_EQ(run.solver_version, "");
  }
  EXPECT_EQ(s.campaign.solver_version, "");
  ASSERT_EQ(s.imports.size(), 1U);
  EXPECT_EQ(s.imports[0].file, "other.csv");
  study.database = target;
  EXPECT_THROW(open(study), Error);
}

TEST_F(ImportSamples, ASecondOfEqualInputsIsAPointAndFailuresStay) {
  Sample broken = sample("broken", {change("sand.H", 75)}, nan);
  broken.status = "crashed";
  broken.reason = "no licence";
  const Snapshot s = import(
      {sample("y", {change("sand.H", 25)}, 1000.0), sample("again", {change("sand.H", 25)}, 1001.0), broken});
  EXPECT_EQ(s.realizations[2].status, "crashed");
  EXPECT_EQ(s.realizations[2].reason, "no licence");
  EXPECT_EQ(s.realizations[8].parameter, "again");
  EXPECT_EQ(s.realizations[8].value_text, "");
  EXPECT_EQ(std::get<double>(samples_table(s).rows[8][4]), 25.0);
}

// Last digits of another program are no result.
TEST_F(ImportSamples, ResultsThatDoNotVaryAreUndefined) {
  std::vector<Sample> samples = {sample("y", {change("sand.H", 25)}, 815.15)};
  for (const double H : {20.0, 75.0})
    samples.push_back(sample("h", {change("sand.H", H)}, 815.15 + 1e-12 * H));
  const Snapshot s = import(samples);
  const auto row = std::ranges::find(s.sensitivity, "sand.H", &SensitivityRow::parameter);
  EXPECT_TRUE(std::isnan(row->si));
  EXPECT_EQ(row->note, "undefined: the result does not vary");
}

// A straight line from another program, whose inputs are a number, a whole number and a choice: the effects
// are its rises over the whole ranges, for any grid.
TEST_F(ImportSamples, AStraightLineHasItsEffects) {
  for (const int levels : {4, 20}) {
    const std::string text = fmt::format(
        "profile = \"homogeneous_sand\"\npreset = \"quick\"\n[parameters]\n"
        "sand.nu = {{ baseline = 0.2, lower = 0.1, upper = 0.3 }}\n"
        "numerics.face_elements = {{ baseline = 2, lower = 1, upper = 4 }}\n"
        "chamber.wall = {{ baseline = \"rigid\", alternative = \"flexible\" }}\n"
        "[[windows]]\nname = \"deep\"\nfrom_m = 0.40\nto_m = 0.50\n"
        "[design]\nkind = \"morris\"\nlevels = {}\n",
        levels);
    const auto made = std::get<parameters::Study>(parameters::parse_study(text, folder / "line.toml"));
    std::vector<Sample> samples;
    for (const parameters::Realization& r : parameters::all_realizations(made)) {
      const solver::Setup setup = make_setup(made, r);
      samples.push_back(sample(fmt::format("run {}", r.id), {},
                               2000.0 + 240.0 * solver::sand_of(setup).nu +
                                   30.0 * setup.numerics.face_elements +
                                   (setup.chamber.wall == solver::Wall::rigid ? 0.0 : 50.0)));
      for (const parameters::Row& row : made.rows)
        samples.back().changes.push_back({row.quantity, row.quantity->value(setup)});
    }
    std::filesystem::remove(target);
    import_samples(made, text, samples, {"line.csv", std::string(64, 'b')}, target);
    const std::map<std::string, double> rises = {
        {"sand.nu", 48.0}, {"numerics.face_elements", 90.0}, {"chamber.wall", 50.0}};
    int checked = 0;
    for (const EffectRow& row : design_effects(read_snapshot(target)).rows) {
      const double exact = row.quantity == "sigma" ? 0.0 : rises.at(row.parameter);
      EXPECT_NEAR(row.quantity == "mu" ? std::abs(row.value) : row.value, exact, 1e-8)
          << levels << ' ' << row.quantity << ' ' << row.parameter;
      EXPECT_EQ(row.dropped, 0);
      ++checked;
    }
    EXPECT_EQ(checked, 9);
  }
}

// The table of a campaign, read as another program's, says the same of the campaign.
TEST_F(ImportSamples, ACampaignsOwnSamplesGiveItsIndices) {
  study.points = {{"repeat 1", {{solver::find_quantity("numerics.point_shift"), 0.25}}, true},
                  {"repeat 2", {{solver::find_quantity("numerics.point_shift"), -0.25}}, true}};
  {
    Ledger ledger = open(study);
    for (const int id : ledger.pending())
      ledger.record(id,
                    id == 4 ? failed(solver::Status::crashed, "signal 11") : completed(1e6 / 3 + id * id));
  }
  const Snapshot own = read_snapshot(study.database);
  const Table table = samples_table(own);
  FieldTable fields{"samples.csv", "samples", {}, {}};
  for (const std::string& column : table.columns) fields.names.push_back({column, {}});
  for (const auto& row : table.rows) {
    auto& texts = fields.rows.emplace_back();
    for (const Cell& cell : row) {
      std::string text = format({{"x"}, {{cell}}}, Format::csv).substr(2);
      text.pop_back();
      texts.push_back({text, {}});
    }
  }
  const auto read = read_samples(fields, study, {});
  ASSERT_EQ(read.index(), 0U) << parameters::format(std::get<1>(read));
  const Snapshot s = import(std::get<0>(read));
  EXPECT_EQ(remarks, Remarks());
  ASSERT_EQ(s.sensitivity.size(), own.sensitivity.size());
  for (std::size_t i = 0; i < s.sensitivity.size(); ++i) {
    EXPECT_EQ(s.sensitivity[i].note, own.sensitivity[i].note);
    EXPECT_EQ(s.sensitivity[i].si_noise, own.sensitivity[i].si_noise);
    for (const auto member : {&SensitivityRow::si, &SensitivityRow::si_half_width}) {
      const double here = s.sensitivity[i].*member, there = own.sensitivity[i].*member;
      EXPECT_TRUE(here == there || (std::isnan(here) && std::isnan(there))) << here << ' ' << there;
    }
  }
  EXPECT_EQ(s.realizations.back().side, "repeat");
  EXPECT_EQ(format(samples_table(s), Format::csv), format(table, Format::csv));
}

}  // namespace
}  // namespace cpt::results

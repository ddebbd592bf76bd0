// Every channel of a push comes through the ledger: curve, averages, export, HDF5; and every input can be
// asked in SQL.
#include "solver/channels.hpp"

#include <algorithm>

#include "results/files/database.hpp"
#include "results/ledger/curve_store.hpp"
#include "results/tables/campaign_tables.hpp"
#include "results/tables/query.hpp"
#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

class Channels : public ScratchFolder {
 protected:
  Channels() : study(sand_study(folder)) {
    Ledger ledger = open(study);
    solver::Outcome outcome = completed(2e6);
    for (const solver::Channel& channel : solver::channels()) {
      std::vector<double>& values = outcome.profile.*channel.values;
      values = outcome.profile.q_c;
      for (double& value : values) value /= 1.0 + static_cast<double>(&channel - solver::channels().data());
    }
    sent = outcome.profile;
    ledger.record(1, outcome);
    ledger.record(2, completed(1e6));  // as a program without further channels would
  }
  parameters::Study study;
  solver::DepthProfile sent;
};

TEST_F(Channels, AreStoredToTheBit) {
  const solver::DepthProfile stored = read_run(study.database, 1)->profile.value();
  for (const solver::Channel& channel : solver::channels())
    EXPECT_EQ(stored.*channel.values, sent.*channel.values) << channel.name;
  const solver::DepthProfile earlier = read_run(study.database, 2)->profile.value();
  for (const solver::Channel& channel : solver::channels())
    EXPECT_EQ((earlier.*channel.values).empty(), !channel.required) << channel.name;
}

TEST_F(Channels, AreAveragedInEachWindow) {
  const Table windows = query(study.database, "windows");
  const auto cell = [&](std::size_t row, const std::string& name) {
    const auto column = std::ranges::find(windows.columns, name) - windows.columns.begin();
    return windows.rows[row].at(static_cast<std::size_t>(column));
  };
  const double q_c = std::get<double>(cell(0, "q_c_mean_kPa"));
  EXPECT_NEAR(std::get<double>(cell(0, "f_s_mean_kPa")), q_c / 2.0, 1e-9 * q_c);
  EXPECT_NEAR(std::get<double>(cell(0, "wall_stress_mean_kPa")), q_c / 3.0, 1e-9 * q_c);
  EXPECT_EQ(cell(1, "wall_stress_mean_kPa").index(), 0U) << "was not recorded";
}

TEST_F(Channels, AreExportedAndMirrored) {
  (void)sync_curves(study.curves, study.database);
  const StoredCurve curve = read_curves(study.curves).front();
  EXPECT_EQ(curve.channels_kPa.size(), solver::channels().size());
  EXPECT_EQ(read_curves(study.curves)[1].channels_kPa.size(), 2U);
  const std::vector<NamedTable> tables = campaign_tables(study.database);
  const auto curves = std::ranges::find(tables, "curve", &NamedTable::name);
  ASSERT_NE(curves, tables.end());
  EXPECT_EQ(curves->table.columns,
            (std::vector<std::string>{"realization", "depth_m", "q_c_Pa", "f_s_Pa", "wall_stress_Pa"}));
}

TEST_F(Channels, AChangedBitOfAnyIsFound) {
  Database(study.database, Database::Mode::read_write)
      .execute("UPDATE curve SET wall_stress_Pa = q_c_Pa WHERE realization = 1");
  EXPECT_EQ(open(study).opened().damaged, 1);
}

TEST_F(Channels, InputsCanBeAskedInSql) {
  const Table inputs = query_sql(study.database,
                                 "SELECT realization, value FROM realization_input WHERE quantity = 'sand.H' "
                                 "ORDER BY realization LIMIT 4");
  const std::vector<double> wanted = {25, 20, 75, 25};  // baseline, its bounds, another's bound
  ASSERT_EQ(inputs.rows.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_EQ(std::get<double>(inputs.rows[k][1]), wanted[k]);
  const Table wall = query_sql(study.database,
                               "SELECT DISTINCT value_text FROM realization_input WHERE quantity = "
                               "'chamber.wall' ORDER BY 1");
  EXPECT_EQ(wall.rows.size(), 2U);
}

}  // namespace
}  // namespace cpt::results

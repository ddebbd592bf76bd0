// A campaign as one flat table, and in Dakota's format.
#include "results/tables/samples.hpp"

#include <charconv>
#include <sstream>

#include "tests/results/campaign_fixture.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::results {
namespace {

class Samples : public ScratchFolder {
 protected:
  Samples() {
    study.points = {
        {"both", {{solver::find_quantity("sand.H"), 75}, {solver::find_quantity("sand.nu"), 0.25}}},
        {"repeat 1", {{solver::find_quantity("numerics.point_shift"), 0.25}}, true}};
    Ledger ledger = open(study);
    for (const int id : ledger.pending())
      if (id == 4)
        ledger.record(id, failed(solver::Status::crashed, "signal 11, \"why\""));
      else if (id != 5)
        ledger.record(id, completed(1e6 / 3 + id));
  }
  parameters::Study study = sand_study(folder);
};

Cell cell(const Table& table, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i] == column) return table.rows.at(row).at(i);
  ADD_FAILURE() << column;
  return {};
}

TEST_F(Samples, EveryRealizationHasAllInputsThatVary) {
  const Table table = samples_table(read_snapshot(study.database));
  ASSERT_EQ(table.rows.size(), 10U);
  const std::vector<std::string> columns = {"realization",
                                            "name",
                                            "status",
                                            "reason",
                                            "sand.H",
                                            "sand.N",
                                            "chamber.radius_m",
                                            "chamber.wall",
                                            "initial.sigma_h0_kPa",
                                            "numerics.point_shift",
                                            "sand.nu",
                                            "deep.q_c_mean_kPa",
                                            "deep.q_c_min_kPa",
                                            "deep.q_c_max_kPa",
                                            "peak.q_c_mean_kPa",
                                            "peak.q_c_min_kPa",
                                            "peak.q_c_max_kPa"};
  EXPECT_EQ(table.columns, columns);
  EXPECT_EQ(cell(table, 0, "name"), Cell("baseline"));
  EXPECT_EQ(cell(table, 0, "sand.H"), Cell(25.0));
  EXPECT_EQ(cell(table, 0, "chamber.wall"), Cell("rigid"));
  EXPECT_EQ(cell(table, 2, "name"), Cell("sand.H upper"));
  EXPECT_EQ(cell(table, 2, "sand.H"), Cell(75.0));
  EXPECT_EQ(cell(table, 2, "sand.nu"), Cell(solver::sand_of(study.baseline).nu));
  EXPECT_EQ(cell(table, 8, "name"), Cell("both"));
  EXPECT_EQ(cell(table, 8, "sand.nu"), Cell(0.25));
  EXPECT_EQ(cell(table, 9, "numerics.point_shift"), Cell(0.25));
  EXPECT_EQ(cell(table, 0, "numerics.point_shift"), Cell(study.baseline.numerics.point_shift));
}

TEST_F(Samples, WhatFailedOrWaitsHasNoNumbersButARow) {
  const Table table = samples_table(read_snapshot(study.database));
  EXPECT_EQ(cell(table, 3, "status"), Cell("crashed"));
  EXPECT_EQ(cell(table, 3, "reason"), Cell("signal 11, \"why\""));
  EXPECT_EQ(cell(table, 4, "status"), Cell("pending"));
  for (const std::size_t row : {3U, 4U})
    EXPECT_EQ(cell(table, row, "deep.q_c_mean_kPa"), Cell(std::monostate{}));
}

TEST_F(Samples, DakotaHasWordsOnlyAndNaNForWhatFailed) {
  const Snapshot s = read_snapshot(study.database);
  std::istringstream lines(dakota_table(s));
  std::string line, word;
  std::vector<std::vector<std::string>> words;
  while (std::getline(lines, line)) {
    std::istringstream in(line);
    words.emplace_back();
    while (in >> word) words.back().push_back(word);
  }
  ASSERT_EQ(words.size(), 10U);  // a header and all but the pending one
  EXPECT_EQ(words[0],
            (std::vector<std::string>{"%eval_id", "interface", "sand.H", "sand.N", "chamber.radius_m",
                                      "chamber.wall", "initial.sigma_h0_kPa", "numerics.point_shift",
                                      "sand.nu", "deep.q_c_mean_kPa", "peak.q_c_mean_kPa"}));
  for (const auto& row : words) EXPECT_EQ(row.size(), words[0].size());
  EXPECT_EQ(words[1][1], "NO_ID");
  EXPECT_EQ(words[4][0], "4");
  EXPECT_EQ(words[4][9], "NaN");
  EXPECT_EQ(words[5][0], "6");
  double read = 0.0;
  std::from_chars(words[1][9].data(), words[1][9].data() + words[1][9].size(), read);
  EXPECT_EQ(read, s.window_means[0].q_c_mean_kPa);  // to the last bit
}

}  // namespace
}  // namespace cpt::results

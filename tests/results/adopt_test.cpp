// A ledger takes over what another campaign has finished with equal settings.
#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

using Adopt = ScratchFolder;

TEST_F(Adopt, TakesEqualSettingsAndNothingElse) {
  parameters::Study first = sand_study(folder);
  {
    Ledger ledger = open(first);
    for (const int id : ledger.pending()) {
      ledger.mark_running(id);
      ledger.record(id, id == 3 ? failed(solver::Status::did_not_converge, "broke") : completed(1e6 + id));
    }
  }
  parameters::Study second = first;
  second.name = "more";
  second.database = folder / "more.sqlite";
  second.rows.pop_back();
  second.points = {{"both", {{solver::find_quantity("sand.H"), 75}, {solver::find_quantity("sand.N"), 0.2}}}};
  Ledger ledger = open(second);
  const int pending = ledger.counts().pending;
  EXPECT_EQ(ledger.adopt(folder / "nothing.sqlite"), 0);
  EXPECT_EQ(ledger.adopt(first.database), pending - 2);  // but the failed one and the point
  EXPECT_EQ(ledger.counts().pending, 2);
  const Snapshot from = read_snapshot(first.database), to = read_snapshot(second.database);
  EXPECT_EQ(from.curves.front().profile.q_c, to.curves.front().profile.q_c);
  EXPECT_EQ(from.realizations.front().audit.energy_error, to.realizations.front().audit.energy_error);
  EXPECT_EQ(to.realizations.back().side, "point");
  EXPECT_EQ(to.realizations.back().value_text, "sand.H = 75, sand.N = 0.2");
  EXPECT_EQ(ledger.adopt(first.database), 0);
}

}  // namespace
}  // namespace cpt::results

// Tables of a campaign whose solver is an external program: the ledger's columns are named after q_c, theirs
// after what they hold.
#pragma once

#include "results/files/database.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::results {

/// "q_c_mean_kPa" becomes "mean", and so on, columns of a push go (other channels, its audit), and
/// "output_unit" stands behind "window". Leaves the table of an embedded solver's campaign as it is.
[[nodiscard]] Table named_for_outputs(Table table, const Database& database);
[[nodiscard]] Table named_for_outputs(Table table, const Snapshot& campaign);

}  // namespace cpt::results

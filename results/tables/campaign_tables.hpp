// A campaign's database as plain tables, for other programs.
#pragma once

#include <filesystem>
#include <vector>

#include "results/tables/table_format.hpp"

namespace cpt::results {

class Database;
struct Snapshot;

/// All tables of the ledger (ledger_tables.hpp) but those of unused runs; `curve` has one row a depth bin:
/// realization, depth_m and the channels, or those of output_rows(). Then what follows from them: samples
/// (samples.hpp), audit, sensitivity, tornado and effects. Read in one transaction; throws Error as
/// read_snapshot.
[[nodiscard]] std::vector<NamedTable> campaign_tables(const std::filesystem::path& database);
[[nodiscard]] std::vector<NamedTable> campaign_tables(const Database& database);

/// What an external program gave: realization, output, x and y, a row a number; a scalar has no x.
[[nodiscard]] Table output_rows(const Snapshot& campaign);

}  // namespace cpt::results

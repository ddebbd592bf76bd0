// A campaign's database as plain tables, for other programs.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/tables/table_format.hpp"

namespace cpt::results {

class Database;

/// A table of the ledger, and its columns as they are exported and imported.
struct LedgerTable {
  struct Column {
    std::string name, type;  ///< type: TEXT, INTEGER or REAL
    bool required;           ///< never NULL
  };
  std::string name;
  std::string order;  ///< of its rows, as SQL
  std::vector<Column> columns;
};

/// The ledger's tables as docs/schema.md has them, each behind those that it refers to: campaign, layer,
/// parameter, depth_window, realization, curve, window_mean, repeat_noise, checksum, import. `curve` is not
/// as it is stored but has one row a depth bin: realization, depth_m, q_c_Pa, f_s_Pa.
[[nodiscard]] const std::vector<LedgerTable>& ledger_tables();

/// Tables of an export that follow from the others, beside which they are not read: samples (samples.hpp),
/// audit, sensitivity, tornado and effects.
[[nodiscard]] std::span<const std::string_view> derived_tables();

/// All that a database holds, in the order of ledger_tables(); then the derived ones. Read in one
/// transaction; throws Error as read_snapshot.
[[nodiscard]] std::vector<NamedTable> campaign_tables(const std::filesystem::path& database);
[[nodiscard]] std::vector<NamedTable> campaign_tables(const Database& database);

}  // namespace cpt::results

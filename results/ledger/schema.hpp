// The ledger's tables and views in a database: made, upgraded, read as they are now.
#pragma once

#include <string_view>

#include "results/files/database.hpp"

namespace cpt::results {

/// Raised whenever a table or view changes in a way that a reader would notice.
inline constexpr int schema_version = 10;
/// The oldest that is still read; a campaign that goes on brings it to the present version.
inline constexpr int oldest_schema_version = 1;

/// Creates all tables and views in an empty database.
void create_schema(const Database& database);

/// Brings an older ledger to this version, all that it holds kept. Within a transaction of the caller.
void upgrade_schema(const Database& database);

/// Makes the views anew where their definitions are not this program's: they are not data, but a bit that
/// flips in one would change what is read.
void mend_views(const Database& database);

/// A ledger for reading alone, checked. Its views are this program's, whatever stands in the file, which may
/// have been finished by an earlier program.
[[nodiscard]] Database open_ledger(const std::filesystem::path& file);
/// Lets an older ledger that is only read look like one of this version: tables and columns that it lacks are
/// empty, in this connection alone.
void show_as_present(const Database& database);
/// Whether the file has such a table; earlier schema versions lack some.
[[nodiscard]] bool has_table(const Database& database, std::string_view table);

/// True if the database holds nothing at all.
[[nodiscard]] bool is_empty(const Database& database);

/// Throws Error unless the database is a campaign's ledger of this schema version.
void check_schema(const Database& database);

}  // namespace cpt::results

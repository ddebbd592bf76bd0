// Questions to a campaign's database, answered as plain tables; nothing here can change the database.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "results/files/error.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::results {

class Database;

/// What was asked of a database is no question that it can answer.
struct BadQuery : Error {
  using Error::Error;
};

/// A named question and what it answers, for --help.
struct NamedQuery {
  std::string_view name;
  std::string_view meaning;
};
/// realizations, windows, sensitivity, tornado, failures, unused, effects.
[[nodiscard]] std::span<const NamedQuery> named_queries();

/// Answers a named query; throws BadQuery for an unknown name, Error for an unusable database.
[[nodiscard]] Table query(const std::filesystem::path& database, std::string_view name);

/// Runs one read-only SQL statement. Throws BadQuery if it is wrong or would write: "sql:1:8: " with SQLite's
/// message and, for a table or column, the nearest that there is.
[[nodiscard]] Table query_sql(const std::filesystem::path& database, std::string_view sql);

/// The same of a ledger that is open.
[[nodiscard]] Table query(const Database& database, std::string_view name);
[[nodiscard]] Table query_sql(const Database& database, std::string_view sql);

}  // namespace cpt::results

// Questions to a campaign's database, answered as plain tables; nothing here can change the database.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "results/error.hpp"
#include "results/table_format.hpp"

namespace cpt::results {

/// A named question and what it answers, for --help.
struct NamedQuery {
  std::string_view name;
  std::string_view meaning;
};
/// realizations, windows, sensitivity, tornado, failures, effects.
[[nodiscard]] std::span<const NamedQuery> named_queries();

/// Answers a named query; throws Error for an unknown name or an unusable database.
[[nodiscard]] Table query(const std::filesystem::path& database, std::string_view name);

/// Runs one read-only SQL statement; throws Error with SQLite's message if it is wrong or would write.
[[nodiscard]] Table query_sql(const std::filesystem::path& database, std::string_view sql);

}  // namespace cpt::results

#include "results/ledger_watch.hpp"

#include <utility>

#include "results/schema.hpp"

namespace cpt::results {

LedgerWatch::LedgerWatch(const std::filesystem::path& file) : database_(file, Database::Mode::read_only) {
  check_schema(database_);
}

bool LedgerWatch::changed() {
  // SQLite changes this number for a connection whenever another one commits.
  const std::int64_t before = std::exchange(version_, database_.integer("PRAGMA data_version"));
  return before != version_;
}

}  // namespace cpt::results

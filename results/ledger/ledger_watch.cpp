#include "results/ledger/ledger_watch.hpp"

#include <utility>

#include "results/files/file_lock.hpp"
#include "results/ledger/schema.hpp"

namespace cpt::results {

LedgerWatch::LedgerWatch(const std::filesystem::path& file)
    : database_(file, Database::Mode::read_only), lock_(file.string() + ".lock") {
  check_schema(database_);
}

bool LedgerWatch::changed() {
  // SQLite changes this number for a connection whenever another one commits.
  const std::int64_t before = std::exchange(version_, database_.integer("PRAGMA data_version"));
  const bool was_held = std::exchange(held_, is_held(lock_));  // a killed campaign commits nothing any more
  return before != version_ || was_held != held_;
}

}  // namespace cpt::results

// Ledgers that are whole as files but hold what no campaign wrote. The input is SQL that is run on a sound
// one.
#include <fstream>

#include "results/files/database.hpp"
#include "tests/fuzz/targets/use_ledger.hpp"

namespace cpt::fuzz {

Fate stored_values(std::string_view edits) {
  const std::string& sound = sound_ledger();
  const std::filesystem::path file = scratch("fuzzed.sqlite");
  std::ofstream(file, std::ios::binary) << sound;
  bool edited = true;
  try {
    const results::Database database(file, results::Database::Mode::read_write);
    database.execute(
        "PRAGMA ignore_check_constraints = ON; PRAGMA foreign_keys = OFF; PRAGMA synchronous = OFF");
    database.execute(edits);
  } catch (const results::Error&) {
    edited = false;  // no SQL from here on
  }
  const Fate fate = use_ledger(file);
  return edited ? fate : Fate::refused;
}

}  // namespace cpt::fuzz

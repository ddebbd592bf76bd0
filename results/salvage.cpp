#include "results/salvage.hpp"

#include <optional>
#include <system_error>
#include <utility>

#include "results/database.hpp"
#include "results/ledger_rows.hpp"
#include "results/refusal.hpp"

namespace cpt::results {

std::vector<StoredRun> salvage_runs(const std::filesystem::path& damaged, int largest_id) {
  std::vector<StoredRun> runs;
  std::optional<Database> database;
  try {
    database.emplace(damaged, Database::Mode::salvage);
  } catch (const Error&) {
    return runs;
  }
  try {
    if (database->integer("SELECT count(*) FROM import") > 0) return runs;  // not this program's
  } catch (const Error&) {
  }
  // One by one: a scan would end at the first page that is broken.
  for (int id = 1; id <= largest_id; ++id) try {
      if (matches_checksum(*database, id) != std::optional(true)) continue;
      std::optional<StoredRun> run = read_run(*database, id);
      if (run && run->row.completed() && run->profile) runs.push_back(*std::move(run));
    } catch (const Error&) {
    }
  return runs;
}

std::filesystem::path set_aside(const std::filesystem::path& database) {
  const std::filesystem::path aside = database.string() + ".damaged";
  for (const char* part : {"-wal", "-shm", ""}) {
    const std::string from = database.string() + part, to = aside.string() + part;
    std::error_code problem;
    std::filesystem::remove(to, problem);
    if (!std::filesystem::exists(from, problem)) continue;
    std::filesystem::rename(from, to, problem);
    if (problem) throw Error(refusal(from, "cannot be moved aside", problem));
  }
  return aside;
}

}  // namespace cpt::results

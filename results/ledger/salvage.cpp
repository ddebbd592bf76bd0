#include "results/ledger/salvage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

#include "results/files/database.hpp"
#include "results/files/refusal.hpp"
#include "results/ledger/ledger_rows.hpp"
#include "results/ledger/schema.hpp"

namespace cpt::results {

namespace {

// Ids to try: those that are told, where that is no nonsense.
std::int64_t last_id_to_try(const Database& database, const RunTables& tables, std::int64_t unless_told) {
  constexpr std::int64_t most = 200'000;
  try {
    return std::min(database.integer(fmt::format("SELECT max(id) FROM {}", tables.run)), most);
  } catch (const Error&) {
    return unless_told;
  }
}

void read_study(const Database& database, CampaignRow& study) try {
  Statement row = database.prepare("SELECT name, study_text, baseline_setup, program_version FROM campaign");
  if (!row.step()) return;
  study.name = row.text(0);
  study.study_text = row.text(1);
  study.baseline_setup = row.text(2);
  study.program_version = row.text(3);
} catch (const Error&) {
}

}  // namespace

Salvage salvage(const std::filesystem::path& damaged, int largest_id_unless_told) {
  Salvage found;
  std::optional<Database> database;
  try {
    database.emplace(damaged, Database::Mode::salvage);
  } catch (const Error&) {
    return found;
  }
  try {
    show_as_present(*database);
  } catch (const Error&) {
  }
  try {
    if (database->integer("SELECT count(*) FROM import") > 0) return found;  // not this program's
  } catch (const Error&) {
  }
  read_study(*database, found.study);
  // One by one: a scan would end at the first page that is broken.
  for (const RunTables& tables : {in_use_tables, unused_tables})
    for (std::int64_t id = 1, last = last_id_to_try(*database, tables, largest_id_unless_told); id <= last;
         ++id)
      try {
        if (matches_checksum(*database, id, tables) != std::optional(true)) continue;
        std::optional<StoredRun> run = read_run(*database, static_cast<int>(id), tables);
        const bool ended = run && run->row.ended() && run->row.status != "rank_lost";
        if (ended && (!run->row.completed() || run->profile)) found.runs.push_back(*std::move(run));
      } catch (const Error&) {
      }
  return found;
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

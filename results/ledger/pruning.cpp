#include "results/ledger/pruning.hpp"

#include <fmt/format.h>

#include "results/ledger/schema.hpp"
#include "results/ledger/setup_text.hpp"
#include "results/ledger/unused_rows.hpp"

namespace cpt::results {
namespace {

/// Before a lock file is made beside it.
const std::filesystem::path& existing_ledger(const std::filesystem::path& file) {
  check_schema(Database(file, Database::Mode::read_only));
  return file;
}

}  // namespace

std::vector<UnusedRun> unused_runs(const Database& database) {
  std::vector<UnusedRun> runs;
  if (!has_table(database, unused_tables.run)) return runs;
  Statement rows = database.prepare(
      "SELECT id, parameter, side, value_text, status, settings_hash, solver_version, finished, study FROM "
      "unused ORDER BY id");
  while (rows.step())
    runs.push_back({rows.integer(0), rows.text(1), rows.text(2), rows.text(3), rows.text(4), rows.text(5),
                    rows.text(6), rows.text(7), rows.integer(8)});
  return runs;
}

std::vector<std::string> former_settings(const Database& database, std::int64_t study) {
  std::vector<std::string> settings;
  Statement row = database.prepare(
      "SELECT f.baseline_setup, c.baseline_setup FROM former_study AS f, campaign AS c WHERE "
      "f.id = ?");
  row.bind(study);
  if (!row.step()) return settings;
  const auto then = setup_by_name(row.text(0)), now = setup_by_name(row.text(1));
  const auto of = [](const auto& setup, const std::string& name) {
    const auto found = setup.find(name);
    return found == setup.end() ? std::string("not set") : found->second;
  };
  auto names = then;
  names.insert(now.begin(), now.end());
  for (const auto& [name, ignored] : names)
    if (of(then, name) != of(now, name))
      settings.push_back(fmt::format("{} = {} (now {})", name, of(then, name), of(now, name)));
  return settings;
}

Pruning::Pruning(const std::filesystem::path& database)
    : lock_(existing_ledger(database).string() + ".lock"), database_(database, Database::Mode::read_write) {}

void Pruning::remove(std::span<const UnusedRun> runs) {
  Transaction transaction(database_, Transaction::Kind::write);
  for (const UnusedRun& run : runs)
    database_.prepare("DELETE FROM unused WHERE id = ?").bind(run.id).run();  // and its curve with it
  forget_former_studies(database_);
  transaction.commit();
}

std::int64_t Pruning::shrink() {
  const auto size = [&] {
    return database_.integer("SELECT page_count * page_size FROM pragma_page_count, pragma_page_size");
  };
  const std::int64_t before = size();
  database_.execute("VACUUM");
  return before - size();
}

}  // namespace cpt::results

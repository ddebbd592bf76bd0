#include "results/ledger/unused_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "results/ledger/ledger_tables.hpp"
#include "results/ledger/schema.hpp"

namespace cpt::results {
namespace {

/// Adds a run as it was stored elsewhere under its row's id.
void insert_run(const Database& database, const StoredRun& run, const RunTables& tables) {
  insert_row(database, run_table(tables), run.row);
  if (run.profile) insert_row(database, curve_table(tables), {run.row.id, *run.profile});
  database.prepare(fmt::format("INSERT INTO {} VALUES (?, ?)", tables.checksum))
      .bind(run.row.id)
      .bind(outcome_checksum(database, run.row.id, tables))
      .run();
}

/// Columns but the first, which says whose they are.
template <class Row>
std::string columns_behind(const RowTable<Row>& table) {
  const std::string names = names_of(table.columns);
  return names.substr(names.find(", ") + 2);
}

/// The row of the study as it is stored now, among those whose results are unused; made where there is none.
std::int64_t former_study(const Database& database) {
  constexpr const char* columns = "name, study_text, baseline_setup, program_version";
  const auto find = [&] {
    Statement same = database.prepare(fmt::format(
        "SELECT f.id FROM former_study AS f JOIN (SELECT {} FROM campaign) USING ({})", columns, columns));
    return same.step() ? std::optional(same.integer(0)) : std::nullopt;
  };
  std::optional<std::int64_t> known = find();
  if (!known) {
    database.execute(fmt::format("INSERT INTO former_study ({}) SELECT {} FROM campaign", columns, columns));
    known = find();
  }
  if (!known) fail_damaged(database.file(), "the ledger names no campaign");
  return *known;
}

std::int64_t last_unused(const Database& database) {
  return database.integer("SELECT coalesce(max(id), 0) FROM unused");
}

}  // namespace

void replace_run(const Database& database, int id, const StoredRun& run) {
  Statement row = database.prepare("SELECT parameter, side, value, value_text FROM realization WHERE id = ?");
  row.bind(id);
  if (!row.step()) throw std::logic_error(fmt::format("the ledger has no realization {}", id));
  StoredRun mine = run;
  mine.row.id = id;
  mine.row.parameter = row.text(0);
  mine.row.side = row.text(1);
  mine.row.value = row.number(2);
  mine.row.value_text = row.text(3);
  database.prepare("DELETE FROM realization WHERE id = ?").bind(id).run();
  insert_run(database, mine, in_use_tables);
}

int keep_salvaged(const Database& database, const Salvage& salvaged) {
  std::set<std::string> known;
  Statement asked = database.prepare("SELECT settings_hash FROM realization");
  while (asked.step()) known.insert(asked.text(0));
  std::int64_t study = 0, id = last_unused(database);
  int kept = 0;
  for (StoredRun run : salvaged.runs) {
    if (!known.insert(run.row.settings_hash).second) continue;
    if (study == 0) {
      database
          .prepare(
              "INSERT INTO former_study (name, study_text, baseline_setup, program_version) VALUES (?, ?, ?, "
              "?)")
          .bind(salvaged.study.name)
          .bind(salvaged.study.study_text)
          .bind(salvaged.study.baseline_setup)
          .bind(salvaged.study.program_version)
          .run();
      study = database.integer("SELECT max(id) FROM former_study");
    }
    run.row.id = static_cast<int>(++id);
    run.row.former_study = study;
    try {
      insert_run(database, run, unused_tables);
      ++kept;
    } catch (const ConstraintViolation&) {
      // What it changed is not covered by its checksum, and is no longer readable.
    }
  }
  return kept;
}

std::vector<StoredRun> completed_runs(const std::filesystem::path& other) {
  const Database database(other, Database::Mode::read_only);
  check_schema(database);
  show_as_present(database);
  const Transaction transaction(database, Transaction::Kind::read);
  std::vector<StoredRun> runs;
  // Tables alone: the views of an earlier program may lack what this one reads of them.
  if (has_table(database, "import") && database.integer("SELECT count(*) FROM import") > 0) return runs;
  for (const RunTables& tables : {in_use_tables, unused_tables}) {
    if (!has_table(database, tables.run)) continue;
    Statement ids =
        database.prepare(fmt::format("SELECT id FROM {} WHERE status = 'completed' ORDER BY id", tables.run));
    while (ids.step()) {
      const auto id = static_cast<int>(ids.integer(0));
      if (has_table(database, tables.checksum) &&
          matches_checksum(database, id, tables) == std::optional(false))
        continue;
      std::optional<StoredRun> run = read_run(database, id, tables);
      if (run && run->profile) runs.push_back(*std::move(run));
    }
  }
  return runs;
}

void keep_unused(const Database& database) {
  if (!database.prepare("SELECT 1 FROM realization WHERE id < 0").step()) return;
  const std::int64_t study = former_study(database), last = last_unused(database);
  database
      .prepare(fmt::format("INSERT INTO unused (id, {0}, study) SELECT ? - id, {0}, ? FROM realization WHERE "
                           "id < 0 ORDER BY id DESC",
                           columns_behind(run_table(in_use_tables))))
      .bind(last)
      .bind(study)
      .run();
  for (const auto& [from, to, columns] :
       {std::tuple{in_use_tables.curve, unused_tables.curve, columns_behind(curve_table(in_use_tables))},
        {in_use_tables.checksum, unused_tables.checksum, "sha256"}})
    database
        .prepare(fmt::format(
            "INSERT INTO {0} (realization, {1}) SELECT ? - realization, {1} FROM {2} WHERE realization < 0 "
            "ORDER BY realization DESC",
            to, columns, from))
        .bind(last)
        .run();
  database.execute("DELETE FROM realization WHERE id < 0");
}

void forget_former_studies(const Database& database) {
  database.execute("DELETE FROM former_study WHERE id NOT IN (SELECT study FROM unused)");
}

void use_again(const Database& database, std::int64_t unused_id, int id, const RealizationInput& input) {
  database
      .prepare(fmt::format("INSERT INTO realization (id, {0}) SELECT ?, {0} FROM unused WHERE id = ?",
                           columns_behind(run_table(in_use_tables))))
      .bind(id)
      .bind(unused_id)
      .run();
  for (const auto& [from, to, columns] :
       {std::tuple{unused_tables.curve, in_use_tables.curve, columns_behind(curve_table(in_use_tables))},
        {unused_tables.checksum, in_use_tables.checksum, "sha256"}})
    database
        .prepare(
            fmt::format("INSERT INTO {0} (realization, {1}) SELECT ?, {1} FROM {2} WHERE realization = ?", to,
                        columns, from))
        .bind(id)
        .bind(unused_id)
        .run();
  database.prepare("DELETE FROM unused WHERE id = ?").bind(unused_id).run();
  rename_realization(database, id, id, input);
}

}  // namespace cpt::results

#include "results/ledger/schema.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "results/ledger/views.hpp"

namespace cpt::results {
namespace {

constexpr std::int64_t application_id = 0x43505443;  // "CPTC"

// Of `realization`, and of those that the study no longer asks for.
constexpr const char* run_definitions = R"sql(
  parameter        TEXT,
  side             TEXT NOT NULL CHECK (side IN ('baseline', 'lower', 'upper', 'point', 'repeat')),
  value            REAL,
  value_text       TEXT NOT NULL,
  status           TEXT NOT NULL CHECK (status IN ('pending', 'running', 'completed', 'did_not_converge',
                     'energy_drift', 'time_limit', 'invalid_parameters', 'crashed', 'rank_lost')),
  reason           TEXT NOT NULL DEFAULT '',
  wall_s           REAL,
  steps            INTEGER,
  material_points  INTEGER,
  settings_hash    TEXT NOT NULL,
  solver_version   TEXT NOT NULL,
  started          TEXT,
  finished         TEXT,
  mass_error       REAL,
  momentum_error   REAL,
  energy_error     REAL,
  kinetic_fraction REAL,
  max_empty_cells  INTEGER,
  min_time_step_s  REAL,
  max_time_step_s  REAL)sql";

constexpr const char* table_definitions = R"sql(
CREATE TABLE campaign (
  one              INTEGER PRIMARY KEY CHECK (one = 1),
  name             TEXT NOT NULL,
  title            TEXT NOT NULL,
  profile          TEXT NOT NULL,
  preset           TEXT NOT NULL,
  study_text       TEXT NOT NULL,
  baseline_setup   TEXT NOT NULL,
  program_version  TEXT NOT NULL,
  solver_version   TEXT NOT NULL,
  curve_file       TEXT NOT NULL,
  created          TEXT NOT NULL
);

CREATE TABLE layer (
  position         INTEGER PRIMARY KEY,
  top_m            REAL NOT NULL,
  bottom_m         REAL NOT NULL,
  soil             TEXT NOT NULL
);

CREATE TABLE parameter (
  name             TEXT PRIMARY KEY,
  position         INTEGER NOT NULL UNIQUE,
  symbol           TEXT NOT NULL,
  unit             TEXT NOT NULL,
  meaning          TEXT NOT NULL,
  baseline         REAL NOT NULL,
  lower            REAL NOT NULL,
  upper            REAL NOT NULL,
  baseline_text    TEXT NOT NULL,
  lower_text       TEXT NOT NULL,
  upper_text       TEXT NOT NULL
);

CREATE TABLE realization (
  id               INTEGER PRIMARY KEY,{run_columns}
);
CREATE INDEX realization_of_bound ON realization (parameter, side);

CREATE TABLE curve (
  realization      INTEGER PRIMARY KEY REFERENCES realization (id) ON UPDATE CASCADE ON DELETE CASCADE,
  bins             INTEGER NOT NULL,
  depth_m          BLOB NOT NULL,
  q_c_Pa           BLOB NOT NULL,
  f_s_Pa           BLOB NOT NULL
);

CREATE TABLE depth_window (
  name             TEXT PRIMARY KEY,
  position         INTEGER NOT NULL UNIQUE,
  kind             TEXT NOT NULL CHECK (kind IN ('fixed', 'peak', 'trough')),
  search_from_m    REAL NOT NULL,
  search_to_m      REAL NOT NULL,
  width_m          REAL,
  from_m           REAL,
  to_m             REAL,
  problem          TEXT NOT NULL
);

CREATE TABLE window_mean (
  realization      INTEGER NOT NULL REFERENCES realization (id) ON UPDATE CASCADE ON DELETE CASCADE,
  window           TEXT NOT NULL REFERENCES depth_window (name),
  from_m           REAL NOT NULL,
  to_m             REAL NOT NULL,
  bins             INTEGER,
  q_c_mean_kPa     REAL NOT NULL,
  q_c_min_kPa      REAL,
  q_c_max_kPa      REAL,
  PRIMARY KEY (realization, window)
) WITHOUT ROWID;

CREATE TABLE checksum (
  realization      INTEGER PRIMARY KEY REFERENCES realization (id) ON UPDATE CASCADE ON DELETE CASCADE,
  sha256           TEXT NOT NULL
);

CREATE TABLE repeat_noise (
  window           TEXT PRIMARY KEY REFERENCES depth_window (name),
  runs             INTEGER NOT NULL,
  q_c_mean_kPa     REAL NOT NULL,
  q_c_deviation_kPa REAL NOT NULL,
  si_half_width    REAL NOT NULL
);

CREATE TABLE former_study (
  id               INTEGER PRIMARY KEY,
  name             TEXT NOT NULL,
  study_text       TEXT NOT NULL,
  baseline_setup   TEXT NOT NULL,
  program_version  TEXT NOT NULL
);

CREATE TABLE unused (
  id               INTEGER PRIMARY KEY,{run_columns},
  study            INTEGER NOT NULL REFERENCES former_study (id)
);

CREATE TABLE unused_curve (
  realization      INTEGER PRIMARY KEY REFERENCES unused (id) ON UPDATE CASCADE ON DELETE CASCADE,
  bins             INTEGER NOT NULL,
  depth_m          BLOB NOT NULL,
  q_c_Pa           BLOB NOT NULL,
  f_s_Pa           BLOB NOT NULL
);

CREATE TABLE unused_checksum (
  realization      INTEGER PRIMARY KEY REFERENCES unused (id) ON UPDATE CASCADE ON DELETE CASCADE,
  sha256           TEXT NOT NULL
);

CREATE TABLE import (
  position         INTEGER PRIMARY KEY,
  file             TEXT NOT NULL,
  sha256           TEXT NOT NULL,
  imported         TEXT NOT NULL,
  program_version  TEXT NOT NULL
);
)sql";

// A table after those that refer to it.
constexpr std::array<const char*, 14> table_names = {
    "unused_checksum", "unused_curve", "unused",   "former_study", "checksum",
    "repeat_noise",    "window_mean",  "curve",    "depth_window", "realization",
    "parameter",       "layer",        "campaign", "import"};

}  // namespace

bool has_table(const Database& database, std::string_view table) {
  return database.prepare("SELECT 1 FROM sqlite_schema WHERE type = 'table' AND name = ?").bind(table).step();
}

void create_schema(const Database& database) {
  database.execute(fmt::format(table_definitions, fmt::arg("run_columns", run_definitions)));
  for (const View& view : views()) database.execute(view.definition);
  database.execute(
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application_id, schema_version));
}

// No version has changed a table's columns, only what they may hold, so rows are taken over as they are.
void upgrade_schema(const Database& database) {
  if (database.integer("PRAGMA user_version") == schema_version) return;
  for (const View& view : views()) database.execute(fmt::format("DROP VIEW IF EXISTS {}", view.name));
  database.execute("DROP INDEX IF EXISTS realization_of_bound");
  std::vector<std::string> old;
  for (const char* table : table_names) {
    if (!has_table(database, table)) continue;
    database.execute(fmt::format("ALTER TABLE {0} RENAME TO old_{0}", table));
    old.emplace_back(table);
  }
  create_schema(database);
  for (auto table = old.rbegin(); table != old.rend(); ++table)
    database.execute(fmt::format("INSERT INTO {0} SELECT * FROM old_{0}", *table));
  for (const std::string& table : old) database.execute(fmt::format("DROP TABLE old_{}", table));
}

void mend_views(const Database& database) {
  for (const View& view : views()) {
    Statement stored = database.prepare("SELECT sql FROM sqlite_schema WHERE type = 'view' AND name = ?");
    stored.bind(view.name);
    // SQLite keeps the text from CREATE to the semicolon.
    const std::string_view text(view.definition);
    const auto start = text.find("CREATE");
    if (stored.step() && stored.text(0) == text.substr(start, text.rfind(';') - start)) continue;
    database.execute(fmt::format("DROP VIEW IF EXISTS {}", view.name));
    database.execute(view.definition);
  }
}

Database open_ledger(const std::filesystem::path& file) {
  Database database(file, Database::Mode::read_only);
  check_schema(database);
  database.execute("PRAGMA temp_store = MEMORY");
  if (!has_table(database, "repeat_noise"))
    database.execute(
        "CREATE TEMP TABLE repeat_noise (window TEXT PRIMARY KEY, runs INTEGER, q_c_mean_kPa REAL, "
        "q_c_deviation_kPa REAL, si_half_width REAL)");
  for (const View& view : views()) {
    std::string definition = view.definition;
    definition.replace(definition.find("CREATE VIEW"), 11, "CREATE TEMP VIEW");
    database.execute(definition);
  }
  return database;
}

bool is_empty(const Database& database) {
  return database.integer("SELECT count(*) FROM sqlite_schema") == 0;
}

void check_schema(const Database& database) {
  const std::string file = database.file().string();
  if (database.integer("PRAGMA application_id") != application_id)
    throw Error(file + ": an SQLite database, but not one of a campaign; name another file");
  const auto version = database.integer("PRAGMA user_version");
  if (version < oldest_schema_version || version > schema_version)
    throw Error(
        fmt::format("{}: has schema version {}, this program knows version {}; use the program that wrote "
                    "it, or move the file away and run again",
                    file, version, schema_version));
}

}  // namespace cpt::results

#include "results/schema.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cpt::results {
namespace {

constexpr std::int64_t application_id = 0x43505443;  // "CPTC"

constexpr const char* tables = R"sql(
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
  id               INTEGER PRIMARY KEY,
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
  max_time_step_s  REAL
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

CREATE TABLE import (
  position         INTEGER PRIMARY KEY,
  file             TEXT NOT NULL,
  sha256           TEXT NOT NULL,
  imported         TEXT NOT NULL,
  program_version  TEXT NOT NULL
);
)sql";

// A table after those that refer to it.
constexpr std::array<const char*, 10> table_names = {"checksum",     "repeat_noise", "window_mean", "curve",
                                                     "depth_window", "realization",  "parameter",   "layer",
                                                     "campaign",     "import"};

// SI and SI_noise as in sensitivity.hpp. A bound without a realization of its own equals the baseline.
constexpr const char* sensitivity_view = R"sql(
CREATE VIEW sensitivity AS
WITH
baseline AS (
  SELECT id, status FROM realization WHERE side = 'baseline'
),
bound AS (
  SELECT w.name AS window, w.position AS window_position, w.problem AS window_problem,
         p.name AS parameter, p.position AS parameter_position, baseline.id AS baseline_id,
         coalesce((SELECT id FROM realization WHERE parameter = p.name AND side = 'lower'), baseline.id) AS lower_id,
         coalesce((SELECT id FROM realization WHERE parameter = p.name AND side = 'upper'), baseline.id) AS upper_id
  FROM depth_window AS w CROSS JOIN parameter AS p CROSS JOIN baseline
),
state AS (
  SELECT id, CASE WHEN status IN ('pending', 'running') THEN status
                  WHEN status = 'completed' THEN 'has no q_c in the window'
                  ELSE 'failed (' || status || ')' END AS words
  FROM realization
),
value AS (
  SELECT bound.*,
         l.q_c_mean_kPa AS q_lower, u.q_c_mean_kPa AS q_upper, b.q_c_mean_kPa AS q_baseline,
         b.q_c_max_kPa AS q_baseline_max,
         CASE WHEN u.q_c_mean_kPa > 0 THEN (u.q_c_mean_kPa - l.q_c_mean_kPa) / u.q_c_mean_kPa END AS si,
         CASE WHEN b.q_c_max_kPa > 0 THEN (b.q_c_max_kPa - b.q_c_min_kPa) / b.q_c_max_kPa END AS si_noise,
         CASE WHEN l.realization IS NULL AND lower_id <> baseline_id
              THEN 'lower run ' || (SELECT words FROM state WHERE id = lower_id) || ', ' ELSE '' END AS no_lower,
         CASE WHEN u.realization IS NULL AND upper_id <> baseline_id
              THEN 'upper run ' || (SELECT words FROM state WHERE id = upper_id) || ', ' ELSE '' END AS no_upper,
         CASE WHEN b.realization IS NULL
              THEN 'baseline run ' || (SELECT words FROM state WHERE id = baseline_id) ELSE '' END AS no_baseline
  FROM bound
  LEFT JOIN window_mean AS l ON l.realization = lower_id AND l.window = bound.window
  LEFT JOIN window_mean AS u ON u.realization = upper_id AND u.window = bound.window
  LEFT JOIN window_mean AS b ON b.realization = baseline_id AND b.window = bound.window
)
SELECT window, parameter, q_lower AS q_lower_kPa, q_upper AS q_upper_kPa, q_baseline AS q_baseline_kPa,
       si, abs(si) AS si_abs, si_noise, abs(si) > si_noise AS above_noise,
       si_half_width, abs(si) > si_half_width AS above_repeats,
       CASE
         WHEN window_problem <> '' THEN 'undefined: ' || window_problem
         WHEN si IS NULL AND q_lower IS NOT NULL AND q_upper IS NOT NULL
           THEN 'undefined: q_c at the upper bound is not positive'
         WHEN si IS NULL THEN 'undefined: ' || rtrim(no_lower || no_upper || no_baseline, ', ')
         ELSE rtrim(
           CASE WHEN si < 0 THEN 'negative: q_c is larger at the lower bound; ' ELSE '' END ||
           CASE WHEN (q_lower - q_baseline) * (q_upper - q_baseline) > 0
                     AND min(abs(q_lower - q_baseline), abs(q_upper - q_baseline)) > si_noise * q_baseline
                THEN CASE WHEN q_lower > q_baseline THEN 'one-sided: both bounds raise q_c; '
                          ELSE 'one-sided: both bounds lower q_c; ' END ELSE '' END ||
           CASE WHEN si_noise IS NULL THEN 'noise undefined: ' ||
                CASE WHEN no_baseline <> '' THEN no_baseline
                     WHEN q_baseline_max IS NULL THEN 'only the average of the baseline was imported'
                     ELSE 'q_c of the baseline is not positive' END
                ELSE '' END, '; ')
       END AS note
FROM value LEFT JOIN repeat_noise USING (window)
ORDER BY window_position, parameter_position;
)sql";

constexpr const char* tornado_view = R"sql(
CREATE VIEW tornado AS
SELECT s.window AS window,
       row_number() OVER (PARTITION BY s.window
                          ORDER BY abs(s.q_upper_kPa - s.q_lower_kPa) DESC NULLS LAST, p.position) AS rank,
       s.parameter AS parameter, p.symbol AS symbol, p.unit AS unit,
       p.lower_text AS lower, p.baseline_text AS baseline, p.upper_text AS upper,
       s.q_lower_kPa AS q_lower_kPa, s.q_upper_kPa AS q_upper_kPa, s.q_baseline_kPa AS q_baseline_kPa,
       abs(s.q_upper_kPa - s.q_lower_kPa) AS swing_kPa,
       s.si AS si, s.above_noise AS above_noise, s.note AS note
FROM sensitivity AS s
JOIN parameter AS p ON p.name = s.parameter
JOIN depth_window AS w ON w.name = s.window
ORDER BY w.position, rank;
)sql";

bool has(const Database& database, const std::string& table) {
  return database.prepare("SELECT 1 FROM sqlite_schema WHERE type = 'table' AND name = ?").bind(table).step();
}

}  // namespace

void create_schema(const Database& database) {
  database.execute(tables);
  database.execute(sensitivity_view);
  database.execute(tornado_view);
  database.execute(
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application_id, schema_version));
}

// No version has changed a table's columns, only what they may hold, so rows are taken over as they are.
void upgrade_schema(const Database& database) {
  if (database.integer("PRAGMA user_version") == schema_version) return;
  database.execute(
      "DROP VIEW IF EXISTS tornado; DROP VIEW IF EXISTS sensitivity; DROP INDEX IF EXISTS "
      "realization_of_bound");
  std::vector<std::string> old;
  for (const char* table : table_names) {
    if (!has(database, table)) continue;
    database.execute(fmt::format("ALTER TABLE {0} RENAME TO old_{0}", table));
    old.emplace_back(table);
  }
  create_schema(database);
  for (auto table = old.rbegin(); table != old.rend(); ++table)
    database.execute(fmt::format("INSERT INTO {0} SELECT * FROM old_{0}", *table));
  for (const std::string& table : old) database.execute(fmt::format("DROP TABLE old_{}", table));
}

void mend_views(const Database& database) {
  for (const auto& [name, definition] :
       {std::pair{"tornado", tornado_view}, {"sensitivity", sensitivity_view}}) {
    Statement stored = database.prepare("SELECT sql FROM sqlite_schema WHERE type = 'view' AND name = ?");
    stored.bind(name);
    // SQLite keeps the text from CREATE to the semicolon.
    const std::string_view text(definition);
    const auto start = text.find("CREATE");
    if (stored.step() && stored.text(0) == text.substr(start, text.rfind(';') - start)) continue;
    database.execute(fmt::format("DROP VIEW IF EXISTS {}", name));
    database.execute(definition);
  }
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

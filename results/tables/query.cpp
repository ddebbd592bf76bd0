#include "results/tables/query.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "parameters/nearest_name.hpp"
#include "results/files/database.hpp"
#include "results/files/file_lock.hpp"
#include "results/ledger/schema.hpp"
#include "results/statistics/effects.hpp"
#include "results/tables/output_names.hpp"
#include "results/tables/statement_rows.hpp"
#include "solver/channels.hpp"
#include "solver/quantities.hpp"

namespace cpt::results {
namespace {

constexpr std::array<NamedQuery, 9> questions = {{
    {"realizations",
     "every realization: its parameter, value, status, cost and audit, and what is out of line"},
    {"windows", "every realization's q_c and other channels in every window, with the window's depths"},
    {"sensitivity", "sensitivity index of every parameter in every window, with its interval and the noise"},
    {"tornado", "range of q_c between each parameter's bounds, widest first"},
    {"failures", "realizations that failed, with the reason"},
    {"unused", "finished results that the study no longer asks for; campaign prune removes them"},
    {"effects", "what the study's [design] says of its parameters, with 95 % intervals"},
    {"bands", "of a design propagation: how every channel is distributed at every depth"},
    {"convergence",
     "of morris, latin_hypercube and sobol: their main number as the first runs alone would have it"},
}};

// In the order of the questions; the last three are answered without SQL.
constexpr std::array<std::string_view, questions.size() - 3> question_statements = {
    "SELECT id, r.parameter, r.side, value_text AS value, r.status, wall_s, steps, material_points, "
    "r.mass_error, "
    "r.momentum_error, r.energy_error, r.kinetic_fraction, r.max_empty_cells, r.limited_share, "
    "r.safeguarded_share, out_of_line "
    "FROM realization "
    "AS r "
    "JOIN audit ON audit.realization = id ORDER BY id",
    "SELECT m.window, m.realization, r.parameter, r.side, r.value_text AS value, m.from_m, m.to_m, m.bins, "
    "m.q_c_mean_kPa, m.q_c_min_kPa, m.q_c_max_kPaOTHER_MEANS FROM window_mean AS m JOIN realization AS r ON "
    "r.id = "
    "m.realization "
    "JOIN depth_window AS w ON w.name = m.window ORDER BY w.position, m.realization",
    "SELECT * FROM sensitivity",
    "SELECT * FROM tornado",
    "SELECT id, parameter, side, value_text AS value, status, reason, wall_s FROM realization "
    "WHERE status NOT IN ('pending', 'running', 'not_needed', 'completed') ORDER BY id",
    "SELECT id, parameter, side, value_text AS value, status, solver_version, wall_s, finished, study FROM "
    "unused ORDER BY id",
};

// "2:15", in characters from 1.
std::string place_in(std::string_view sql, int byte) {
  const std::string_view before = sql.substr(0, static_cast<std::size_t>(byte));
  const auto line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  const auto characters = std::ranges::count_if(
      before.substr(line_start), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  return fmt::format("{}:{}", 1 + std::ranges::count(before, '\n'), 1 + characters);
}

// "; did you mean window?" for SQLite's "no such column: windw".
std::string nearest_in(const Database& database, std::string_view complaint) {
  const auto meant = [&](std::string_view about, const char* names_of) -> std::string {
    const auto at = complaint.find(about);
    if (at == complaint.npos) return "";
    const std::string_view whole = complaint.substr(at + about.size());
    const std::string_view name = whole.substr(whole.rfind('.') + 1);  // npos + 1 is 0
    std::vector<std::string> names;
    Statement rows = database.prepare(names_of);
    while (rows.step()) names.push_back(rows.text(0));
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string_view near = parameters::nearest_name(name, known);
    return near.empty() ? "; docs/schema.md has all tables and columns"
                        : fmt::format("; did you mean {}?", near);
  };
  constexpr const char* tables =
      "SELECT name FROM sqlite_schema WHERE type IN ('table', 'view') ORDER BY name";
  constexpr const char* columns =
      "SELECT DISTINCT c.name FROM sqlite_schema AS t JOIN pragma_table_info(t.name) AS c "
      "WHERE t.type IN ('table', 'view') ORDER BY c.name";
  return meant("no such table: ", tables) + meant("no such column: ", columns);
}

// With the averages of all channels behind q_c.
std::string with_channels(std::string sql) {
  constexpr std::string_view place = "OTHER_MEANS";
  const std::size_t at = sql.find(place);
  if (at == sql.npos) return sql;
  std::string columns;
  for (const solver::Channel& channel : solver::channels().subspan(1))
    columns += ", m." + in_unit(channel, "mean_kPa");
  return sql.replace(at, place.size(), columns);
}

// What is marked as running in a campaign that nobody runs was running when it ended.
std::string said_of_now(std::string_view statement, const Database& database) {
  std::string sql(statement);
  constexpr std::string_view status = " r.status, wall_s, steps";
  const std::size_t at = sql.find(status);
  if (at == std::string::npos || is_held(database.file().string() + ".lock")) return sql;
  return sql.replace(
      at, status.size(),
      " CASE r.status WHEN 'running' THEN 'interrupted' ELSE r.status END AS status, wall_s, steps");
}

}  // namespace

std::span<const NamedQuery> named_queries() { return questions; }

Table query(const std::filesystem::path& file, std::string_view name) {
  return query(open_ledger(file), name);
}

Table query(const Database& database, std::string_view name) {
  if (name == "effects" || name == "convergence" || name == "bands") {
    const Transaction transaction(database, Transaction::Kind::read);
    const Snapshot snapshot = read_snapshot(database);
    Effects effects = design_effects(snapshot);
    if (!effects.problem.empty())
      throw Error(fmt::format("{}: {}", database.file().string(), effects.problem));
    if (name == "effects") return effects_table(effects);
    if (name == "bands") return bands_table(effects);
    add_index_convergence(snapshot, effects);
    return index_convergence_table(effects);
  }
  if (name == "unused" && !has_table(database, "unused")) return {};  // an earlier schema version
  for (std::size_t i = 0; i < question_statements.size(); ++i)
    if (questions[i].name == name)
      return named_for_outputs(
          rows_of(database.prepare(with_channels(said_of_now(question_statements[i], database)))), database);
  std::vector<std::string_view> known;
  for (const NamedQuery& question : questions) known.push_back(question.name);
  const std::string_view near = parameters::nearest_name(name, known);
  throw BadQuery(fmt::format("unknown query '{}'; there are: {}{}", name, fmt::join(known, " "),
                             near.empty() ? "" : fmt::format("; did you mean {}?", near)));
}

Table query_sql(const std::filesystem::path& file, std::string_view sql) {
  return query_sql(open_ledger(file), sql);
}

Table query_sql(const Database& database, std::string_view sql) {
  if (sql.find_first_not_of(" \t\r\n;") == sql.npos) throw BadQuery("sql: the statement is empty");
  try {
    Statement statement = database.prepare(sql);
    // The connection cannot write to the ledger anyway; ATTACH and the like would still reach other files.
    if (!statement.read_only() || statement.columns() == 0)
      throw BadQuery("sql: only statements that read are run");
    return rows_of(std::move(statement));
  } catch (const BadStatement& refused) {
    const std::string_view complaint =
        std::string_view(refused.what()).substr(database.file().string().size() + 2);
    const bool placed = refused.byte >= 0 && static_cast<std::size_t>(refused.byte) <= sql.size();
    throw BadQuery(fmt::format("sql{}: {}{}", placed ? ":" + place_in(sql, refused.byte) : "", complaint,
                               nearest_in(database, complaint)));
  }
}

}  // namespace cpt::results

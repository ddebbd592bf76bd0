#include "results/query.hpp"

#include <fmt/format.h>

#include <array>

#include "results/database.hpp"
#include "results/effects.hpp"
#include "results/schema.hpp"
#include "results/statement_rows.hpp"

namespace cpt::results {
namespace {

constexpr std::array<NamedQuery, 6> questions = {{
    {"realizations", "every realization: its parameter, value, status, cost and audit"},
    {"windows", "every realization's q_c in every window, with the window's depths"},
    {"sensitivity", "sensitivity index of every parameter in every window, with the noise floor"},
    {"tornado", "range of q_c between each parameter's bounds, widest first"},
    {"failures", "realizations that failed, with the reason"},
    {"effects", "what the study's [design] says of its parameters, with 95 % intervals"},
}};

// In the order of the questions; the last one is answered without SQL.
constexpr std::array<std::string_view, questions.size() - 1> statements = {
    "SELECT id, parameter, side, value_text AS value, status, wall_s, steps, material_points, mass_error, "
    "momentum_error, energy_error, kinetic_fraction FROM realization ORDER BY id",
    "SELECT m.window, m.realization, r.parameter, r.side, r.value_text AS value, m.from_m, m.to_m, m.bins, "
    "m.q_c_mean_kPa, m.q_c_min_kPa, m.q_c_max_kPa FROM window_mean AS m JOIN realization AS r ON r.id = "
    "m.realization "
    "JOIN depth_window AS w ON w.name = m.window ORDER BY w.position, m.realization",
    "SELECT * FROM sensitivity",
    "SELECT * FROM tornado",
    "SELECT id, parameter, side, value_text AS value, status, reason, wall_s FROM realization "
    "WHERE status NOT IN ('pending', 'running', 'completed') ORDER BY id",
};

}  // namespace

std::span<const NamedQuery> named_queries() { return questions; }

Table query(const std::filesystem::path& database, std::string_view name) {
  if (name == "effects") {
    const Effects effects = design_effects(read_snapshot(database));
    if (!effects.problem.empty()) throw Error(fmt::format("{}: {}", database.string(), effects.problem));
    return effects_table(effects);
  }
  for (std::size_t i = 0; i < statements.size(); ++i)
    if (questions[i].name == name) return query_sql(database, statements[i]);
  std::string known;
  for (const NamedQuery& question : questions) known += fmt::format(" {}", question.name);
  throw Error(fmt::format("unknown query '{}'; there are:{}", name, known));
}

Table query_sql(const std::filesystem::path& file, std::string_view sql) {
  const Database database(file, Database::Mode::read_only);
  check_schema(database);
  Statement statement = database.prepare(sql);
  // The connection cannot write to the ledger anyway; ATTACH and the like would still reach other files.
  if (!statement.read_only() || statement.columns() == 0)
    throw Error(fmt::format("{}: only statements that read are run", file.string()));
  return rows_of(std::move(statement));
}

}  // namespace cpt::results

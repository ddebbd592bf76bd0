#include "diagnosis/answer_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "diagnosis/design.hpp"
#include "results/database.hpp"
#include "solver/mechanisms/catalogue.hpp"

namespace cpt::diagnosis {
namespace {

constexpr const char* tables = R"sql(
DROP TABLE IF EXISTS diagnosis;
DROP TABLE IF EXISTS hypothesis;
DROP TABLE IF EXISTS mismatch;
DROP TABLE IF EXISTS fitted_parameter;
DROP TABLE IF EXISTS mechanism_pair;
CREATE TABLE diagnosis (
  title             TEXT NOT NULL,
  answer            TEXT NOT NULL,
  p_nothing_missing REAL,
  p_mismatch        REAL,
  rmse_null         REAL,
  rmse_best         REAL,
  held_out_rmse_null REAL,
  held_out_rmse     REAL,
  held_out_gain     REAL,
  held_out_gain_lower REAL,
  held_out_gain_upper REAL
);
CREATE TABLE hypothesis (
  position INTEGER PRIMARY KEY, name TEXT NOT NULL, prior REAL, log_evidence REAL, probability REAL,
  in_set INTEGER NOT NULL
);
CREATE TABLE mismatch (
  position INTEGER PRIMARY KEY, sounding INTEGER NOT NULL, from_m REAL, to_m REAL, percent REAL, step_kPa REAL, p REAL
);
CREATE TABLE fitted_parameter (
  mechanism TEXT NOT NULL, quantity TEXT NOT NULL, unit TEXT NOT NULL, value REAL, deviation REAL, lower REAL, upper REAL,
  PRIMARY KEY (mechanism, quantity)
) WITHOUT ROWID;
CREATE TABLE mechanism_pair (
  position INTEGER PRIMARY KEY, first TEXT NOT NULL, second TEXT NOT NULL, log_evidence REAL
);
)sql";

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<FittedParameter> fitted_parameters(const Diagnosis& diagnosis, const Problem& problem) {
  std::vector<FittedParameter> fitted;
  for (std::size_t k = 0; k < diagnosis.mechanisms.size(); ++k) {
    const MechanismEvidence& evidence = diagnosis.mechanisms[k];
    const solver::Mechanism* mechanism = solver::find_mechanism(evidence.name);
    const std::vector<std::string>& names = problem.mechanisms[k].parameters;
    for (std::size_t j = 0; j < names.size() && mechanism != nullptr; ++j)
      for (const solver::MechanismParameter& parameter : mechanism->parameters) {
        if (parameter.quantity.name != names[j]) continue;
        const auto at = [&](double place) { return prior_value(parameter, place); };
        const auto i = static_cast<Index>(j);
        fitted.push_back({evidence.name, names[j], std::string(parameter.quantity.unit), at(evidence.mean(i)),
                          evidence.deviation(i) * (parameter.prior_upper - parameter.prior_lower),
                          at(evidence.lower(i)), at(evidence.upper(i))});
      }
  }
  return fitted;
}

const std::string& answer_name(const Diagnosis& diagnosis) {
  return diagnosis.hypotheses[diagnosis.answer].name;
}

void store_answer(const std::filesystem::path& file, const std::string& title, const Diagnosis& diagnosis,
                  const Problem& problem) {
  const results::Database database(file, results::Database::Mode::read_write);
  results::Transaction transaction(database, results::Transaction::Kind::write);
  database.execute(tables);
  const Hypothesis& none = diagnosis.hypotheses[diagnosis.mechanisms.size()];
  const auto& held_out = diagnosis.held_out;
  database.prepare("INSERT INTO diagnosis VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(title)
      .bind(answer_name(diagnosis))
      .bind(none.probability)
      .bind(diagnosis.location.p)
      .bind(diagnosis.recalibrated.rmse)
      .bind(diagnosis.best ? diagnosis.with_best.rmse : nothing)
      .bind(held_out ? held_out->rmse_null : nothing)
      .bind(held_out ? held_out->rmse : nothing)
      .bind(held_out ? held_out->per_cell : nothing)
      .bind(held_out ? held_out->lower : nothing)
      .bind(held_out ? held_out->upper : nothing)
      .run();
  for (std::size_t k = 0; k < diagnosis.hypotheses.size(); ++k) {
    const Hypothesis& h = diagnosis.hypotheses[k];
    const bool in_set = std::find(diagnosis.set.begin(), diagnosis.set.end(), k) != diagnosis.set.end();
    database.prepare("INSERT INTO hypothesis VALUES (?, ?, ?, ?, ?, ?)")
        .bind(static_cast<int>(k) + 1)
        .bind(h.name)
        .bind(h.prior)
        .bind(h.log_evidence)
        .bind(h.probability)
        .bind(in_set ? 1 : 0)
        .run();
  }
  int position = 0;
  for (const Mismatch& m : diagnosis.location.mismatches)
    database.prepare("INSERT INTO mismatch VALUES (?, ?, ?, ?, ?, ?, ?)")
        .bind(++position)
        .bind(m.sounding)
        .bind(m.from)
        .bind(m.to)
        .bind(m.percent)
        .bind(m.step / 1e3)
        .bind(m.p)
        .run();
  for (const FittedParameter& f : fitted_parameters(diagnosis, problem))
    database.prepare("INSERT INTO fitted_parameter VALUES (?, ?, ?, ?, ?, ?, ?)")
        .bind(f.mechanism)
        .bind(f.quantity)
        .bind(f.unit)
        .bind(f.value)
        .bind(f.deviation)
        .bind(f.lower)
        .bind(f.upper)
        .run();
  position = 0;
  for (const PairEvidence& pair : diagnosis.pairs)
    database.prepare("INSERT INTO mechanism_pair VALUES (?, ?, ?, ?)")
        .bind(++position)
        .bind(pair.first)
        .bind(pair.second)
        .bind(pair.log_evidence)
        .run();
  transaction.commit();
}

StoredAnswer load_answer(const std::filesystem::path& file) {
  const results::Database database(file, results::Database::Mode::read_only);
  StoredAnswer stored{};
  auto main = database.prepare("SELECT answer, p_mismatch, held_out_rmse_null, held_out_rmse FROM diagnosis");
  if (!main.step()) throw std::invalid_argument(file.string() + " holds no answer");
  stored.answer = main.text(0);
  stored.p_mismatch = main.number(1);
  stored.held_out_rmse_null = main.number(2);
  stored.held_out_rmse = main.number(3);
  auto rows = database.prepare(
      "SELECT name, prior, log_evidence, probability, in_set FROM hypothesis ORDER BY position");
  while (rows.step()) {
    stored.hypotheses.push_back({rows.text(0), rows.number(1), rows.number(2), rows.number(3)});
    if (rows.integer(4) != 0) stored.set.push_back(rows.text(0));
  }
  auto found = database.prepare("SELECT sounding, from_m, to_m FROM mismatch ORDER BY position");
  while (found.step())
    stored.mismatches.push_back({static_cast<int>(found.integer(0)), found.number(1), found.number(2)});
  auto fitted = database.prepare(
      "SELECT mechanism, quantity, unit, value, deviation, lower, upper FROM fitted_parameter");
  while (fitted.step())
    stored.fitted.push_back({fitted.text(0), fitted.text(1), fitted.text(2), fitted.number(3),
                             fitted.number(4), fitted.number(5), fitted.number(6)});
  auto pair = database.prepare("SELECT first, second FROM mechanism_pair ORDER BY position LIMIT 1");
  if (pair.step()) stored.best_pair = {pair.text(0), pair.text(1)};
  return stored;
}

}  // namespace cpt::diagnosis

#include "diagnosis/answer_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "diagnosis/departure.hpp"
#include "diagnosis/prior_range.hpp"
#include "results/files/database.hpp"
#include "results/files/patience.hpp"

namespace cpt::diagnosis {
namespace {

constexpr const char* tables = R"sql(
DROP TABLE IF EXISTS diagnosis;
DROP TABLE IF EXISTS hypothesis;
DROP TABLE IF EXISTS mismatch;
DROP TABLE IF EXISTS fitted_parameter;
DROP TABLE IF EXISTS mechanism_pair;
DROP TABLE IF EXISTS next_measurement;
DROP TABLE IF EXISTS reservation;
CREATE TABLE diagnosis (
  title             TEXT NOT NULL,
  study             TEXT NOT NULL,
  headline          TEXT NOT NULL,
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
  position INTEGER PRIMARY KEY, sounding INTEGER NOT NULL, from_m REAL, to_m REAL, above_refitted_percent REAL,
  above_refitted_kPa REAL, scan_step_percent REAL, p REAL
);
CREATE TABLE fitted_parameter (
  mechanism TEXT NOT NULL, quantity TEXT NOT NULL, unit TEXT NOT NULL, value REAL, deviation REAL, lower REAL, upper REAL,
  PRIMARY KEY (mechanism, quantity)
) WITHOUT ROWID;
CREATE TABLE mechanism_pair (
  position INTEGER PRIMARY KEY, first TEXT NOT NULL, second TEXT NOT NULL, log_evidence REAL
);
CREATE TABLE next_measurement (
  position INTEGER PRIMARY KEY, name TEXT NOT NULL, least_distance REAL
);
CREATE TABLE reservation (position INTEGER PRIMARY KEY, sentence TEXT NOT NULL);
)sql";

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr HeldOutGain no_gain{no_number, no_number, no_number, no_number, no_number, no_number};

}  // namespace

std::vector<FittedParameter> fitted_parameters(const Diagnosis& diagnosis, const Assembled& assembled) {
  std::vector<FittedParameter> fitted;
  for (std::size_t k = 0; k < diagnosis.mechanisms.size(); ++k) {
    const MechanismEvidence& evidence = diagnosis.mechanisms[k].evidence;
    const MechanismDesign& design = assembled.mechanisms[k];
    for (std::size_t j = 0; j < design.varied.size(); ++j) {
      const solver::MechanismParameter& parameter = design.mechanism.parameters[design.varied[j]];
      const auto at = [&](double place) { return prior_value(parameter, place); };
      const auto i = static_cast<Index>(j);
      fitted.push_back({evidence.name, std::string(parameter.quantity.name),
                        std::string(parameter.quantity.unit), at(evidence.mean(i)),
                        prior_deviation(parameter, evidence.mean(i), evidence.deviation(i)),
                        at(evidence.lower(i)), at(evidence.upper(i))});
    }
  }
  return fitted;
}

void store_answer(const std::filesystem::path& file, const AnswerText& text, const Diagnosis& diagnosis,
                  const Assembled& assembled) {
  const Problem& problem = assembled.problem;
  const results::Database database(file, results::Database::Mode::read_write);
  results::Transaction transaction(database, results::Transaction::Kind::write);
  database.execute(tables);
  const Verdict& verdict = diagnosis.verdict;
  const HeldOutGain gain = diagnosis.best && diagnosis.best->held_out ? *diagnosis.best->held_out : no_gain;
  database.prepare("INSERT INTO diagnosis VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(text.title)
      .bind(text.study)
      .bind(text.headline)
      .bind(verdict.of(verdict.answer).name)
      .bind(verdict.of(Explanation::nothing()).probability)
      .bind(diagnosis.location.p)
      .bind(diagnosis.null.recalibrated.rmse)
      .bind(diagnosis.best ? diagnosis.with_best().rmse : no_number)
      .bind(gain.rmse_null)
      .bind(gain.rmse)
      .bind(gain.per_cell)
      .bind(gain.lower)
      .bind(gain.upper)
      .run();
  int position = 0;
  for (const Hypothesis& h : verdict.hypotheses)
    database.prepare("INSERT INTO hypothesis VALUES (?, ?, ?, ?, ?, ?)")
        .bind(++position)
        .bind(h.name)
        .bind(h.prior)
        .bind(h.log_evidence)
        .bind(h.probability)
        .bind(verdict.in_set(h.explanation) ? 1 : 0)
        .run();
  position = 0;
  const VectorXd recorded = problem.recorded(diagnosis.compared.rows);
  for (const Mismatch& m : diagnosis.location.mismatches) {
    const Departure above =
        departure_on(diagnosis.compared.cells, recorded, diagnosis.null.recalibrated.curve, m);
    database.prepare("INSERT INTO mismatch VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(++position)
        .bind(m.sounding)
        .bind(m.from)
        .bind(m.to)
        .bind(above.percent)
        .bind(above.difference / 1e3)
        .bind(100.0 * std::expm1(m.size))
        .bind(m.p)
        .run();
  }
  for (const FittedParameter& f : fitted_parameters(diagnosis, assembled))
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
  for (const NextMeasurement& next : diagnosis.next)
    database.prepare("INSERT INTO next_measurement VALUES (?, ?, ?)")
        .bind(++position)
        .bind(next.name)
        .bind(next.least_distance)
        .run();
  position = 0;
  for (const PairEvidence& pair : diagnosis.pairs)
    database.prepare("INSERT INTO mechanism_pair VALUES (?, ?, ?, ?)")
        .bind(++position)
        .bind(pair.first)
        .bind(pair.second)
        .bind(pair.log_evidence)
        .run();
  position = 0;
  for (const std::string& sentence : text.reservations)
    database.prepare("INSERT INTO reservation VALUES (?, ?)").bind(++position).bind(sentence).run();
  transaction.commit();
}

namespace {

bool has_column(const results::Database& database, const std::string& table, const std::string& column) {
  results::Statement row = database.prepare("SELECT 1 FROM pragma_table_info(?) WHERE name = ?");
  row.bind(table).bind(column);
  return row.step();
}

// Earlier answers kept the step of the scan there, which is no distance of recording and refitted curve.
std::string places_query(const results::Database& database) {
  return fmt::format(
      "SELECT sounding, from_m, to_m, {}, p FROM mismatch ORDER BY position",
      has_column(database, "mismatch", "above_refitted_percent") ? "above_refitted_percent" : "NULL");
}

}  // namespace

StoredAnswer load_answer(const std::filesystem::path& file) {
  const results::Database database(file, results::Database::Mode::read_only);
  const results::Transaction transaction(database, results::Transaction::Kind::read);
  results::Statement row = database.prepare(
      "SELECT title, study, headline, answer, held_out_rmse_null, held_out_rmse, held_out_gain, "
      "held_out_gain_lower, held_out_gain_upper FROM diagnosis");
  if (!row.step()) throw std::invalid_argument(file.string() + " holds no answer");
  StoredAnswer answer{{row.text(0), row.text(1), row.text(2), {}},
                      file.filename().string(),
                      row.text(3),
                      row.number(4),
                      row.number(5),
                      row.number(6),
                      row.number(7),
                      row.number(8),
                      {},
                      {},
                      {},
                      {}};
  results::Statement hypotheses = database.prepare(
      "SELECT name, prior, log_evidence, probability, in_set FROM hypothesis ORDER BY position");
  while (hypotheses.step())
    answer.hypotheses.push_back({hypotheses.text(0), hypotheses.number(1), hypotheses.number(2),
                                 hypotheses.number(3), hypotheses.integer(4) != 0});
  results::Statement places = database.prepare(places_query(database));
  while (places.step())
    answer.mismatches.push_back({static_cast<int>(places.integer(0)), places.number(1), places.number(2),
                                 places.number(3), places.number(4)});
  results::Statement fitted = database.prepare(
      "SELECT mechanism, quantity, unit, value, deviation, lower, upper FROM fitted_parameter");
  while (fitted.step())
    answer.fitted.push_back({fitted.text(0), fitted.text(1), fitted.text(2), fitted.number(3),
                             fitted.number(4), fitted.number(5), fitted.number(6)});
  results::Statement pair =
      database.prepare("SELECT first, second FROM mechanism_pair ORDER BY position LIMIT 1");
  if (pair.step()) answer.best_pair = {pair.text(0), pair.text(1)};
  if (has_column(database, "reservation", "sentence")) {
    results::Statement sentences = database.prepare("SELECT sentence FROM reservation ORDER BY position");
    while (sentences.step()) answer.reservations.push_back(sentences.text(0));
  }
  return answer;
}

namespace {

bool has_answer_about(const std::filesystem::path& file, const std::string& study) {
  const results::Database database(file, results::Database::Mode::read_only);
  // An answer stored before the table named its study is nobody's.
  if (!has_column(database, "diagnosis", "study")) return false;
  results::Statement row = database.prepare("SELECT 1 FROM diagnosis WHERE study = ?");
  row.bind(study);
  return row.step();
}

}  // namespace

std::vector<StoredAnswer> read_answers(const std::filesystem::path& folder, const std::string& study) {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".sqlite") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<StoredAnswer> answers;
  // A database that only lies beside the study keeps nobody waiting for long.
  const results::Patience brief([](const auto&, double seconds) { return seconds < 10.0; });
  for (const std::filesystem::path& file : files) {
    try {
      if (has_answer_about(file, study)) answers.push_back(load_answer(file));
    } catch (const results::Error&) {
      continue;  // no database, or one that is being made
    }
  }
  return answers;
}

}  // namespace cpt::diagnosis

#include "diagnosis/several/findings_store.hpp"

#include <algorithm>
#include <limits>

#include "diagnosis/prior_range.hpp"
#include "results/files/database.hpp"

namespace cpt::diagnosis {
namespace {

constexpr const char* tables = R"sql(
DROP TABLE IF EXISTS several;
DROP TABLE IF EXISTS effect;
DROP TABLE IF EXISTS effect_parameter;
DROP TABLE IF EXISTS effect_group;
DROP TABLE IF EXISTS subset;
CREATE TABLE several (
  p_nothing REAL, alarm_level REAL, alarm INTEGER NOT NULL, p_something_else REAL, check_chi_square REAL, check_p REAL,
  best TEXT NOT NULL, wrong TEXT NOT NULL, gain_over_wrong REAL, gain_over_wrong_error REAL, gain_over_nothing REAL,
  gain_over_nothing_error REAL
);
CREATE TABLE effect (
  name TEXT PRIMARY KEY, inclusion REAL NOT NULL, named INTEGER NOT NULL
) WITHOUT ROWID;
CREATE TABLE effect_parameter (
  effect TEXT NOT NULL, quantity TEXT NOT NULL, unit TEXT NOT NULL, value REAL, deviation REAL, lower REAL, upper REAL,
  PRIMARY KEY (effect, quantity)
) WITHOUT ROWID;
CREATE TABLE effect_group (
  position INTEGER NOT NULL, effect TEXT NOT NULL, probability REAL NOT NULL, PRIMARY KEY (position, effect)
) WITHOUT ROWID;
CREATE TABLE subset (
  position INTEGER PRIMARY KEY, effects TEXT NOT NULL, prior REAL, log_evidence REAL, probability REAL, in_set INTEGER NOT NULL
);
)sql";

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr ScoreGain no_gain{no_number, no_number};
constexpr std::size_t most_subsets = 200;

void store_parameters(const results::Database& database, const MechanismDesign& design,
                      const EffectSummary& summary) {
  for (std::size_t j = 0; j < design.varied.size(); ++j) {
    const solver::MechanismParameter& parameter = design.mechanism.parameters[design.varied[j]];
    const auto d = static_cast<Index>(j);
    database.prepare("INSERT INTO effect_parameter VALUES (?, ?, ?, ?, ?, ?, ?)")
        .bind(std::string(design.mechanism.name))
        .bind(std::string(parameter.quantity.name))
        .bind(std::string(parameter.quantity.unit))
        .bind(prior_value(parameter, summary.place(d)))
        .bind(prior_deviation(parameter, summary.place(d), summary.deviation(d)))
        .bind(prior_value(parameter, summary.lower(d)))
        .bind(prior_value(parameter, summary.upper(d)))
        .run();
  }
}

}  // namespace

std::string subset_name(const Subset& subset, const Problem& problem) {
  std::string name;
  for (const std::size_t effect : subset.effects)
    name += (name.empty() ? "" : " + ") + problem.mechanisms[effect].name;
  if (subset.something_else) name += (name.empty() ? "" : " + ") + std::string("something else");
  return name.empty() ? "nothing" : name;
}

void store_findings(const std::filesystem::path& file, const Findings& found, const Assembled& assembled) {
  const Problem& problem = assembled.problem;
  const results::Database database(file, results::Database::Mode::read_write);
  results::Transaction transaction(database, results::Transaction::Kind::write);
  database.execute(tables);
  const ScoreGain over_wrong = found.over_wrong.value_or(no_gain),
                  over_nothing = found.over_nothing.value_or(no_gain);
  database.prepare("INSERT INTO several VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(found.nothing)
      .bind(found.alarm_level)
      .bind(found.naming.alarm ? 1 : 0)
      .bind(found.explained.something_else)
      .bind(found.check.chi_square)
      .bind(found.check.p)
      .bind(subset_name(found.explained.subsets.front().subset, problem))
      .bind(found.wrong ? subset_name(*found.wrong, problem) : std::string())
      .bind(over_wrong.sum)
      .bind(over_wrong.error)
      .bind(over_nothing.sum)
      .bind(over_nothing.error)
      .run();
  for (std::size_t k = 0; k < problem.mechanisms.size(); ++k) {
    database.prepare("INSERT INTO effect VALUES (?, ?, ?)")
        .bind(problem.mechanisms[k].name)
        .bind(found.explained.inclusion(static_cast<Index>(k)))
        .bind(std::ranges::find(found.naming.named, k) != found.naming.named.end() ? 1 : 0)
        .run();
    store_parameters(database, assembled.mechanisms[k], found.summary.each[k]);
  }
  int position = 0;
  for (const EffectGroup& group : found.naming.groups) {
    ++position;
    for (const std::size_t effect : group.effects)
      database.prepare("INSERT INTO effect_group VALUES (?, ?, ?)")
          .bind(position)
          .bind(problem.mechanisms[effect].name)
          .bind(group.probability)
          .run();
  }
  for (std::size_t s = 0; s < std::min(most_subsets, found.explained.subsets.size()); ++s) {
    const WeighedSubset& weighed = found.explained.subsets[s];
    database.prepare("INSERT INTO subset VALUES (?, ?, ?, ?, ?, ?)")
        .bind(static_cast<int>(s + 1))
        .bind(subset_name(weighed.subset, problem))
        .bind(weighed.prior)
        .bind(weighed.log_evidence)
        .bind(weighed.probability)
        .bind(std::ranges::find(found.naming.set, s) != found.naming.set.end() ? 1 : 0)
        .run();
  }
  transaction.commit();
}

}  // namespace cpt::diagnosis

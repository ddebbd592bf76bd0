// The answer in SQLite: tables diagnosis, hypothesis, mismatch, fitted_parameter and mechanism_pair of the
// diagnosis' database.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/diagnose.hpp"

namespace cpt::diagnosis {

/// A mechanism's parameter in its own unit.
struct FittedParameter {
  std::string mechanism, quantity, unit;
  double value, deviation, lower, upper;  // [study unit] posterior mean, standard deviation, 90 % interval
};

/// The mechanisms' parameters, from the unit cube to their units, of every mechanism weighed.
[[nodiscard]] std::vector<FittedParameter> fitted_parameters(const Diagnosis& diagnosis,
                                                             const Problem& problem);

/// Name of the answer after the gate: a mechanism, "nothing is missing" or "none of these".
[[nodiscard]] const std::string& answer_name(const Diagnosis& diagnosis);

/// Replaces what the file holds of an earlier answer, in one transaction. Throws results::Error.
void store_answer(const std::filesystem::path& database, const std::string& title, const Diagnosis& diagnosis,
                  const Problem& problem);

/// What was stored, as far as a benchmark asks for it.
struct StoredAnswer {
  std::string answer;  ///< after the gate
  std::vector<Hypothesis> hypotheses;
  std::vector<std::string> set;
  struct Interval {
    int sounding;     ///< -1: the same depths in all
    double from, to;  // [m]
  };
  std::vector<Interval> mismatches;
  std::vector<FittedParameter> fitted;
  std::pair<std::string, std::string> best_pair;  ///< empty names if there was none
  double p_mismatch;                              // [-] family-wise
  double held_out_rmse_null, held_out_rmse;       // [ln q_c] NaN where nothing was held out
};

/// Throws results::Error or std::invalid_argument where there is none.
[[nodiscard]] StoredAnswer load_answer(const std::filesystem::path& database);

}  // namespace cpt::diagnosis

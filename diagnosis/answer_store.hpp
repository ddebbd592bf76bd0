// The answer in SQLite: tables diagnosis, hypothesis, mismatch and fitted_parameter of the diagnosis'
// database.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/assemble.hpp"

namespace cpt::diagnosis {

/// A mechanism's parameter in its own unit.
struct FittedParameter {
  std::string mechanism, quantity, unit;
  double value, deviation, lower, upper;  // [study unit] posterior mean, standard deviation, 90 % interval
};

/// The mechanisms' parameters, from the unit cube to their units, of every mechanism weighed.
[[nodiscard]] std::vector<FittedParameter> fitted_parameters(const Diagnosis& diagnosis,
                                                             const Assembled& assembled);

/// What an answer is about, and how it is said.
struct AnswerText {
  std::string title;                      ///< of the request
  std::string study;                      ///< name of the study it was held against
  std::string headline;                   ///< the answer in one sentence
  std::vector<std::string> reservations;  ///< what must be known beside it
};

/// Replaces what the file holds of an earlier answer, in one transaction. Throws results::Error.
void store_answer(const std::filesystem::path& database, const AnswerText& text, const Diagnosis& diagnosis,
                  const Assembled& assembled);

/// An answer as it is read back. Numbers that the diagnosis did not give are NaN.
struct StoredAnswer : AnswerText {
  std::string file;    ///< name of the database
  std::string answer;  ///< after the gate: a mechanism, "nothing is missing" or "none of these"
  double held_out_rmse_null, held_out_rmse;                        // [-] of ln q_c
  double held_out_gain, held_out_gain_lower, held_out_gain_upper;  // [-] log score per cell, 90 % interval
  struct Weighed {
    std::string name;
    double prior, log_evidence, probability;  // [-]
    bool in_set;
  };
  std::vector<Weighed> hypotheses;
  struct Place {
    int sounding;
    double from, to;  // [m]
    double percent;   // [%] recorded over refitted q_c, less 100; NaN in answers that did not keep it
    double p;         // [-]
  };
  std::vector<Place> mismatches;
  std::vector<FittedParameter> fitted;
  std::pair<std::string, std::string> best_pair;  ///< of mechanisms; empty names if there was none
};

/// The answer in a database. Throws results::Error or std::invalid_argument where there is none.
[[nodiscard]] StoredAnswer load_answer(const std::filesystem::path& database);

/// The answers about a study in a folder's databases, by file name. Files that are no database, or of another
/// study, are passed over.
[[nodiscard]] std::vector<StoredAnswer> read_answers(const std::filesystem::path& folder,
                                                     const std::string& study);

}  // namespace cpt::diagnosis

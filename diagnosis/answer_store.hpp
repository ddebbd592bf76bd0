// The answer in SQLite: tables hypothesis, mismatch, fitted_parameter and summary of the diagnosis' database.
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

}  // namespace cpt::diagnosis

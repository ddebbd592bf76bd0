// Another program in place of the embedded solver: what a study declares of it, as plain data. What runs it
// is campaign/external/.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace cpt::solver {

/// One number that the program takes.
struct ProgramInput {
  std::string name;  ///< letters, digits, _ and -; unique
  std::string unit = "-", meaning = {};
  double usual = 0.0;  ///< its value where a study does not say
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  bool integer = false;
  friend bool operator==(const ProgramInput&, const ProgramInput&) = default;
};

/// What the program gives: a scalar, or a curve over an abscissa.
struct ProgramOutput {
  std::string name;  ///< letters, digits, _ and -; unique, other than those of abscissas
  std::string unit = "-", meaning = {};
  std::string over = {}, over_unit = {};  ///< the abscissa; empty of a scalar
  [[nodiscard]] bool is_curve() const { return !over.empty(); }
  friend bool operator==(const ProgramOutput&, const ProgramOutput&) = default;
};

/// How long and how often one realization of it may run; changes no result.
struct ProgramLimits {
  double hang_seconds = std::numeric_limits<double>::infinity();  ///< without a byte written
  double most_bytes = 64.0e6;                                     ///< of its work folder, all files together
  int retries = 0;                                                ///< after a crash
  bool keep_work = false;                                         ///< the work folder of completed ones, too
};

struct ExternalProgram {
  std::vector<std::string> command;  ///< at least one word, as the study has them
  std::string folder;                ///< absolute, the study's: where files that the command names lie
  std::string version;               ///< of the program; another one invalidates stored results
  std::string template_name, template_text;  ///< with {{input}} in it; empty: none
  std::string results;                       ///< file in the work folder; empty: standard output
  std::vector<ProgramInput> inputs;
  std::vector<ProgramOutput> outputs;
  ProgramLimits limits;
};

}  // namespace cpt::solver

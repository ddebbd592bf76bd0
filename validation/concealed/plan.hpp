// What a concealed benchmark asks for: a study, soundings, and how many cases of which kind.
#pragma once

#include "diagnosis/read_request.hpp"

namespace cpt::validation::concealed {

/// Cases by what is left out of the simulation that they are diagnosed against.
struct Counts {
  int nothing = 0;        ///< the study's parameters only
  int single = 0;         ///< one mechanism of the catalogue
  int pair = 0;           ///< two of them
  int outside = 0;        ///< an effect that is not in the catalogue
  int two_soundings = 0;  ///< of all these, so many have the second sounding too
  [[nodiscard]] int total() const { return nothing + single + pair + outside; }
};

struct Plan {
  /// The request that every case makes, without recordings: study, soundings (one or two, with what is known
  /// of each), mechanisms, noise. `simulated` is true.
  diagnosis::Request request;
  Counts cases;
  std::filesystem::path cases_folder;   ///< NAME-cases: requests, recordings, seals, answers
  std::filesystem::path sealed_folder;  ///< NAME-sealed: what only `reveal` opens
};

using PlanOrErrors = std::variant<Plan, std::vector<parameters::StudyError>>;

/// Reads a plan: a request without recordings (see parse_request), whose [noise] gives measurement_percent,
/// and a section [cases]; or all that is wrong with it.
[[nodiscard]] PlanOrErrors parse_plan(std::string_view toml, const std::filesystem::path& file,
                                      const parameters::Study& study);

}  // namespace cpt::validation::concealed

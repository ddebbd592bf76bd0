// Sensitivity indices of one window against the groups of parameters that the paper names.
#pragma once

#include <string>
#include <vector>

#include "validation/paper/published.hpp"
#include "validation/paper/studies.hpp"

namespace cpt::validation::paper {

/// Indices are compared by size, without sign.
struct RankingComparison {
  int pairs = 0;                          ///< of parameters from different groups, both with an index
  int in_order = 0;                       ///< of these, where the earlier group's index is the larger one
  std::vector<std::string> out_of_order;  ///< Markdown: "λ (0.04) over R (0.03)"
  int levels = 0;                         ///< parameters with an index and a noise floor
  int at_level = 0;                       ///< of these, on the side of SI_noise that the paper puts them on
  std::vector<std::string> off_level;     ///< Markdown: "ν (0.02)"
  std::string missing;                    ///< what is known of parameters without an index; may be empty
};

[[nodiscard]] RankingComparison compare(const StudyView& study, const Ranking& ranking);

/// Number of a parameter's group and the paper's words for it, "2: less significant"; empty if it is in none.
[[nodiscard]] std::string group_of(const Ranking& ranking, std::string_view parameter);

}  // namespace cpt::validation::paper

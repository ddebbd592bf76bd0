// Sensitivity indices of one window against the groups of parameters that the paper names.
#pragma once

#include <string>
#include <vector>

#include "reports/paper/published.hpp"
#include "reports/paper/studies.hpp"

namespace cpt::reports::paper {

/// Indices are compared by size, without sign.
struct RankingComparison {
  int pairs = 0;                          ///< of parameters from different groups, both with an index
  int in_order = 0;                       ///< of these, where the earlier group's index is the larger one
  std::vector<std::string> out_of_order;  ///< Markdown: "λ (0.04) over R (0.03)"
  int levels = 0;                         ///< parameters with an index and a noise floor
  int at_level = 0;                       ///< of these, on the side of SI_noise that the paper puts them on
  std::vector<std::string> off_level;     ///< Markdown: "ν (0.02)"
  std::vector<std::string> missing;       ///< why parameters have no index; each reason once
  std::string ours;                       ///< Markdown: parameters by size of SI, largest first
};

[[nodiscard]] RankingComparison compare(const StudyView& study, const Ranking& ranking);

/// Markdown: "H > Dᵣ, χ > λ".
[[nodiscard]] std::string in_words(const StudyView& study, const Ranking& ranking);

/// The paper's words for a parameter; empty if it names none.
[[nodiscard]] std::string_view words_for(const Ranking& ranking, std::string_view parameter);

}  // namespace cpt::reports::paper

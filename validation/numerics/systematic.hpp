// The systematic part of the numerical uncertainty: what finer cells, more material points and less inertia
// do to tip resistance and sleeve friction together, beside what chance does.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "validation/numerics/study.hpp"

namespace cpt::validation::numerics {

/// Changes of a channel's average in a window from the baseline's setting to the most accurate one that has
/// run [-]; none where there is no such run. Differences of two runs: each holds the scatter of one of them,
/// too.
struct SystematicError {
  std::optional<double> cell_size, points, inertia;
  double together = 0.0;         ///< [-] root of the sum of squares
  std::optional<double> chance;  ///< [-] 95 % half width of one more run; none with fewer than three repeats
};

/// nullopt where none of the three settings has run.
[[nodiscard]] std::optional<SystematicError> systematic_error(const NumericsStudy& study,
                                                              std::string_view window,
                                                              std::size_t channel = tip_resistance);

/// Markdown: a line for every window of the studies and required channel, and what they say in a sentence
/// each; empty if there is none.
[[nodiscard]] std::string systematic_section(const std::vector<NumericsStudy>& studies);

}  // namespace cpt::validation::numerics

// The sensitivity indices of the paper's studies as Markdown tables.
#pragma once

#include <optional>
#include <string>

#include "validation/paper/studies.hpp"

namespace cpt::validation::paper {

/// The 95 % interval of an SI.
struct IndexInterval {
  double half_width;  ///< [-]
  bool from_repeats;  ///< else by batch means along the curves
};

/// From the repeats of the baseline where there are some, as everywhere else
/// (results/statistics/repeat_noise.hpp). Else from the noise of the two runs' own curves
/// (results/statistics/window_noise.hpp), which a layered soil has not: no stretch of its curve has a trend
/// that noise could be told from. nullopt where neither gives it.
[[nodiscard]] std::optional<IndexInterval> index_interval(const results::Snapshot& campaign,
                                                          std::string_view window,
                                                          std::string_view parameter);

/// One table a study and window, largest |SI| first, with the paper's group of each parameter. The indices of
/// `beside` have a column of their own.
[[nodiscard]] std::string index_tables(const Studies& studies, const Studies* beside = nullptr);

}  // namespace cpt::validation::paper

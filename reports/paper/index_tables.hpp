// The sensitivity indices of the paper's studies as Markdown tables.
#pragma once

#include <optional>
#include <string>

#include "reports/paper/studies.hpp"

namespace cpt::reports::paper {

/// Half width of the 95 % interval of SI, from the noise of the two runs' own curves
/// (results/window_noise.hpp). nullopt in layered soil, where no stretch of the curve has a trend that noise
/// could be told from, and where the windows or the runs do not give it.
[[nodiscard]] std::optional<double> index_interval(const results::Snapshot& campaign, std::string_view window,
                                                   std::string_view parameter);

/// One table a study and window, largest |SI| first, with the paper's group of each parameter. The indices of
/// `beside` have a column of their own.
[[nodiscard]] std::string index_tables(const Studies& studies, const Studies* beside = nullptr);

}  // namespace cpt::reports::paper

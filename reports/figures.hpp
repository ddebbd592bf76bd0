// The figures of a report, each a complete SVG document for a file or a page; nullopt where its results are
// not there yet.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drawing/column.hpp"
#include "reports/place.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/statistics/effects.hpp"
#include "solver/channels.hpp"

namespace cpt::reports {

/// Range of the average q_c in a window between each parameter's bounds, widest first, with the bounds'
/// values at the ends (Yost et al. 2023, Fig. 11).
[[nodiscard]] std::optional<std::string> tornado_figure(const results::Snapshot& campaign,
                                                        const results::WindowRow& window, Place place = {});

/// |SI| of every parameter in a window, largest first, against SI_noise (Fig. 12). Negative ones are marked,
/// undefined ones listed with their reason.
[[nodiscard]] std::optional<std::string> sensitivity_figure(const results::Snapshot& campaign,
                                                            const results::WindowRow& window,
                                                            Place place = {});

/// What the study's design says of every parameter (or pair) in a window, largest first: a bar with its 95 %
/// interval for mu*, the total-order index or the interaction, a circle for sigma or the first-order index.
/// The twenty largest where there are more.
[[nodiscard]] std::optional<std::string> effects_figure(const results::Snapshot& campaign,
                                                        const results::Effects& effects,
                                                        const results::WindowRow& window, Place place = {});
/// Of a design `propagation`: how the averages of its runs are distributed, with the quantiles' intervals.
/// Nothing with fewer than two runs.
[[nodiscard]] std::optional<std::string> propagation_figure(const results::Snapshot& campaign,
                                                            const results::Effects& effects,
                                                            const results::WindowRow& window,
                                                            Place place = {});
/// Of a design `propagation`: mean, 5 and 95 % quantile as the first runs alone have them, with their
/// intervals. Nothing with fewer than two numbers of runs.
[[nodiscard]] std::optional<std::string> propagation_convergence_figure(const results::Snapshot& campaign,
                                                                        const results::Effects& effects,
                                                                        const results::WindowRow& window,
                                                                        Place place = {});
/// Of a design `propagation`: a channel's median and mean over depth, with the bands that hold half and nine
/// tenths of the runs at each depth. Nothing where the channel was not recorded.
[[nodiscard]] std::optional<std::string> bands_figure(const results::Snapshot& campaign,
                                                      const results::Effects& effects,
                                                      const solver::Channel& channel, Place place = {});
/// How the numbers that effects_figure has as bars came about, for the six inputs with the largest: each with
/// its interval over the runs that it was estimated from (Effects::index_convergence). Nothing where there is
/// none, or one step alone.
[[nodiscard]] std::optional<std::string> index_convergence_figure(const results::Snapshot& campaign,
                                                                  const results::Effects& effects,
                                                                  const results::WindowRow& window,
                                                                  Place place = {});
/// What its bars and circles are, in a sentence.
[[nodiscard]] std::string effects_legend_words(std::string_view design);

/// q_c over depth of all realizations, the baseline and those furthest from it told apart (Fig. 10).
[[nodiscard]] std::optional<std::string> profiles_figure(
    const results::Snapshot& campaign, drawing::Column column = drawing::Column::one_and_half);

/// q_c over depth of the baseline with its windows enlarged (Fig. 9).
[[nodiscard]] std::optional<std::string> baseline_figure(
    const results::Snapshot& campaign, drawing::Column column = drawing::Column::one_and_half);

}  // namespace cpt::reports

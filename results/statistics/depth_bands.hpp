// How the channels of a push are distributed over depth where the study's inputs are: of a design
// propagation.
#pragma once

#include <vector>

#include "parameters/study.hpp"
#include "results/statistics/propagation_rows.hpp"
#include "results/statistics/stored_design.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {

/// Of the completed runs among these, which are a propagation's in its order, by channel and depth. The
/// depths are those of the run with the finest curve, every n-th of them so that there are at most
/// `most_depths`; other runs are interpolated between their bins, and count nowhere beyond them. Each depth
/// stands alone: a band is no bound of a whole curve.
[[nodiscard]] std::vector<DepthBandRow> depth_bands(const parameters::Study& study, const Snapshot& snapshot,
                                                    Runs runs, std::size_t most_depths);

/// The bands of the stored design, at no more than 500 depths; empty unless it is a propagation.
[[nodiscard]] std::vector<DepthBandRow> design_bands(const StoredDesign& design, const Snapshot& snapshot);

}  // namespace cpt::results

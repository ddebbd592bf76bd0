// An index read where each run has its own peak or trough, beside the window that the baseline places.
#pragma once

#include <optional>
#include <string_view>

#include "results/ledger/snapshot.hpp"

namespace cpt::validation::paper {

/// SI of a parameter between averages about the extremes of the runs at its two bounds.
struct OwnExtremes {
  double si;                  // [-]
  double at_lower, at_upper;  // [m] depths of the extremes
};

/// An interval as wide as the window's about the largest (peak) or least (trough) q_c of each run between the
/// depths where the window seeks the baseline's. Nothing of a fixed window, or where a run has not completed
/// or has no such extreme.
[[nodiscard]] std::optional<OwnExtremes> own_extremes(const results::Snapshot& campaign,
                                                      const results::WindowRow& window,
                                                      std::string_view parameter);

}  // namespace cpt::validation::paper

// What is said beside figures and tables: remarks, times, and texts that are broken and not cut.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results/ledger/snapshot.hpp"

namespace cpt::reports {

/// Text broken into lines no wider than the room [pt]: at blanks, and inside words that are wider themselves.
/// Nothing is left out.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, double font_size, double room,
                                               bool bold = false);

/// A time of the ledger to the second, as the page has it: "2026-11-29T18:20:33Z".
[[nodiscard]] std::string moment(std::string_view time);

/// What a reader must know of a window's averages: that they hold the start of the push. "" where nothing.
[[nodiscard]] std::string window_remark(const results::Snapshot& campaign, const results::WindowRow& window);

/// Whether an input has no index only because its runs, or the baseline, are still to come.
[[nodiscard]] bool to_come(const results::Snapshot& campaign, const results::SensitivityRow& row);

/// An input with the averages at its bounds, its index and what must be known of it; a line each.
[[nodiscard]] std::string input_words(const results::Snapshot& campaign, const results::WindowRow& window,
                                      const results::SensitivityRow& row);

}  // namespace cpt::reports

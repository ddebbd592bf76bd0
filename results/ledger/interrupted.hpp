// Realizations that ran when their campaign ended: nobody runs them now, and the next start takes them up
// again.
#pragma once

#include <string_view>

#include "results/ledger/snapshot.hpp"

namespace cpt::results {

/// The reason that read_snapshot of a file gives such a realization, which is pending; the ledger itself
/// still says "running" until the next start.
inline constexpr std::string_view was_interrupted = "was running when the campaign ended";

/// Nobody runs this campaign: what is marked as running was running when it ended.
void tell_interrupted(Snapshot& snapshot);

[[nodiscard]] inline bool interrupted(const RealizationRow& row) {
  return row.waiting() && row.reason == was_interrupted;
}

/// The row's status for people: "interrupted" in place of "pending" for these.
[[nodiscard]] inline std::string_view status_words(const RealizationRow& row) {
  return interrupted(row) ? std::string_view("interrupted") : std::string_view(row.status);
}

}  // namespace cpt::results

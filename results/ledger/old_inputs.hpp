// The inputs of realizations as ledgers before schema version 6, and imported ones, have them: in texts.
#pragma once

#include <vector>

#include "results/ledger/snapshot.hpp"

namespace cpt::results {

/// What each quantity that varies is in each realization, read from `value_text` and the baseline's setup. By
/// realization, then quantity.
[[nodiscard]] std::vector<InputRow> inputs_of_texts(const Snapshot& snapshot);

}  // namespace cpt::results

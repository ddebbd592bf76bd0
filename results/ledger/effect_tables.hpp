// What a study's design says, as tables: for the ledger, whose readers need no estimator, and for files.
#pragma once

#include "results/ledger/row_table.hpp"
#include "results/statistics/effects.hpp"

namespace cpt::results {

[[nodiscard]] const RowTable<EffectRow>& effect_table();
[[nodiscard]] const RowTable<DepthBandRow>& depth_band_table();

/// In place of what the ledger has of them. Within a transaction of the caller.
void write_effects(const Database& database, const Effects& effects);

}  // namespace cpt::results

// The numbers behind a report as tables, and all of them as one JSON document.
#pragma once

#include <string>

#include "results/ledger/snapshot.hpp"
#include "results/statistics/effects.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::reports {

[[nodiscard]] results::Table sensitivity_table(const results::Snapshot& campaign);
[[nodiscard]] results::Table realization_table(const results::Snapshot& campaign);
[[nodiscard]] results::Table window_mean_table(const results::Snapshot& campaign);
/// One line a depth bin: realization, depth_m and all channels in kPa; of an external program's campaign
/// results::output_rows().
[[nodiscard]] results::Table curve_table(const results::Snapshot& campaign);

/// Of columns: the ledger's, or those of named_for_outputs().
enum class Names { stored, shown };

/// campaign, imports, parameters, windows, realizations, window_means, repeat_noise, sensitivity and effects
/// with the name of the design, of an external program's campaign also its outputs; curves are in curves.csv.
[[nodiscard]] std::string report_json(const results::Snapshot& campaign, const results::Effects& effects = {},
                                      Names names = Names::stored);

}  // namespace cpt::reports

// A campaign as one flat table, as statistics programs want it: a row a realization, a column a number.
#pragma once

#include <string>

#include "results/ledger/snapshot.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::results {

/// `realization`, `name` ("baseline", "sand.H lower", a point's own), `status`, `reason`; every input that is
/// not the same in all realizations, in its study unit, a choice as text; then for each window NAME
/// `NAME.q_c_mean_kPa`, `NAME.q_c_min_kPa` and `NAME.q_c_max_kPa`, empty where there is no average.
[[nodiscard]] Table samples_table(const Snapshot& campaign);

/// The same in Dakota's annotated tabular format: `%eval_id interface`, inputs, averages of q_c; NaN for what
/// a failed realization does not have. Realizations that have not ended are left out. Format: Dakota
/// reference manual, keyword `annotated`.
[[nodiscard]] std::string dakota_table(const Snapshot& campaign);

}  // namespace cpt::results

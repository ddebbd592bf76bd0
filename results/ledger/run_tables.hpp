// Where a ledger holds runs. Used in this folder alone.
#pragma once

#include <optional>
#include <string_view>

#include "results/ledger/snapshot.hpp"

namespace cpt::results {

/// Names of the tables.
struct RunTables {
  const char *run, *curve, *checksum;
};
inline constexpr RunTables in_use_tables{"realization", "curve", "checksum"};  ///< what the study asks for
/// Finished runs whose settings the study no longer has, or that another solver version made.
inline constexpr RunTables unused_tables{"unused", "unused_curve", "unused_checksum"};

/// Columns of both tables of runs, after the id.
inline constexpr std::string_view run_columns =
    "parameter, side, value, value_text, status, reason, wall_s, steps, material_points, settings_hash, "
    "solver_version, started, finished, mass_error, momentum_error, energy_error, kinetic_fraction, "
    "max_empty_cells, min_time_step_s, max_time_step_s";

/// A run with its curve; nothing if there is no such id.
[[nodiscard]] std::optional<StoredRun> read_run(const Database& database, int id, const RunTables& tables);

}  // namespace cpt::results

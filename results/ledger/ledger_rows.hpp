// The ledger's single writes, each within a transaction of the caller. Used in this folder
// alone.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "parameters/realization.hpp"
#include "parameters/study.hpp"
#include "results/files/database.hpp"
#include "results/ledger/run_tables.hpp"
#include "solver/simulate.hpp"

namespace cpt::results {

/// "fixed", "peak", "trough" or "scalar", as stored.
[[nodiscard]] std::string_view kind_name(parameters::Window::Kind kind);

/// SHA-256 of what a run ended with: settings, status, reason, audit and curve, by their exact bytes.
[[nodiscard]] std::string outcome_checksum(const Database& database, std::int64_t id,
                                           const RunTables& tables = in_use_tables);
/// Whether what is stored of an ended run is what was recorded; nullopt where it was stored without a
/// checksum, by an earlier program.
[[nodiscard]] std::optional<bool> matches_checksum(const Database& database, std::int64_t id,
                                                   const RunTables& tables = in_use_tables);

/// What identifies a realization in the ledger.
struct RealizationInput {
  std::string parameter;  ///< empty for the baseline
  std::string side;
  double value;  ///< NaN for the baseline
  std::string value_text;
  std::string settings_hash, solver_version;
};
[[nodiscard]] RealizationInput describe_input(const parameters::Study& study,
                                              const parameters::Realization& realization);

void insert_pending(const Database& database, int id, const RealizationInput& input);
/// Moves the stored realization `old_id` to `new_id` with its curve and window means.
void rename_realization(const Database& database, std::int64_t old_id, int new_id,
                        const RealizationInput& input);
/// Back to pending: drops status, audit and curve.
void clear_outcome(const Database& database, int id);
/// Throws std::logic_error unless the realization is pending or running.
void require_waiting(const Database& database, int id);

/// Fails as damaged where the channels of a curve that was read differ in length.
void check_curve(const Database& database, const CurveRow& curve);
/// Replaces what is stored of each realization's inputs: every quantity that the study varies anywhere.
void write_inputs(const Database& database, const parameters::Study& study,
                  std::span<const parameters::Realization> realizations);

/// Replaces campaign, layers, parameters and windows by the study's.
void write_study(const Database& database, const parameters::Study& study, const std::string& study_text);

/// Status, reason, audit and curve of an ended realization.
void write_outcome(const Database& database, int id, const solver::Outcome& outcome);

[[nodiscard]] solver::DepthProfile read_profile(const Database& database, std::int64_t id,
                                                const RunTables& tables = in_use_tables);
/// Averages of one completed realization in all windows that are resolved.
void write_window_means(const Database& database, int id, const solver::DepthProfile& profile);
/// Resolves the windows on the baseline's curve and averages every completed realization's. A function of the
/// stored curves alone, so the order in which realizations finish does not show.
void recompute_windows(const Database& database, const parameters::Study& study);
/// The scatter of the baseline and its completed repeats in each window; no row with fewer than three. A
/// function of the window means alone.
void recompute_repeat_noise(const Database& database);

}  // namespace cpt::results

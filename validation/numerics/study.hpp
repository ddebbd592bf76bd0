// A campaign read as a study of the numerics: which realizations change one numerical setting alone, and
// which are repeats.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "results/ledger/snapshot.hpp"
#include "results/statistics/repeat_noise.hpp"
#include "solver/quantities.hpp"

namespace cpt::validation::numerics {

struct Run {
  double value;  ///< of the setting, in its study unit
  int realization;
};

/// A numerical setting that realizations change and nothing else.
struct Setting {
  const solver::Quantity* quantity;
  double baseline;        ///< in its study unit
  std::vector<Run> runs;  ///< by value; the baseline and every realization of this setting, completed or not
};

struct NumericsStudy {
  results::Snapshot campaign;
  std::vector<Setting> settings;  ///< in the order of the list of quantities, the speed last
  /// The baseline and those that differ from it in numerics.point_shift alone; the baseline only if none do.
  std::vector<int> repeats;
};

/// The cell size against the baseline's: 1 / numerics.refinement.
inline constexpr std::string_view refinement = "numerics.refinement";

/// Settings are the quantities of the group `numerics` and the speed of the push. Realizations that change
/// several, or others, are not looked at. Throws results::Error if the database cannot be read.
[[nodiscard]] NumericsStudy read_numerics(const std::filesystem::path& database);
/// The same of what was read from there.
[[nodiscard]] NumericsStudy read_numerics(results::Snapshot campaign, const std::filesystem::path& database);

/// nullptr if there is none.
[[nodiscard]] const results::RealizationRow* run_row(const results::Snapshot& campaign, int realization);
/// Of solver::channels(): what is averaged in a window, q_c unless said otherwise.
inline constexpr std::size_t tip_resistance = 0;

/// Average of a channel [kPa] of a completed realization in a window; nullopt where it was not recorded.
[[nodiscard]] std::optional<double> mean_in(const results::Snapshot& campaign, int realization,
                                            std::string_view window, std::size_t channel = tip_resistance);
/// SI_noise of a completed realization in a window.
[[nodiscard]] std::optional<double> noise_in(const results::Snapshot& campaign, int realization,
                                             std::string_view window);
/// Of the average [kPa]; nullopt with fewer than three completed repeats.
[[nodiscard]] std::optional<results::RepeatNoise> repeats_in(const NumericsStudy& study,
                                                             std::string_view window,
                                                             std::size_t channel = tip_resistance);
/// What changes are told against [kPa]: the mean of the repeats, without them the baseline.
[[nodiscard]] std::optional<double> reference_in(const NumericsStudy& study, std::string_view window,
                                                 std::size_t channel = tip_resistance);

/// Whether an average lies further from the reference than repeats scatter, and than numbers are rounded.
[[nodiscard]] bool told_from_repeats(double q_c, double reference,
                                     const std::optional<results::RepeatNoise>& repeats);

/// The setting's completed run with the most accurate value: the finest mesh, the most points, the smallest
/// time step, inertia or speed.
[[nodiscard]] std::optional<Run> most_accurate(const results::Snapshot& campaign, const Setting& setting);

}  // namespace cpt::validation::numerics

// A campaign's database as plain data, read in one consistent read-only transaction.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/files/error.hpp"
#include "solver/channels.hpp"
#include "solver/simulate.hpp"

namespace cpt::results {

class Database;

/// Row of `campaign`.
struct CampaignRow {
  std::string name, title, profile, preset;
  std::string study_text;      ///< the study file as written
  std::string baseline_setup;  ///< every input of the baseline, one "name = value" line each
  std::string program_version, solver_version;
  std::string created;     ///< UTC, ISO 8601
  std::string curve_file;  ///< file name of the HDF5 mirror
  int one = 1;             ///< there is one row
};

/// Row of `layer`.
struct LayerRow {
  double top_m, bottom_m;
  std::string soil;  ///< its name
  int position = 0;  ///< from the top, 1 first
};

/// Row of `parameter`; numbers in the study's unit, an index for a choice, whose names are the texts.
struct ParameterRow {
  std::string name, symbol, unit, meaning;
  double baseline, lower, upper;
  std::string baseline_text, lower_text, upper_text;
  int position = 0;  ///< in the study, 1 first
};

/// Row of `realization`. Numbers that are not known yet are NaN or 0.
struct RealizationRow {
  int id = 0;
  std::string parameter;  ///< empty for the baseline
  std::string side;       ///< "baseline", "lower", "upper", "point" or "repeat"
  double value;           ///< study unit; NaN for the baseline
  std::string value_text;
  std::string status;  ///< "pending", "running", "not_needed" or a solver::Status name
  std::string reason;
  double wall_s;
  std::int64_t steps = 0, material_points = 0;
  std::string settings_hash, solver_version, started, finished;
  solver::Audit audit;
  std::int64_t former_study = 0;  ///< of an unused run: the study that it belonged to
  std::string out_of_line;  ///< of a snapshot: what its audit has out of line (view `audit`); else empty
  [[nodiscard]] bool waiting() const { return status == "pending" || status == "running"; }
  [[nodiscard]] bool completed() const { return status == "completed"; }
  /// Left out by a design that had enough runs.
  [[nodiscard]] bool not_needed() const { return status == "not_needed"; }
  [[nodiscard]] bool ended() const { return !waiting() && !not_needed(); }
  [[nodiscard]] bool failed() const { return ended() && !completed(); }
};

/// Row of `depth_window`; from and to are NaN until they can be resolved.
struct WindowRow {
  std::string name, kind;
  double from_m, to_m;
  std::string problem;  ///< why the window is not resolved; empty if it is
  int position = 0;     ///< in the study, 1 first
  double search_from_m, search_to_m;
  double width_m;           ///< NaN of a fixed window
  std::string output = {};  ///< of an external program: which of its outputs; else empty
  std::string output_unit = {};
  /// What its numbers are, wherever a name or a unit says kPa or q_c: all that shows them asks here.
  [[nodiscard]] std::string quantity() const { return output.empty() ? "q_c" : output; }
  [[nodiscard]] std::string unit() const { return output.empty() ? "kPa" : output_unit; }
  [[nodiscard]] bool is_scalar() const { return kind == "scalar"; }
};

/// Row of `program_output`: what an external program gives.
struct OutputRow {
  std::string name, unit, meaning;
  std::string over, over_unit;  ///< abscissa of a curve; empty of a scalar
  int position = 0;             ///< in the study, 1 first
};

/// Row of `realization_input`: what a quantity that the study varies is in a realization.
struct InputRow {
  int realization = 0;
  std::string quantity;
  double value;            ///< study unit; of a choice the index of the alternative
  std::string value_text;  ///< of a choice its name
};

/// Row of `window_mean`. Of an imported average the least and the largest q_c may be NaN, and of a scalar
/// they are. Of an external program's output all three are in its unit.
struct WindowMeanRow {
  int realization = 0;
  std::string window;
  double from_m, to_m, q_c_mean_kPa, q_c_min_kPa, q_c_max_kPa;
  int bins = 0;  ///< 0 of an imported average
  /// Of the channels behind q_c in their order (solver/channels.hpp); NaN where one was not recorded.
  std::array<double, solver::channel_count - 1> other_means_kPa;
};

/// Row of `repeat_noise`: the baseline and its repeats.
struct RepeatNoiseRow {
  std::string window;
  int runs = 0;
  double q_c_mean_kPa, q_c_deviation_kPa;
  double si_half_width;  ///< [-] of the 95 % interval of an SI whose two averages are alike
};

/// Row of the view `sensitivity`. NaN where undefined; the note says why.
struct SensitivityRow {
  std::string window, parameter;
  double q_lower_kPa, q_upper_kPa, q_baseline_kPa;
  double si, si_abs, si_noise;
  std::optional<bool> above_noise;  ///< of the repeats; without them above SI_noise
  double si_half_width;             ///< of the 95 % interval that the repeats give; NaN without repeats
  std::optional<bool> above_repeats;
  std::optional<bool> above_si_noise;  ///< the paper's definition
  int pairs =
      0;  ///< of runs at both bounds whose indices give the interval; 0: that of the baseline's repeats
  std::string note;
};

/// Curve of one realization, as far as it came.
struct CurveRow {
  int realization = 0;
  solver::DepthProfile profile;
};

/// Row of `import`: a file that results were imported from.
struct ImportRow {
  std::string file, sha256;
  std::string imported;  ///< when; UTC, ISO 8601
  std::string program_version;
  int position = 0;
};

struct Snapshot {
  CampaignRow campaign;
  std::vector<LayerRow> layers;
  std::vector<ParameterRow> parameters;      ///< in the study's order
  std::vector<RealizationRow> realizations;  ///< by id
  std::vector<InputRow> inputs;              ///< by realization
  std::vector<WindowRow> windows;            ///< in the study's order
  std::vector<WindowMeanRow> window_means;
  std::vector<RepeatNoiseRow> repeat_noise;
  std::vector<SensitivityRow> sensitivity;  ///< by window, then parameter, in the study's order
  std::vector<CurveRow> curves;             ///< by realization
  std::vector<OutputRow> outputs;           ///< empty where the embedded solver runs
  std::vector<ImportRow> imports;           ///< empty where the results are this program's own runs
  /// Whether an external program made the results: there is no push, no soil and no profile over depth.
  [[nodiscard]] bool is_external() const { return !outputs.empty(); }
};

/// Reads everything; throws Error if the file is missing or not a ledger of this schema.
[[nodiscard]] Snapshot read_snapshot(const std::filesystem::path& database);
/// The same within a transaction of the caller.
[[nodiscard]] Snapshot read_snapshot(const Database& database);

/// One realization's row and curve; nullopt if there is no such id. Throws as read_snapshot.
struct StoredRun {
  RealizationRow row;
  std::optional<solver::DepthProfile> profile;
};
[[nodiscard]] std::optional<StoredRun> read_run(const std::filesystem::path& database, int id);
[[nodiscard]] std::optional<StoredRun> read_run(const Database& database, int id);

}  // namespace cpt::results

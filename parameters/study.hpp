// A study: what the researcher wrote, validated. Plain data; read_study.hpp makes it from TOML.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parameters/distributions/distribution.hpp"
#include "solver/channels.hpp"
#include "solver/presets.hpp"
#include "solver/quantities.hpp"
#include "solver/setup.hpp"

namespace cpt::parameters {

/// One row of the table of uncertain inputs. Values are in the quantity's study unit (index for a choice).
struct Row {
  const solver::Quantity* quantity;
  double baseline;
  double lower;                                        ///< equal to baseline where one-sided
  double upper;                                        ///< equal to baseline where one-sided
  std::shared_ptr<const Marginal> marginal = nullptr;  ///< how it is distributed; none: within its bounds
  /// The seed of a random field, or the shift of the material points: without bounds, and drawn by designs
  /// that sample.
  [[nodiscard]] bool only_drawn() const { return marginal != nullptr && lower == upper; }
};

/// Spearman's rank correlation of two rows, indices into Study::rows.
struct RankCorrelation {
  std::size_t first, second;
  double rho;  ///< above -1 and below 1
};

/// A value for a quantity, in its study unit.
struct Change {
  const solver::Quantity* quantity;
  double value;
};

/// A realization beside those of the rows: several inputs changed at once, or the baseline repeated with
/// shifted material points.
struct DesignPoint {
  std::string name;  ///< unique in the study; letters, digits, _ - . and spaces
  std::vector<Change> changes;
  bool repeat = false;
};

/// When a design that grows by itself has enough runs: the 95 % interval's half width of a number of every
/// window's average is at most this share of the number.
struct StopRule {
  double quantile = std::numeric_limits<double>::quiet_NaN();  ///< the number; NaN: the mean
  double half_width = 0.0;                                     ///< [-] above 0
  bool operator==(const StopRule&) const = default;
};

/// What the section [design] adds to the one-at-a-time runs; its runs are made by designs/design.hpp.
struct Design {
  std::string kind = "one_at_a_time";  ///< one of design_kinds()
  std::vector<std::size_t> rows;       ///< that vary together: indices into Study::rows
  int runs = 0;                        ///< latin_hypercube: runs; sobol: rows of the samples A and B
  int first_runs = 0;      ///< latin_hypercube: runs that it had before it grew; 0: it did not grow
  int sections = 1;        ///< sobol: samples of random shifts of their own that its rows are dealt to
  std::string estimator;   ///< of the kind's estimators (designs/kind.hpp); empty where it has one alone
  int trajectories = 0;    ///< morris
  int levels = 0;          ///< morris: of its grid, even
  std::uint64_t seed = 1;  ///< of its points and of its bootstrap
  bool latin = false;      ///< propagation: sections of Latin hypercubes, not of Sobol' points
  std::optional<StopRule> until = {};  ///< propagation: `runs` are the most
  /// Propagation: standard deviation of a numerical error of each channel relative to its value, in the
  /// order of solver/channels.hpp.
  std::array<double, solver::channel_count> numerical_error = {};
  std::size_t first_point = 0;  ///< of its own among Study::points
  std::size_t points = 0;       ///< its own; fewer than its runs where the study has some of them already
};

/// Depth interval over which q_c is averaged; of an external program a scalar that it gives, or an interval
/// of the abscissa over which a curve is averaged.
struct Window {
  enum class Kind { fixed, peak, trough, scalar };
  std::string name;
  Kind kind = Kind::fixed;
  double from = 0.0;   // [m] fixed: interval; peak/trough: where to look for it in the baseline's profile
  double to = 0.0;     // [m]
  double width = 0.0;  // [m] peak/trough: width of the interval centred on it
  std::vector<double> thresholds = {};  // [Pa] average q_c whose exceedance is asked for, rising
  std::string output = {};              ///< declared output; empty: q_c
};

struct Study {
  std::filesystem::path file;  ///< absolute path of the study file
  std::string name;            ///< file name without extension
  std::string title;           ///< for reports; defaults to the name
  solver::Profile profile;     ///< of the embedded solver
  solver::Preset preset;       ///< of the embedded solver
  solver::Setup baseline;      ///< preset + fixed inputs + every row's baseline
  std::vector<Row> rows;       ///< in file order
  /// In file order, then the design's, then the repeats, then the bounds of rows with the repeats' shifts.
  std::vector<DesignPoint> points;
  Design design;
  std::vector<RankCorrelation> correlations;  ///< of rows of the design; the others are independent
  std::vector<Window> windows;                ///< at least one
  std::filesystem::path database;             ///< default NAME.sqlite beside the study
  std::filesystem::path curves;               ///< default NAME.h5
  std::filesystem::path report_dir;           ///< default NAME-report
  double wall_limit_seconds;                  ///< of one realization; infinity if not given
  /// Prints the version of the external program, which is then to be put into the baseline; empty: told.
  std::vector<std::string> version_command = {};
};

}  // namespace cpt::parameters

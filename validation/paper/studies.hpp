// The campaigns of one folder that reproduce the paper, by the names of their studies.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results/ledger/snapshot.hpp"

namespace cpt::validation::paper {

/// The studies of examples/paper, in the order in which they are told.
inline constexpr std::string_view sand_study = "homogeneous_sand";
inline constexpr std::string_view clay_study = "homogeneous_clay";
inline constexpr std::string_view layered_study = "layered";
inline constexpr std::string_view flexible_study = "sand_flexible";
inline constexpr std::string_view dense_rigid_study = "dense_rigid";
inline constexpr std::string_view dense_flexible_study = "dense_flexible";
inline constexpr std::string_view second_push_study = "second_push";
inline constexpr std::string_view image_pressure_study = "image_pressure";
inline constexpr std::string_view at_rest_study = "at_rest";
inline constexpr std::string_view at_rest_flexible_study = "at_rest_flexible";
[[nodiscard]] std::vector<std::string_view> study_names();

/// Inputs of the studies that findings and figures speak of.
namespace inputs {
inline constexpr std::string_view hardening = "sand.H";
inline constexpr std::string_view density = "sand.D_r_percent";
inline constexpr std::string_view radius = "chamber.radius_m";
inline constexpr std::string_view sigma_h0 = "initial.sigma_h0_kPa";
}  // namespace inputs

/// Snapshots by study name; a study that has not been run has none.
using Studies = std::map<std::string, results::Snapshot, std::less<>>;

/// Reads FOLDER/NAME.sqlite of every study that is there. Throws results::Error if one cannot be read, or if
/// the folder holds none.
[[nodiscard]] Studies read_studies(const std::filesystem::path& folder);

/// The presets they were run at: "paper", "paper and quick".
[[nodiscard]] std::string presets_of(const Studies& studies);

/// A number of a study, or why there is none.
struct Value {
  double number;  // NaN if there is none
  std::string
      missing;  ///< "dense_rigid has not been run", "homogeneous_sand: baseline run pending"; else empty
  explicit operator bool() const { return missing.empty(); }
};
[[nodiscard]] Value missing_value(std::string why);

enum class Bound { baseline, lower, upper };

/// One study's answers; all of them may be missing.
class StudyView {
 public:
  StudyView(const Studies& studies, std::string_view name);

  [[nodiscard]] const results::Snapshot* snapshot() const { return snapshot_; }
  /// Average q_c [kPa] in a window at a parameter's bound; `parameter` does not matter for the baseline.
  [[nodiscard]] Value q_c(std::string_view window, std::string_view parameter, Bound bound) const;
  [[nodiscard]] Value baseline(std::string_view window) const { return q_c(window, {}, Bound::baseline); }
  /// SI of a parameter in a window, with its sign.
  [[nodiscard]] Value index(std::string_view window, std::string_view parameter) const;
  [[nodiscard]] Value noise(std::string_view window) const;
  /// Row of the view `sensitivity`; nullptr if there is none.
  [[nodiscard]] const results::SensitivityRow* row(std::string_view window, std::string_view parameter) const;
  [[nodiscard]] const results::WindowRow* window(std::string_view name) const;
  /// Row of the study's table; nullptr if there is none.
  [[nodiscard]] const results::ParameterRow* parameter(std::string_view name) const;
  /// Markdown: a parameter's symbol.
  [[nodiscard]] std::string symbol(std::string_view parameter) const;

 private:
  [[nodiscard]] Value missing(std::string why) const;
  std::string name_;
  const results::Snapshot* snapshot_;
};

}  // namespace cpt::validation::paper

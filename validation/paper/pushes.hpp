// The pushes that `campaign push` recorded of the dense sand: stress paths, wall stresses and void ratios.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "results/push/histories.hpp"
#include "validation/paper/studies.hpp"

namespace cpt::validation::paper {

/// A recorded push, or why there is none.
struct Push {
  std::optional<results::Histories> histories;
  std::string missing;  ///< empty if there are histories
};

/// Sand of D_R = 60 % under 100 kPa behind either wall, from an initial horizontal stress of 50 and of 90
/// kPa: baseline and upper bound of dense_rigid and dense_flexible.
struct Pushes {
  Push rigid, rigid_90, flexible, flexible_90;
};

/// Reads FOLDER/NAME-push/NAME-histories.h5, where NAME is the study's, followed by -ID but for the baseline.
/// A push counts only if it is complete and has the settings of its realization in the study's database.
[[nodiscard]] Pushes read_pushes(const std::filesystem::path& folder, const Studies& studies);

/// Everything of one folder that is held against the paper.
struct Runs {
  Studies studies;
  Pushes pushes;
};

/// read_studies and read_pushes.
[[nodiscard]] Runs read_runs(const std::filesystem::path& folder);

}  // namespace cpt::validation::paper

// The points that an emulator is asked about.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "results/emulator/emulator.hpp"

namespace cpt::cli {

struct PredictionPoints {
  std::vector<std::string> names;
  Eigen::MatrixXd values;  ///< points x inputs, in study units
};

/// One point: the baseline with NAME=VALUE settings. Throws BadInput with name, value and range.
[[nodiscard]] PredictionPoints point_of(const results::Emulator& emulator,
                                        const std::vector<std::string>& settings);

/// A point a row; columns are inputs, what has none keeps the setting or the baseline; `name` names points.
/// Throws BadInput with line, column, value and range of all that is wrong, up to 20.
[[nodiscard]] PredictionPoints points_of(const results::Emulator& emulator,
                                         const std::vector<std::string>& settings,
                                         const std::filesystem::path& table);

}  // namespace cpt::cli

// What a joint fit of NorSand to laboratory tests says, as tables and as lines of a study.
#pragma once

#include <string>

#include "parameters/calibration/joint_fit.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::cli {

/// The triaxial tests' ends: which reach critical state, and how near the others come.
[[nodiscard]] results::Table ends_table(const calibration::JointFit& fit);
/// A row a parameter: given, by hand, fitted, its interval; with the correlations of those that are told.
[[nodiscard]] results::Table parameters_table(const calibration::JointFit& fit);
[[nodiscard]] results::Table correlation_table(const calibration::JointFit& fit);
/// A row a channel: scatter and what of it goes together.
[[nodiscard]] results::Table channels_table(const calibration::JointFit& fit);
/// A row a test: how far it lies from the fit.
[[nodiscard]] results::Table misfit_table(const calibration::LaboratoryTests& tests,
                                          const calibration::JointFit& fit);

/// In sentences: what is not told and what to think of the intervals.
[[nodiscard]] std::string verdict(const calibration::JointFit& fit);

/// Rows of [parameters] with distributions and their [correlation], to paste in a study: normal, or lognormal
/// where the logarithm is fitted. Rank correlations from Pearson's of a normal law.
[[nodiscard]] std::string study_lines(const calibration::JointFit& fit);

}  // namespace cpt::cli

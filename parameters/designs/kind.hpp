// What a kind of design says of itself. A new one is two files here, its entry in the list of design.cpp, and
// what its runs tell: a file in results/statistics/designs/ with its line in results/statistics/effects.cpp.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "parameters/study.hpp"

namespace cpt::parameters {

/// A whole number of the section [design], and what is taken where the study says nothing.
struct DesignKey {
  std::string_view name;
  double usual;
  double usual_a_row = 0.0;  ///< on top for each row that varies
};

struct DesignKind {
  std::string_view name;                          ///< as in a study
  std::vector<DesignKey> keys = {};               ///< that it knows, beside `parameters`
  std::vector<std::string_view> estimators = {};  ///< to choose from, the usual one first; empty: it has one
  std::size_t least_rows = 1;                     ///< that must vary
  std::size_t usual_rows = std::numeric_limits<std::size_t>::max();  ///< at most, where the study names none
  /// A place is a probability: a row with a distribution takes its quantile there. Else places lie between
  /// the bounds.
  bool samples = false;
  /// Its rows may be correlated; its numbers do not take them for independent.
  bool dependent = false;
  /// Draws the seeds of random fields and the shift of material points; else every run has the baseline's.
  bool draws_fields = false;
  /// Knows the keys `sampling` and `until`.
  bool propagates = false;
  /// Runs that it asks for, before any is made.
  long (*run_count)(const Design& design) = nullptr;
  /// Runs x Design::rows in the unit cube; NaN: left at its baseline. No function: it changes nothing
  /// together.
  Eigen::MatrixXd (*places)(const Design& design) = nullptr;
  /// "morris 3.2"; unique in the design.
  std::string (*run_name)(const Design& design, Eigen::Index run) = nullptr;
};

/// How many vary.
[[nodiscard]] inline int width_of(const Design& design) { return static_cast<int>(design.rows.size()); }
/// "pairs 3.2": the second run of the third group of `size`.
[[nodiscard]] std::string name_in_group(std::string_view kind, Eigen::Index run, Eigen::Index size);

}  // namespace cpt::parameters

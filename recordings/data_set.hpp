// Several soundings of one place, to be explained together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recordings/recording.hpp"

namespace cpt::recordings {

/// A recording with what is known of the ground it was pushed into.
struct Sounding {
  Recording recording;
  double sigma_v0 = not_given;  // [Pa] vertical stress at the top of the readings, compression-positive; >= 0
  double sigma_h0 = not_given;  // [Pa] horizontal stress there; >= 0
  std::optional<double> D_r;    // [-] relative density, 0 to 1.2; nothing where unknown
  double x = 0.0, y = 0.0;      // [m] position in the data set's own axes
  int push_order = 1;  ///< from 1, in the order of time; equal for pushes that do not disturb another
};

struct DataSet {
  std::string title;
  std::vector<Sounding> soundings;
};

/// Everything that is wrong with a data set, one sentence each with the sounding, the value and its valid
/// range; empty if nothing is.
[[nodiscard]] std::vector<std::string> problems(const DataSet& set);

}  // namespace cpt::recordings

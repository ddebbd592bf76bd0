// Values of a row by normal scores, fast and for several threads.
#pragma once

#include <vector>

#include "parameters/study.hpp"

namespace cpt::parameters {

/// Where a standard normal number is not exceeded.
[[nodiscard]] double probability_of_score(double score);
/// The other way; 1e-12 inside of 0 and 1.
[[nodiscard]] double score_of_probability(double probability);

/// A row's value_of_probability at equally spaced normal scores from -6 to 6, linear between; of a row that
/// takes some values only the nearest. OpenTURNS, which knows the quantiles, is slow, and none to be asked by
/// several threads.
class ValueOfScore {
 public:
  explicit ValueOfScore(const Row& row);
  [[nodiscard]] double operator()(double score) const;

 private:
  std::vector<double> values_;
  bool steps_ = false;
};

}  // namespace cpt::parameters

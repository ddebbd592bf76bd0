// How good the answers to a benchmark are, once its truths are known.
#pragma once

#include <utility>
#include <vector>

#include "diagnosis/depth_grid.hpp"

namespace cpt::validation::concealed {

/// One case. Labels are 0 ... labels - 1 in the order of the probabilities: the mechanisms, "nothing is
/// missing" and "none of these".
struct ScoredCase {
  int truth;
  diagnosis::VectorXd probabilities;  ///< labels; sums to 1
  int answer;                         ///< not always the most probable: a gate may have overruled it
  std::vector<int> set;               ///< labels that may be the truth, for coverage
};

/// A proportion with its exact interval (Clopper and Pearson 1934).
struct Proportion {
  int count, of;
  double value;  ///< NaN of nothing
  double lower, upper;
};

/// Throws std::invalid_argument unless 0 <= count <= of and confidence is in (0, 1).
[[nodiscard]] Proportion proportion(int count, int of, double confidence = 0.95);

/// Cases by truth (row) and answer (column).
[[nodiscard]] Eigen::MatrixXi confusion_matrix(const std::vector<ScoredCase>& cases, int labels);

/// Cases whose answer is the truth.
[[nodiscard]] Proportion accuracy(const std::vector<ScoredCase>& cases);

/// Cases whose truth is among the k most probable; ties go to the lower label.
[[nodiscard]] Proportion top(const std::vector<ScoredCase>& cases, int k);

/// Mean of sum_k (p_k - [k is the truth])^2, in [0, 2] (Brier 1950).
[[nodiscard]] double brier_score(const std::vector<ScoredCase>& cases);

/// Mean ln p of the truth, p no less than 1e-12.
[[nodiscard]] double log_score(const std::vector<ScoredCase>& cases);

struct SetScore {
  Proportion coverage;
  double size;  ///< mean
};
[[nodiscard]] SetScore set_score(const std::vector<ScoredCase>& cases);

/// For one label, such as "none of these": of the answers with it, how many are right; of the truths with it,
/// how many are found.
struct Retrieval {
  Proportion precision, recall;
};
[[nodiscard]] Retrieval retrieval(const std::vector<ScoredCase>& cases, int label);

/// Intersection over union of two unions of depth intervals [m]; 1 if both are empty.
using Intervals = std::vector<std::pair<double, double>>;
[[nodiscard]] double overlap(const Intervals& a, const Intervals& b);

/// The answers by the probability claimed for them.
struct ReliabilityBin {
  double from, to;  // of the claimed probability
  double claimed;   // mean; NaN of none
  Proportion correct;
};
[[nodiscard]] std::vector<ReliabilityBin> reliability(const std::vector<ScoredCase>& cases, int bins = 5);

}  // namespace cpt::validation::concealed

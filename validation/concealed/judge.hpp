// One case of a benchmark, opened: the truth, the answer, and how the two compare.
#pragma once

#include "diagnosis/answer_store.hpp"
#include "diagnosis/assemble.hpp"
#include "validation/concealed/baselines.hpp"
#include "validation/concealed/scoring.hpp"
#include "validation/concealed/truth.hpp"

namespace cpt::validation::concealed {

/// A parameter of the true mechanism and what was said of it.
struct ParameterCheck {
  diagnosis::FittedParameter fitted;
  double truth;  // [study unit]
  [[nodiscard]] bool covered() const { return fitted.lower <= truth && truth <= fitted.upper; }
};

struct Judged {
  std::string benchmark;  ///< name of the plan
  Truth truth;
  diagnosis::StoredAnswer answer;
  std::string label;  ///< the right answer: a mechanism, "a + b", "nothing is missing" or "none of these"
  double strength;    ///< [standard deviations] of the true effect out of the null; 0 of nothing
  double overlap;     ///< of the depths found with those of the true effect; NaN of nothing
  std::vector<ParameterCheck> parameters;  ///< where the answer is the one true mechanism
  // What simpler methods say.
  std::string bic, best_rmse;
  double bic_nothing;  ///< weight of "nothing is missing" by BIC
  double discrepancy;  ///< P(something is missing) of null against discrepancy alone, evens beforehand
  [[nodiscard]] bool right() const;       ///< a pair's answer is right if it names one of the two
  [[nodiscard]] bool pair_right() const;  ///< the best pair offered is the true one
  [[nodiscard]] bool alarm() const { return answer.answer != diagnosis::nothing_is_missing; }
  [[nodiscard]] double probability_of(const std::string& name) const;
};

/// `assembled` is the case's problem, the same that was diagnosed. Depths of the true effect are the cells
/// where it is at least half its greatest.
[[nodiscard]] Judged judge(const std::string& benchmark, const Truth& truth,
                           const diagnosis::StoredAnswer& answer, const diagnosis::Assembled& assembled);

}  // namespace cpt::validation::concealed

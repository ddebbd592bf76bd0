// What may explain a recording, how probable each explanation is, and which of them is the answer.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "diagnosis/predictive_check.hpp"

namespace cpt::diagnosis {

/// Names of the explanations that are no mechanism.
inline constexpr const char* nothing_is_missing = "nothing is missing";
inline constexpr const char* none_of_these = "none of these";

/// One of the problem's mechanisms, or that nothing is missing, or something unknown.
class Explanation {
 public:
  /// A mechanism by its place in the problem.
  Explanation(std::size_t mechanism) : what_(What::mechanism), mechanism_(mechanism) {}
  [[nodiscard]] static Explanation nothing() { return Explanation(What::nothing); }
  [[nodiscard]] static Explanation unknown() { return Explanation(What::unknown); }

  [[nodiscard]] bool is_mechanism() const { return what_ == What::mechanism; }
  [[nodiscard]] bool is_nothing() const { return what_ == What::nothing; }
  [[nodiscard]] bool is_unknown() const { return what_ == What::unknown; }
  /// Its place in the problem. Throws std::logic_error where it is no mechanism.
  [[nodiscard]] std::size_t mechanism() const {
    if (!is_mechanism()) throw std::logic_error("the explanation is no mechanism");
    return mechanism_;
  }
  bool operator==(const Explanation&) const = default;

 private:
  enum class What { mechanism, nothing, unknown };
  explicit Explanation(What what) : what_(what) {}

  What what_;
  std::size_t mechanism_ = 0;
};

/// An explanation, weighed.
struct Hypothesis {
  Explanation explanation;
  std::string name;  ///< of the mechanism; or nothing_is_missing, none_of_these
  double prior, log_evidence, probability;
};

struct Verdict {
  std::vector<Hypothesis> hypotheses;           ///< the mechanisms in the problem's order, nothing, unknown
  Explanation winner = Explanation::unknown();  ///< before the gate
  std::optional<PredictiveCheck> gate;          ///< of the winner, unless that is unknown
  Explanation answer = Explanation::unknown();  ///< after the gate
  /// What the recording does not tell apart, and `Options::credible`; the most probable first.
  std::vector<Explanation> set;

  /// Throws std::out_of_range where it was not weighed.
  [[nodiscard]] const Hypothesis& of(Explanation explanation) const;
  [[nodiscard]] bool gate_failed() const { return answer != winner; }
  [[nodiscard]] bool in_set(Explanation explanation) const;
  [[nodiscard]] std::vector<std::size_t> mechanisms_in_set() const;
  /// All that was weighed; and the mechanisms among them.
  [[nodiscard]] std::vector<Explanation> by_probability() const;
  [[nodiscard]] std::vector<std::size_t> mechanisms_by_probability() const;
};

}  // namespace cpt::diagnosis

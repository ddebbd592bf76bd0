#include "diagnosis/verdict.hpp"

#include <algorithm>
#include <functional>

namespace cpt::diagnosis {
namespace {

std::vector<std::size_t> mechanisms_of(const std::vector<Explanation>& explanations) {
  std::vector<std::size_t> mechanisms;
  for (const Explanation& explanation : explanations)
    if (explanation.is_mechanism()) mechanisms.push_back(explanation.mechanism());
  return mechanisms;
}

}  // namespace

const Hypothesis& Verdict::of(Explanation explanation) const {
  const auto found = std::ranges::find(hypotheses, explanation, &Hypothesis::explanation);
  if (found == hypotheses.end()) throw std::out_of_range("an explanation that was not weighed");
  return *found;
}

bool Verdict::in_set(Explanation explanation) const {
  return std::ranges::find(set, explanation) != set.end();
}

std::vector<std::size_t> Verdict::mechanisms_in_set() const { return mechanisms_of(set); }

std::vector<Explanation> Verdict::by_probability() const {
  std::vector<Hypothesis> sorted = hypotheses;
  std::ranges::stable_sort(sorted, std::ranges::greater(), &Hypothesis::probability);
  std::vector<Explanation> explanations;
  for (const Hypothesis& hypothesis : sorted) explanations.push_back(hypothesis.explanation);
  return explanations;
}

std::vector<std::size_t> Verdict::mechanisms_by_probability() const {
  return mechanisms_of(by_probability());
}

}  // namespace cpt::diagnosis

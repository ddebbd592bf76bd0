#include "validation/concealed/scores.hpp"

#include <algorithm>
#include <functional>

namespace cpt::validation::concealed {
namespace {

std::vector<std::string> truths_of(const Judged& judged) {
  if (judged.truth.parts.size() < 2) return {judged.label};
  std::vector<std::string> names;
  for (const auto& part : judged.truth.parts) names.emplace_back(part.mechanism.name);
  return names;
}

}  // namespace

Labelled labelled(const std::vector<Benchmark>& benchmarks, const Cases& cases) {
  Labelled result;
  for (const Benchmark& benchmark : benchmarks)
    for (const std::string& name : benchmark.mechanisms)
      if (std::ranges::find(result.labels, name) == result.labels.end()) result.labels.push_back(name);
  result.labels.emplace_back(diagnosis::nothing_is_missing);
  result.labels.emplace_back(diagnosis::none_of_these);
  const auto label = [&](const std::string& name) {
    return static_cast<int>(std::ranges::find(result.labels, name) - result.labels.begin());
  };
  for (const Judged* judged : cases) {
    ScoredCase scored{};
    scored.probabilities.setZero(static_cast<Eigen::Index>(result.labels.size()));
    for (const auto& hypothesis : judged->answer.hypotheses)
      scored.probabilities(label(hypothesis.name)) = hypothesis.probability;
    const std::vector<std::string> truths = truths_of(*judged);
    scored.truth = label(*std::ranges::max_element(
        truths, {}, [&](const std::string& name) { return judged->probability_of(name); }));
    scored.answer = label(judged->answer.answer);
    for (const auto& hypothesis : judged->answer.hypotheses)
      if (hypothesis.in_set) scored.set.push_back(label(hypothesis.name));
    result.cases.push_back(std::move(scored));
  }
  return result;
}

bool among_first(const Judged& judged, int k) {
  auto hypotheses = judged.answer.hypotheses;
  std::ranges::stable_sort(hypotheses, std::greater{}, &diagnosis::StoredAnswer::Weighed::probability);
  hypotheses.resize(std::min(hypotheses.size(), static_cast<std::size_t>(k)));
  const std::vector<std::string> truths = truths_of(judged);
  return std::ranges::any_of(hypotheses, [&](const diagnosis::StoredAnswer::Weighed& hypothesis) {
    return std::ranges::find(truths, hypothesis.name) != truths.end();
  });
}

}  // namespace cpt::validation::concealed

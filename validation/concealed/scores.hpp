// The numbers of a concealed benchmark's page.
#pragma once

#include <map>

#include "validation/concealed/page.hpp"

namespace cpt::validation::concealed {

using Cases = std::vector<const Judged*>;

/// All cases of all benchmarks; those that `wanted` accepts.
template <class Wanted>
Cases select(const std::vector<Benchmark>& benchmarks, const Wanted& wanted) {
  Cases cases;
  for (const Benchmark& benchmark : benchmarks)
    for (const Judged& judged : benchmark.cases)
      if (wanted(judged)) cases.push_back(&judged);
  return cases;
}

/// Share of the cases for which `is` holds.
template <class Is>
Proportion share(const Cases& cases, const Is& is) {
  int count = 0;
  for (const Judged* judged : cases) count += is(*judged) ? 1 : 0;
  return proportion(count, static_cast<int>(cases.size()));
}

/// Cases as the scoring functions want them: labels are the names of all mechanisms of all benchmarks, then
/// "nothing is missing" and "none of these". A pair's label is the more probable of its two.
struct Labelled {
  std::vector<std::string> labels;
  std::vector<ScoredCase> cases;
};
[[nodiscard]] Labelled labelled(const std::vector<Benchmark>& benchmarks, const Cases& cases);

/// The mechanism is among the k most probable hypotheses; for a pair one of the two.
[[nodiscard]] bool among_first(const Judged& judged, int k);

}  // namespace cpt::validation::concealed

// The two figures of the page.
#pragma once

#include <string>

#include "validation/concealed/page.hpp"

namespace cpt::validation::concealed {

/// Share of the cases with one mechanism that are named rightly, and among the first three, by strength, with
/// 95 % intervals.
[[nodiscard]] std::string strength_figure(const std::vector<Benchmark>& benchmarks);

/// How often an answer is right against the probability claimed for it.
[[nodiscard]] std::string reliability_figure(const std::vector<Benchmark>& benchmarks);

/// Bounds of the strengths that cases are grouped by [standard deviations]; the last is open.
inline constexpr double strength_bounds[] = {0.0, 1.5, 3.0, 4.5, 6.0, 9.0};

}  // namespace cpt::validation::concealed

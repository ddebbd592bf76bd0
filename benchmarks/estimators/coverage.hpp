#pragma once

namespace cpt::benchmarks {

/// A row for each number of each estimator: how often its interval holds the truth.
void print_coverage(int repetitions);

}  // namespace cpt::benchmarks

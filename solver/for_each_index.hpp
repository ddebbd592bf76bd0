// A loop over nodes or cells, shared out to threads; each index writes only what is its own.
#pragma once

#include <cstdint>

namespace cpt::solver {

template <typename Function>
void for_each_index(std::int32_t count, int threads, const Function& function) {
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (std::int32_t i = 0; i < count; ++i) function(i);
}

}  // namespace cpt::solver

// Independent pieces of work on several threads.
#pragma once

#include <functional>

#include "diagnosis/depth_grid.hpp"

namespace cpt::diagnosis {

/// Does `work(0)` to `work(count - 1)`, each once and in no order, on up to `threads` threads (0: one a
/// core). What one of them throws ends the others after the piece they are at and is thrown again.
void in_parallel(Index count, int threads, const std::function<void(Index)>& work);

}  // namespace cpt::diagnosis

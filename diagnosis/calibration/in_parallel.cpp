#include "diagnosis/calibration/in_parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace cpt::diagnosis {

void in_parallel(Index count, int threads, const std::function<void(Index)>& work) {
  std::atomic<Index> next = 0;
  std::mutex mutex;  // of the failure
  std::exception_ptr failure;
  const auto take = [&] {
    try {
      for (Index i = next++; i < count; i = next++) work(i);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      failure = std::current_exception();
      next = count;
    }
  };
  {
    const auto cores = static_cast<Index>(std::max(1U, std::thread::hardware_concurrency()));
    const Index most = std::min(count, threads > 0 ? Index{threads} : cores);
    std::vector<std::jthread> others;
    for (Index k = 1; k < most; ++k) others.emplace_back(take);
    take();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace cpt::diagnosis

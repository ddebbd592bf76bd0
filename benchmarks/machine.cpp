#include "benchmarks/machine.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

namespace cpt::benchmarks {
namespace {

constexpr int repeats = 5;

/// Shortest wall time [s] of `work(thread)` on all threads at once.
double shortest(int threads, const std::function<void(int)>& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    {
      std::vector<std::jthread> running;
      for (int t = 0; t < threads; ++t) running.emplace_back(work, t);
    }
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

// Eight independent chains: enough to hide the latency of two units.
using Vector = double __attribute__((vector_size(64)));
constexpr int chains = 8;
constexpr long rounds = 20'000'000;

#if defined(__x86_64__)
__attribute__((target_clones("avx512f", "fma", "default")))
#endif
double
multiply_adds() {
  Vector a{}, b{};
  for (int l = 0; l < 8; ++l) a[l] = 0.5, b[l] = 0.5 + 0.1 * l;
  benchmark::DoNotOptimize(a);
  benchmark::DoNotOptimize(b);
  // Different starts, or the compiler makes one chain of all.
  Vector x0 = b, x1 = b + 1, x2 = b + 2, x3 = b + 3, x4 = b + 4, x5 = b + 5, x6 = b + 6, x7 = b + 7;
  for (long i = 0; i < rounds; ++i) {
    x0 = x0 * a + b, x1 = x1 * a + b, x2 = x2 * a + b, x3 = x3 * a + b;
    x4 = x4 * a + b, x5 = x5 * a + b, x6 = x6 * a + b, x7 = x7 * a + b;
  }
  const Vector sum = ((x0 + x1) + (x2 + x3)) + ((x4 + x5) + (x6 + x7));
  return sum[0] + sum[7];
}

}  // namespace

double triad_bandwidth(int threads) {
  constexpr std::size_t elements = 40'000'000;  // 320 MB an array
  const std::size_t share = elements / static_cast<std::size_t>(threads);
  std::vector<std::unique_ptr<double[]>> arrays;
  for (int i = 0; i < 3; ++i) arrays.push_back(std::make_unique<double[]>(elements));
  double* const a = arrays[0].get();
  const double *const b = arrays[1].get(), *const c = arrays[2].get();
  const double seconds = shortest(threads, [&](int t) {
    const std::size_t first = share * static_cast<std::size_t>(t);
    for (std::size_t i = first; i < first + share; ++i) a[i] = b[i] + 3.0 * c[i];
    benchmark::ClobberMemory();
  });
  return 24.0 * static_cast<double>(share) * threads / seconds;
}

double peak_flops(int threads) {
  const double seconds = shortest(threads, [](int) {
    double result = multiply_adds();
    benchmark::DoNotOptimize(result);
  });
  return 2.0 * 8.0 * chains * static_cast<double>(rounds) * threads / seconds;
}

}  // namespace cpt::benchmarks

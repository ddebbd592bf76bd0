// Cost of the stress updates [ns per material point] in states like those of a push.
//
// NorSand: `elastic` stays inside the yield surface; `plastic` yields at every point with the strain
// increment of the argument, in units of 1e-7; `mixed` is a push's mixture: 70 % elastic at 1e-6, 25 %
// plastic at 1e-5, 5 % at 2e-4, in runs of eight alike. The state is restored before each update, outside the
// time measured per point.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <random>

#include "solver/constitutive/linear_elastic.hpp"
#include "solver/constitutive/norsand.hpp"
#include "solver/constitutive/tresca.hpp"

namespace {

using namespace cpt::solver;

constexpr std::size_t field_count = 10, state_count = 6, points = 1024;

class Points {
 public:
  Points()
      : data_(static_cast<double*>(
                  std::aligned_alloc(64, (field_count + state_count) * points * sizeof(double))),
              &std::free) {}
  double* field(std::size_t i) { return data_.get() + i * points; }
  void keep() { std::memcpy(field(field_count), field(0), state_count * points * sizeof(double)); }
  void restore() { std::memcpy(field(0), field(field_count), state_count * points * sizeof(double)); }
  Batch view() {
    return {points,   field(0), field(1), field(2), field(3), field(4),
            field(5), field(6), field(7), field(8), field(9)};
  }

 private:
  std::unique_ptr<double[], decltype(&std::free)> data_;
};

struct Kind {
  double overconsolidation;  // of p_i: well above 1 is elastic
  double strain;             // [-]
};

template <typename KindOf>
void fill(Points& batch, const NorSand& law, const KindOf& kind_of) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (std::size_t k = 0; k < points; ++k) {
    const Kind kind = kind_of(k);
    const double p = 1e5 * std::pow(10.0, 0.7 * uniform(generator)), e = 0.75 + 0.05 * uniform(generator);
    const double a = p * (0.4 + 0.2 * uniform(generator)), b = 0.2 * p * uniform(generator);
    const double s_rr = -p + 0.5 * a + b, s_zz = -p - a, s_tt = -p + 0.5 * a - b,
                 s_rz = 0.2 * p * uniform(generator);
    const double p_i = law.initial_image_pressure(s_rr, s_zz, s_tt, s_rz, e) * kind.overconsolidation;
    const double d = kind.strain;
    const double values[field_count] = {s_rr,
                                        s_zz,
                                        s_tt,
                                        s_rz,
                                        e,
                                        p_i,
                                        d * (0.4 + 0.3 * uniform(generator)),
                                        -d,
                                        d * 0.3 * uniform(generator),
                                        d * 0.5 * uniform(generator)};
    for (std::size_t i = 0; i < field_count; ++i) batch.field(i)[k] = values[i];
  }
  batch.keep();
}

template <typename Law>
void run(benchmark::State& state, Points& batch, const Law& law) {
  for (auto _ : state) {
    batch.restore();
    benchmark::DoNotOptimize(law.update(batch.view()));
  }
  state.counters["ns/point"] =
      benchmark::Counter(static_cast<double>(points) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

NorSandParameters sand_without_cap() {
  NorSandParameters sand;
  sand.cap_ratio = 10.0;
  return sand;
}

void norsand_elastic(benchmark::State& state) {
  const NorSand law(sand_without_cap());
  Points batch;
  fill(batch, law, [](std::size_t) { return Kind{1.6, 1e-6}; });
  run(state, batch, law);
}
BENCHMARK(norsand_elastic);

void norsand_plastic(benchmark::State& state) {
  const NorSand law{NorSandParameters{}};
  const double strain = 1e-7 * static_cast<double>(state.range(0));
  Points batch;
  fill(batch, law, [&](std::size_t) { return Kind{1.0, strain}; });
  run(state, batch, law);
}
BENCHMARK(norsand_plastic)->Arg(10)->Arg(100)->Arg(1000)->Arg(10000);

void norsand_mixed(benchmark::State& state) {
  const NorSand law(sand_without_cap());
  Points batch;
  fill(batch, law, [](std::size_t k) {
    const std::size_t group = k / 8 % 20;
    return group < 14 ? Kind{1.6, 1e-6} : group < 19 ? Kind{1.0, 1e-5} : Kind{1.0, 2e-4};
  });
  run(state, batch, law);
}
BENCHMARK(norsand_mixed);

void tresca(benchmark::State& state) {
  const Tresca law{TrescaParameters{}};
  Points batch;
  fill(batch, NorSand{NorSandParameters{}}, [](std::size_t k) {
    return Kind{1.0, k % 2 == 0 ? 1e-6 : 1e-2};
  });
  run(state, batch, law);
}
BENCHMARK(tresca);

void linear_elastic(benchmark::State& state) {
  const LinearElastic law(1e6, 0.3);
  Points batch;
  fill(batch, NorSand{NorSandParameters{}}, [](std::size_t) { return Kind{1.0, 1e-6}; });
  run(state, batch, law);
}
BENCHMARK(linear_elastic);

}  // namespace

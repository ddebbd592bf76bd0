// Logarithm and exponential of packs against the standard library in long double.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "tests/solver/constitutive/pack_math_probe.hpp"

namespace cpt::solver {
namespace {

using Probe = void (*)(const double*, double*, double*);

std::vector<Probe> probes() {
  std::vector<Probe> list = {probe_baseline};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) list.push_back(probe_avx2);
  if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw"))
    list.push_back(probe_avx512);
#endif
  return list;
}

// Error in units of the last place of the exact value.
double ulps(double value, long double exact) {
  const double rounded = static_cast<double>(exact);
  const double ulp =
      std::nextafter(std::abs(rounded), std::numeric_limits<double>::infinity()) - std::abs(rounded);
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact)) / ulp;
}

TEST(PackMath, WithinTwoUlps) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> power(-300.0, 300.0), near_one(0.5, 2.0), argument(-650.0, 650.0),
      small(-1.0, 1.0);
  alignas(64) double x[8], logarithm[8], exponential[8];
  for (const Probe probe : probes()) {
    double worst_log = 0.0, worst_exp = 0.0;
    for (int i = 0; i < 20000; ++i) {
      for (int k = 0; k < 8; ++k) x[k] = k % 2 == 0 ? std::pow(10.0, power(generator)) : near_one(generator);
      probe(x, logarithm, exponential);
      for (int k = 0; k < 8; ++k)
        worst_log = std::max(worst_log, ulps(logarithm[k], std::log(static_cast<long double>(x[k]))));
      for (int k = 0; k < 8; ++k) x[k] = k % 2 == 0 ? argument(generator) : small(generator);
      probe(x, logarithm, exponential);
      for (int k = 0; k < 8; ++k)
        worst_exp = std::max(worst_exp, ulps(exponential[k], std::exp(static_cast<long double>(x[k]))));
    }
    EXPECT_LT(worst_log, 2.0);
    EXPECT_LT(worst_exp, 2.0);
  }
}

TEST(PackMath, ExactAtOneAndZero) {
  for (const Probe probe : probes()) {
    alignas(64) double x[8] = {1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0}, logarithm[8], exponential[8];
    probe(x, logarithm, exponential);
    EXPECT_EQ(logarithm[0], 0.0);
    EXPECT_EQ(exponential[1], 1.0);
  }
}

TEST(PackMath, SaysWhereItIsUndefined) {
  constexpr double inf = std::numeric_limits<double>::infinity(),
                   nan = std::numeric_limits<double>::quiet_NaN();
  for (const Probe probe : probes()) {
    alignas(64) double x[8] = {0.0, -1.0, nan, inf, -inf, 2000.0, -2000.0, 1.0}, logarithm[8], exponential[8];
    probe(x, logarithm, exponential);
    for (int k = 0; k < 5; ++k) EXPECT_TRUE(std::isnan(logarithm[k])) << x[k];
    EXPECT_TRUE(std::isnan(exponential[2]));
    EXPECT_NEAR(std::log(exponential[5]), 700.0, 1e-12);  // limited, not overflowing
    EXPECT_NEAR(std::log(exponential[6]), -700.0, 1e-12);
    EXPECT_EQ(exponential[3], exponential[5]);
  }
}

}  // namespace
}  // namespace cpt::solver

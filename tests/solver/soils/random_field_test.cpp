#include "solver/soils/random_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/presets.hpp"
#include "solver/quantities.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::solver {
namespace {

RandomField field(double seed, double length = 0.05) { return {1.0, length, FieldKind::normal, seed}; }

// Over 4000 fields: variances and covariances scatter by sqrt(2 / 4000) = 0.022 at most.
TEST(RandomField, HasUnitVarianceAndTheMarkovCorrelation) {
  constexpr int fields = 4000;
  const double depths[] = {0.0, 0.013, 0.05, 0.1, 0.3};
  double sum[5] = {}, product[5][5] = {};
  for (int seed = 1; seed <= fields; ++seed) {
    double g[5];
    for (int k = 0; k < 5; ++k) g[k] = field(seed).score(depths[k]);
    for (int i = 0; i < 5; ++i) {
      sum[i] += g[i];
      for (int j = 0; j < 5; ++j) product[i][j] += g[i] * g[j];
    }
  }
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(sum[i] / fields, 0.0, 0.06);
    for (int j = 0; j < 5; ++j)
      EXPECT_NEAR(product[i][j] / fields, std::exp(-std::abs(depths[i] - depths[j]) / 0.05), 0.09) << i << j;
  }
}

// Vanmarcke (1983), eq. 5.1.14, of a mean over a length: the variance is less by 2 (d/L)^2 (L/d - 1 +
// exp(-L/d)).
TEST(RandomField, AveragesLikeAMarkovField) {
  constexpr int fields = 2000;
  const double length = 0.05, L = 0.2, ratio = length / L;
  double squares = 0.0;
  for (int seed = 1; seed <= fields; ++seed) {
    double mean = 0.0;
    for (int k = 0; k < 200; ++k) mean += field(seed, length).score(0.001 * k + 0.0005) / 200.0;
    squares += mean * mean;
  }
  const double expected = 2.0 * ratio * ratio * (1.0 / ratio - 1.0 + std::exp(-1.0 / ratio));
  EXPECT_NEAR(squares / fields / expected, 1.0, 0.12);
}

TEST(RandomField, IsTheSameWhateverElseIsAskedAndContinuous) {
  const RandomField one = field(7);
  const double alone = one.score(0.1234);
  for (int k = 0; k < 50; ++k) static_cast<void>(one.score(0.01 * k));
  EXPECT_EQ(one.score(0.1234), alone);
  EXPECT_NEAR(one.score(0.1234 + 1e-7), alone, 1e-4);
  EXPECT_NE(field(8).score(0.1234), alone);
}

TEST(RandomField, KeepsMeanAndDeviationOfTheParameter) {
  constexpr int fields = 4000;
  for (const FieldKind kind : {FieldKind::normal, FieldKind::lognormal}) {
    double sum = 0.0, squares = 0.0;
    for (int seed = 1; seed <= fields; ++seed) {
      const double x = RandomField{6.0, 0.05, kind, static_cast<double>(seed)}.at(20.0, 0.077);
      sum += x;
      squares += x * x;
    }
    const double mean = sum / fields;
    EXPECT_NEAR(mean, 20.0, 0.4);
    EXPECT_NEAR(std::sqrt(squares / fields - mean * mean), 6.0, 0.4);
  }
  EXPECT_EQ((RandomField{}).at(20.0, 0.1), 20.0);
}

// Off it leaves no trace in the settings; on, every part of it does.
TEST(RandomField, LeavesNoTraceWhereThereIsNone) {
  solver::Setup setup = make_setup(Profile::layered_sand_clay, Preset::quick);
  EXPECT_EQ(canonical_text(setup).find("field"), std::string::npos);
  find_quantity("clay.s_u_field_deviation_kPa")->set_value(setup, 4.0);
  EXPECT_NE(canonical_text(setup).find("clay.s_u_field_deviation_kPa = 4\n"), std::string::npos);
  const std::string first = canonical_text(setup);
  find_quantity("clay.s_u_field_seed")->set_value(setup, 2.0);
  EXPECT_NE(canonical_text(setup), first);
  EXPECT_TRUE(find_quantity("clay.s_u_field_seed")->integer);
}

}  // namespace
}  // namespace cpt::solver

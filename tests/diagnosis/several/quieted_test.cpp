#include "diagnosis/several/quieted.hpp"

#include <gtest/gtest.h>

#include "diagnosis/covariance.hpp"
#include "diagnosis/random.hpp"
#include "diagnosis/whitener.hpp"
#include "toy.hpp"

namespace cpt::diagnosis {
namespace {

struct Runs {
  std::vector<Cell> cells = toy::cells();
  VectorXd truth = toy::baseline(cells);
  VectorXd scatter;  // the baseline's own
  MatrixXd repeats = MatrixXd(60, 8);

  explicit Runs(std::uint64_t seed) {
    const Whitener noise(noise_covariance(cells, {Kernel::ar1, 0.01, 0.01}));
    const auto draw = [&](std::uint64_t stream) -> VectorXd {
      return noise.colour(Random(seed, stream).normals(60)).col(0);
    };
    scatter = draw(0);
    for (Index k = 0; k < 8; ++k) repeats.col(k) = truth + draw(static_cast<std::uint64_t>(k) + 1);
  }
  [[nodiscard]] Quieted quieted() const { return {cells, truth + scatter, repeats}; }
};

TEST(Quieted, TheBaselineIsTheMeanOfAllRuns) {
  const Runs runs(1);
  const Quieted quieted = runs.quieted();
  EXPECT_LT((quieted.baseline() - runs.truth).norm(), 0.5 * runs.scatter.norm());
  EXPECT_DOUBLE_EQ(quieted.share(), 1.0 / 9.0);
  EXPECT_LT((quieted(runs.truth + runs.scatter) - quieted.baseline()).norm(), 1e-12);
}

// A run that is soft on top and scatters as the baseline does loses that scatter; one that scatters by itself
// is left alone.
TEST(Quieted, TakesOffWhatARunSharesWithTheBaseline) {
  double twin = 0.0, other = 0.0, before = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Runs runs(seed);
    const Quieted quieted = runs.quieted();
    const VectorXd effect = toy::top_curve(runs.cells, 0.6, 0.5);
    twin += (quieted(runs.truth + effect + runs.scatter) - runs.truth - effect).squaredNorm();
    other += (quieted(runs.repeats.col(0) + effect) - runs.repeats.col(0) - effect).squaredNorm();
    before += runs.scatter.squaredNorm();
  }
  EXPECT_LT(twin, 0.25 * before);
  EXPECT_LT(other, 0.15 * before);
}

TEST(Quieted, OfTooFewRepeatsLeavesRunsAsTheyAre) {
  const Runs runs(2);
  const Quieted quieted(runs.cells, runs.truth + runs.scatter, runs.repeats.leftCols(2));
  EXPECT_EQ(quieted(runs.repeats.col(0)), runs.repeats.col(0));
  EXPECT_EQ(quieted.baseline(), runs.truth + runs.scatter);
  EXPECT_EQ(quieted.share(), 1.0);
}

}  // namespace
}  // namespace cpt::diagnosis

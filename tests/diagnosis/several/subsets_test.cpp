// Several effects at once, on curves whose truth is known: the toy sounding of toy.hpp.
#include "diagnosis/several/subsets.hpp"

#include <gtest/gtest.h>

#include "diagnosis/evidence.hpp"
#include "diagnosis/whitener.hpp"
#include "toy.hpp"

namespace cpt::diagnosis {
namespace {

const std::vector<Cell> cells = toy::cells();

enum : std::size_t { lens, top, drift, scaling };

std::vector<CurveEmulator> emulators() {
  return {CurveEmulator(toy::lens(cells, 24)), CurveEmulator(toy::top(cells, 16)),
          CurveEmulator(toy::drift(cells, 6)), CurveEmulator(toy::scaling(cells, 6))};
}

class Subsets : public testing::Test {
 protected:
  [[nodiscard]] Scatter scatter() const {
    return {{{null.sigma, 0.0}},
            MatrixXd::Zero(null.sigma.rows(), null.sigma.cols()),
            null.parameters.prior_factors()};
  }
  // Noise and soil drawn anew for each seed, with what the effects add.
  [[nodiscard]] VectorXd residual(const VectorXd& effect, std::uint64_t seed) const {
    return draw_null(null, 1, seed).col(0) + effect;
  }
  NullModel null = toy::null(cells);
  SubsetWeigher weigher{emulators(), null.sigma, metrics_of(cells, scatter(), {}), {}};
};

// One effect by nodes that are normals against Gauss-Legendre over its whole prior. They differ where the
// prior ends: normals have no edge.
TEST_F(Subsets, EvidenceOfOneEffectIsTheIntegralOverItsPrior) {
  const std::vector<CurveEmulator> all = emulators();
  const Whitener M(null.covariance);
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const double strength = 0.1 * static_cast<double>(seed);
    const std::vector<std::pair<std::size_t, VectorXd>> truths = {
        {lens, toy::lens_curve(cells, strength, 0.6)},
        {top, toy::top_curve(cells, strength, 0.4)},
        {drift, toy::drift_curve(cells, strength)}};
    for (const auto& [effect, curve] : truths) {
      const VectorXd r = residual(curve, seed);
      const Combinations combinations = weigher.at(0, std::array{effect});
      const double exact = mechanism_evidence(MechanismLikelihood(all[effect], M), r).log_evidence;
      const double nodes = combinations.log_evidence(combinations.target(r), std::array{effect});
      EXPECT_NEAR(nodes, exact, 0.7) << seed << " " << all[effect].name();
    }
  }
}

// Two effects' density at a combination against the normal density with the covariance written out.
TEST_F(Subsets, DensityOfACombinationIsTheNormalOne) {
  const VectorXd r = residual(toy::top_curve(cells, 0.5, 0.5), 3);
  const std::array<std::size_t, 2> both = {lens, top};
  for (const std::size_t m : {std::size_t{0}, std::size_t{5}}) {
    const Combination at{{weigher.fine()[lens].count() - 2, weigher.fine()[top].count() / 2, 0}, 0.0};
    const Metric& metric = weigher.metrics()[m];
    const MatrixXd unit = metric.whitening.inverse();
    MatrixXd covariance = unit * unit.transpose();
    VectorXd rest = r;
    for (std::size_t k = 0; k < both.size(); ++k) {
      const EffectNodes& nodes = weigher.fine()[both[k]];
      rest -= nodes.curves.col(at.node[k]);
      const MatrixXd& spread = nodes.spreads[static_cast<std::size_t>(at.node[k])];
      covariance += spread * spread.transpose();
    }
    const Combinations combinations = weigher.at(m, both);
    EXPECT_NEAR(combinations.log_density(combinations.target(r), both, at),
                Whitener(covariance).log_density(rest), 1e-6);
  }
}

TEST_F(Subsets, ProbabilitiesAddUpAndNothingIsFoundWhereNothingIs) {
  double nothing = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Explained found = weigher.explain(residual(VectorXd::Zero(60), seed));
    double sum = 0.0;
    for (const WeighedSubset& subset : found.subsets) sum += subset.probability;
    EXPECT_NEAR(sum, 1.0, 1e-9);
    nothing += found.nothing / 10.0;
    EXPECT_GT(found.nothing, 0.05) << seed;
  }
  EXPECT_GT(nothing, 0.35);
}

TEST_F(Subsets, FindsOneTwoAndThreeEffectsTogether) {
  const VectorXd a = toy::lens_curve(cells, 0.8, 0.4), b = toy::top_curve(cells, 0.8, 0.5),
                 c = toy::drift_curve(cells, 0.8);
  const auto best = [&](const VectorXd& effect) {
    return weigher.explain(residual(effect, 5)).subsets.front().subset;
  };
  EXPECT_TRUE(best(a) == (Subset{{lens}, false}));
  EXPECT_TRUE(best(b + c) == (Subset{{top, drift}, false}));
  EXPECT_TRUE(best(a + b + c) == (Subset{{lens, top, drift}, false}));
}

// A curve that no effect has, alone and beside one that has a name: the name stays found.
TEST_F(Subsets, SomethingElseStandsBesideTheEffects) {
  const VectorXd wave = toy::curve(cells, [](double z) { return 0.25 * std::sin(40.0 * z); });
  const Explained alone = weigher.explain(residual(wave, 5));
  EXPECT_GT(alone.something_else, 0.95);
  EXPECT_LT(alone.inclusion.maxCoeff(), 0.6);
  const Explained beside = weigher.explain(residual(wave + toy::drift_curve(cells, 1.0), 5));
  EXPECT_GT(beside.something_else, 0.95);
  EXPECT_GT(beside.inclusion(drift), 0.7);
}

// What the soil can do as well needs a reason to be called an effect.
TEST_F(Subsets, AnEffectThatTheSoilCanImitateStaysUndecided) {
  const Explained found = weigher.explain(residual(VectorXd::Constant(60, 0.06), 5));
  EXPECT_GT(found.inclusion(scaling), 0.02);
  EXPECT_LT(found.inclusion(scaling), 0.6);
}

}  // namespace
}  // namespace cpt::diagnosis

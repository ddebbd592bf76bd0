#include "diagnosis/diagnose.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

const NoiseModel measured{Kernel::ar1, 0.02, 0.03};
const NoiseModel numerical{Kernel::ar1, 0.015, 0.05};

VectorXd draw(const MatrixXd& covariance, std::uint64_t seed, std::uint64_t stream) {
  return Whitener(covariance).colour(Random(seed, stream).normals(covariance.rows()));
}

// Recording = soil within its bounds + measurement + what is missing; the analysis sees eight repeats of the
// baseline, which has a numerical scatter of its own.
Problem problem(std::uint64_t seed, const VectorXd& missing) {
  Problem p;
  p.cells = toy::cells();
  const MatrixXd scatter = noise_covariance(p.cells, numerical);
  const VectorXd own = draw(scatter, seed, 1);
  Random random(seed, 2);
  const Eigen::Vector2d theta(random.uniform(), random.uniform());
  p.recorded = ResponseSurface(toy::baseline(p.cells), toy::parameters(p.cells)).predict(theta) +
               draw(noise_covariance(p.cells, measured), seed, 3) + missing;
  p.baseline = toy::baseline(p.cells) + own;
  p.parameters = toy::parameters(p.cells);
  for (ParameterEffect& effect : p.parameters) {  // common random numbers
    effect.lower += own;
    effect.upper += own;
  }
  p.repeats.resize(60, 8);
  for (Index k = 0; k < 8; ++k)
    p.repeats.col(k) = toy::baseline(p.cells) + draw(scatter, seed, 10 + static_cast<std::uint64_t>(k));
  p.mechanisms = {toy::top(p.cells, 24), toy::lens(p.cells, 40), toy::drift(p.cells, 10),
                  toy::scaling(p.cells, 10)};
  p.measurement = measured;
  return p;
}

Options quick() {
  Options options;
  options.bootstraps = 500;
  options.sensitivity = false;
  return options;
}

std::string answer(const Diagnosis& d) { return d.verdict.of(d.verdict.answer).name; }

TEST(Diagnose, NamesWhatIsMissing) {
  const auto cells = toy::cells();
  int right = 0, proved = 0, located = 0;
  constexpr int each = 4;
  for (std::uint64_t seed = 0; seed < each; ++seed) {
    const std::vector<std::pair<std::string, VectorXd>> truths = {{"top", toy::top_curve(cells, 0.7, 0.4)},
                                                                  {"lens", toy::lens_curve(cells, 0.6, 0.63)},
                                                                  {"drift", toy::drift_curve(cells, 0.8)}};
    for (const auto& [name, missing] : truths) {
      const Diagnosis d = diagnose(problem(seed, missing), quick());
      right += answer(d) == name ? 1 : 0;
      proved += d.best->held_out->per_cell > 0.0 ? 1 : 0;
      EXPECT_LT(d.location.p, 0.05) << name;
      EXPECT_LT(d.with_best().rmse, d.null.recalibrated.rmse) << name;
      if (name != "lens") continue;
      EXPECT_NEAR(d.mechanisms[1].evidence.mean(1), 0.63, 0.1);
      EXPECT_NEAR(d.mechanisms[1].evidence.mean(0), 0.6, 0.2);
      const Mismatch& m = d.location.mismatches.front();
      const double shared = std::min(m.to, 0.389) - std::max(m.from, 0.289);
      const double both = std::max(m.to, 0.389) - std::min(m.from, 0.289);
      located += shared > 0.6 * both ? 1 : 0;
    }
  }
  RecordProperty("right_of_12", right);
  RecordProperty("held_out_gain_above_0_of_12", proved);
  RecordProperty("lens_located_of_4", located);
  EXPECT_GE(right, 3 * each - 1);
  EXPECT_GE(proved, 2 * each);
  EXPECT_GE(located, each - 1);
}

TEST(Diagnose, LeavesNothingMissingWhereNothingIsOrParametersWouldDo) {
  const auto cells = toy::cells();
  int alarms = 0, confounded = 0;
  for (std::uint64_t seed = 100; seed < 120; ++seed)
    alarms += answer(diagnose(problem(seed, VectorXd::Zero(60)), quick())) == nothing_is_missing ? 0 : 1;
  for (std::uint64_t seed = 200; seed < 205; ++seed) {
    // What "scaling" does, the parameter "scale" does as well.
    const Diagnosis d = diagnose(problem(seed, VectorXd::Constant(60, 0.05)), quick());
    confounded += answer(d) == nothing_is_missing ? 1 : 0;
    EXPECT_LT(d.isolability.strength(3), 2.5);
  }
  RecordProperty("alarms_of_20", alarms);
  RecordProperty("confounded_called_nothing_of_5", confounded);
  EXPECT_LE(alarms, 2);
  EXPECT_GE(confounded, 4);
}

TEST(Diagnose, SaysNoneOfTheseOfAnUnknownEffect) {
  const VectorXd wave = toy::curve(toy::cells(), [](double z) { return 0.12 * std::sin(60.0 * z); });
  int abstained = 0;
  for (std::uint64_t seed = 300; seed < 305; ++seed)
    abstained += answer(diagnose(problem(seed, wave), quick())) == none_of_these ? 1 : 0;
  RecordProperty("abstained_of_5", abstained);
  EXPECT_GE(abstained, 5);
}

TEST(Diagnose, OffersThePair) {
  const auto cells = toy::cells();
  const Diagnosis d =
      diagnose(problem(7, toy::top_curve(cells, 0.8, 0.2) + toy::lens_curve(cells, 0.7, 0.8)), quick());
  const PairEvidence& pair = d.pairs.front();
  EXPECT_TRUE((pair.first == "top" && pair.second == "lens") ||
              (pair.first == "lens" && pair.second == "top"));
  for (const Hypothesis& h : d.verdict.hypotheses) EXPECT_GT(pair.log_evidence, h.log_evidence) << h.name;
}

TEST(Diagnose, RepeatsItselfToTheBitAndReportsTheVariations) {
  Problem p = problem(8, toy::lens_curve(toy::cells(), 0.6, 0.5));
  p.recorded(20) = std::numeric_limits<double>::quiet_NaN();
  p.measurement.reset();  // from the recording itself
  Options options;
  options.bootstraps = 300;
  const Diagnosis a = diagnose(p, options), b = diagnose(p, options);
  EXPECT_EQ(a.compared.cells.size(), 59U);
  EXPECT_EQ(answer(a), "lens");
  EXPECT_EQ(a.location.p, b.location.p);
  EXPECT_EQ(a.verdict.gate->p, b.verdict.gate->p);
  EXPECT_EQ(a.best->held_out->lower, b.best->held_out->lower);
  for (std::size_t k = 0; k < a.verdict.hypotheses.size(); ++k)
    EXPECT_EQ(a.verdict.hypotheses[k].probability, b.verdict.hypotheses[k].probability);
  ASSERT_EQ(a.variations.size(), 4U);
  for (const PriorVariation& v : a.variations) EXPECT_FALSE(v.changed) << v.what << ": " << v.answer;
  EXPECT_THROW((void)diagnose(Problem{}, options), std::invalid_argument);
}

}  // namespace
}  // namespace cpt::diagnosis

// What is said of a posterior, and what it says over depth: on the toy sounding.
#include "diagnosis/several/answer.hpp"

#include <gtest/gtest.h>

#include "diagnosis/several/held_out_scores.hpp"
#include "diagnosis/several/summary.hpp"
#include "toy.hpp"

namespace cpt::diagnosis {
namespace {

const std::vector<Cell> cells = toy::cells();

enum : std::size_t { lens, top, drift, double_of_top };

// The last one does what `top` does.
std::vector<CurveEmulator> emulators() {
  MechanismEffect same = toy::top(cells, 18);
  same.name = "double of top";
  return {CurveEmulator(toy::lens(cells, 24)), CurveEmulator(toy::top(cells, 16)),
          CurveEmulator(toy::drift(cells, 6)), CurveEmulator(same)};
}

std::vector<std::vector<Index>> blocks() {
  std::vector<std::vector<Index>> made(6);
  for (Index i = 0; i < 60; ++i) made[static_cast<std::size_t>(i / 10)].push_back(i);
  return made;
}

class Answers : public testing::Test {
 protected:
  [[nodiscard]] VectorXd residual(const VectorXd& effect, std::uint64_t seed) const {
    return draw_null(null, 1, seed).col(0) + effect;
  }
  NullModel null = toy::null(cells);
  Scatter scatter{{{null.sigma, 0.0}}, MatrixXd::Zero(60, 60), null.parameters.prior_factors()};
  SubsetWeigher weigher{emulators(), null.sigma, metrics_of(cells, scatter, {}), {}};
};

TEST_F(Answers, NamesWhatIsThereAndGroupsWhatLooksAlike) {
  const Explained of_lens = weigher.explain(residual(toy::lens_curve(cells, 0.9, 0.5), 2));
  const Naming one = name_effects(of_lens, true, 0.5);
  EXPECT_EQ(one.named, std::vector<std::size_t>{lens});
  EXPECT_TRUE(one.groups.empty());
  const Explained of_top =
      weigher.explain(residual(toy::top_curve(cells, 0.9, 0.5) + toy::drift_curve(cells, 0.9), 2));
  const Naming grouped = name_effects(of_top, true, 0.5);
  EXPECT_EQ(grouped.named, std::vector<std::size_t>{drift});
  ASSERT_EQ(grouped.groups.size(), 1U);
  std::vector<std::size_t> members = grouped.groups.front().effects;
  std::ranges::sort(members);
  EXPECT_EQ(members, (std::vector<std::size_t>{top, double_of_top}));
  EXPECT_GT(grouped.groups.front().probability, 0.95);
}

TEST_F(Answers, WithoutAnAlarmOrBehindAFailedGateNoEffectIsNamed) {
  const Explained found = weigher.explain(residual(toy::lens_curve(cells, 0.9, 0.5), 2));
  EXPECT_TRUE(name_effects(found, false, 0.5).named.empty());
  const Naming failed = name_effects(found, true, 0.001);
  EXPECT_TRUE(failed.named.empty());
  EXPECT_TRUE(failed.something_else);
}

// The level is a quantile: as many of other draws fall below it as it says.
TEST_F(Answers, AlarmIsFalseAsOftenAsItsLevelSays) {
  const double level = alarm_level(weigher, draw_null(null, 300, 5), 0.1);
  const MatrixXd others = draw_null(null, 300, 6);
  int alarms = 0;
  for (Index k = 0; k < others.cols(); ++k) alarms += weigher.probability_of_nothing(others.col(k)) < level;
  EXPECT_GE(alarms, 15);
  EXPECT_LE(alarms, 48);
}

TEST_F(Answers, SummaryHoldsTheTrueCurveAndParameters) {
  const VectorXd curve = toy::lens_curve(cells, 0.7, 0.6), other = toy::drift_curve(cells, 0.8);
  const VectorXd r = residual(curve + other, 4);
  const Explained found = weigher.explain(r);
  const Summary summary = summarize(weigher, found, r, scatter.parameters);
  EXPECT_NEAR(summary.each[lens].place(0), 0.7, 3.0 * summary.each[lens].deviation(0) + 0.02);
  EXPECT_LE(summary.each[lens].lower(1), 0.65);
  EXPECT_GE(summary.each[lens].upper(1), 0.55);
  EXPECT_LT(summary.each[lens].deviation(1), 0.1);
  EXPECT_NEAR(summary.each[lens].inclusion, found.inclusion(lens), 0.02);
  int within = 0;
  for (Index i = 0; i < 60; ++i)
    within +=
        std::abs(summary.effects.mean(i) - curve(i) - other(i)) < 2.0 * summary.effects.deviation(i) + 0.01;
  EXPECT_GE(within, 50);
  EXPECT_LT((summary.each[lens].curve - curve).norm(), 0.35 * curve.norm());
}

TEST_F(Answers, SomethingElseIsDrawnAsItIs) {
  const VectorXd wave = toy::curve(cells, [](double z) { return 0.3 * std::sin(40.0 * z); });
  const VectorXd r = residual(wave, 4);
  const Summary summary = summarize(weigher, weigher.explain(r), r, scatter.parameters);
  EXPECT_LT((summary.something_else.mean - wave).norm(), 0.4 * wave.norm());
}

TEST_F(Answers, CheckIsTwoSided) {
  int low = 0, high = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const VectorXd r = residual(toy::lens_curve(cells, 0.8, 0.5), seed);
    const Explained found = weigher.explain(r);
    const TwoSidedCheck check = check_subset(weigher, found.subsets.front(), r);
    EXPECT_EQ(check.freedom, 60.0);
    (check.chi_square < 60.0 ? low : high) += check.p < 0.02;
  }
  EXPECT_LE(low + high, 4);
  // Half the noise, and twice the noise.
  const VectorXd quiet = 0.4 * residual(VectorXd::Zero(60), 3), loud = 2.5 * residual(VectorXd::Zero(60), 3);
  const WeighedSubset nothing = [&](const VectorXd& r) {
    for (const WeighedSubset& weighed : weigher.explain(r).subsets)
      if (weighed.subset.is_nothing()) return weighed;
    return WeighedSubset{};
  }(quiet);
  EXPECT_LT(check_subset(weigher, nothing, quiet).p, 0.01);
  EXPECT_LT(check_subset(weigher, nothing, loud).p, 0.01);
}

TEST_F(Answers, TheRightEffectPredictsWhatItHasNotSeen) {
  const VectorXd r = residual(toy::drift_curve(cells, 1.0) + toy::top_curve(cells, 0.8, 0.5), 3);
  const Explained found = weigher.explain(r);
  const Subset right{{top, drift}, false};
  const WeighedSubset* wrong = best_without(found, {top, drift, double_of_top});
  ASSERT_NE(wrong, nullptr);
  EXPECT_EQ(wrong->subset, (Subset{{lens}, false}));
  const VectorXd of_right = held_out_scores(weigher, right, r, blocks());
  EXPECT_GT(score_gain(of_right, held_out_scores(weigher, wrong->subset, r, blocks())).sum, 5.0);
  EXPECT_GT(score_gain(of_right, held_out_scores(weigher, {}, r, blocks())).sum, 5.0);
}

// Scores of blocks against the normal density of the whole: p(all) = p(first block) p(others | first).
TEST_F(Answers, ScoresAreConditionalDensities) {
  const VectorXd r = residual(VectorXd::Zero(60), 3);
  std::vector<std::vector<Index>> half(2);
  for (Index i = 0; i < 60; ++i) half[static_cast<std::size_t>(i / 30)].push_back(i);
  const Whitener M(null.covariance);
  const VectorXd scores = held_out_scores(weigher, {}, r, half);
  const double second = Whitener(null.covariance(half[1], half[1])).log_density(r(half[1]));
  EXPECT_NEAR(scores(0), M.log_density(r) - second, 1e-6);
}

}  // namespace
}  // namespace cpt::diagnosis

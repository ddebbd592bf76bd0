#include "validation/concealed/scoring.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::validation::concealed {
namespace {

// Three labels, four cases, the last answered against its most probable label.
const std::vector<ScoredCase> cases{{0, Eigen::Vector3d(0.7, 0.2, 0.1), 0, {0, 1}},
                                    {1, Eigen::Vector3d(0.5, 0.4, 0.1), 0, {0, 1}},
                                    {2, Eigen::Vector3d(0.3, 0.3, 0.4), 2, {2}},
                                    {2, Eigen::Vector3d(0.9, 0.1, 0.0), 2, {0}}};

TEST(Scoring, GivesClopperAndPearsonsInterval) {
  const Proportion none = proportion(0, 20);
  EXPECT_EQ(none.lower, 0.0);
  EXPECT_NEAR(none.upper, 1.0 - std::pow(0.025, 1.0 / 20.0), 1e-12);
  const Proportion some = proportion(8, 10);
  EXPECT_NEAR(some.lower, 0.4439, 1e-4);
  EXPECT_NEAR(some.upper, 0.9748, 1e-4);
  EXPECT_TRUE(std::isnan(proportion(0, 0).value));
  EXPECT_THROW((void)proportion(3, 2), std::invalid_argument);
}

TEST(Scoring, CountsAnswers) {
  const Eigen::MatrixXi matrix = confusion_matrix(cases, 3);
  EXPECT_EQ(matrix(0, 0), 1);
  EXPECT_EQ(matrix(1, 0), 1);
  EXPECT_EQ(matrix(2, 2), 2);
  EXPECT_EQ(matrix.sum(), 4);
  EXPECT_EQ(accuracy(cases).count, 3);
  EXPECT_EQ(top(cases, 1).count, 2);
  EXPECT_EQ(top(cases, 2).count, 3);
  EXPECT_EQ(top(cases, 3).count, 4);
  const Retrieval zero = retrieval(cases, 0), two = retrieval(cases, 2);
  EXPECT_DOUBLE_EQ(zero.precision.value, 0.5);
  EXPECT_DOUBLE_EQ(zero.recall.value, 1.0);
  EXPECT_DOUBLE_EQ(two.precision.value, 1.0);
}

TEST(Scoring, JudgesProbabilities) {
  EXPECT_NEAR(brier_score(cases), (0.14 + 0.62 + 0.54 + 1.82) / 4.0, 1e-12);
  EXPECT_NEAR(log_score(cases), (std::log(0.7) + std::log(0.4) + std::log(0.4) + std::log(1e-12)) / 4.0,
              1e-12);
  const SetScore sets = set_score(cases);
  EXPECT_DOUBLE_EQ(sets.coverage.value, 0.75);
  EXPECT_DOUBLE_EQ(sets.size, 1.5);
  const std::vector<ReliabilityBin> bins = reliability(cases, 2);
  EXPECT_EQ(bins[0].correct.of, 2);  // 0.4 and 0.0
  EXPECT_NEAR(bins[0].claimed, 0.2, 1e-12);
  EXPECT_EQ(bins[1].correct.count, 1);  // 0.7 right, 0.5 wrong
}

TEST(Scoring, MeasuresOverlaps) {
  EXPECT_NEAR(overlap({{0.0, 2.0}}, {{1.0, 3.0}}), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(overlap({{0.0, 1.0}, {0.5, 2.0}, {4.0, 5.0}}, {{0.0, 2.0}}), 2.0 / 3.0, 1e-12);
  EXPECT_EQ(overlap({}, {}), 1.0);
  EXPECT_EQ(overlap({}, {{0.0, 1.0}}), 0.0);
}

}  // namespace
}  // namespace cpt::validation::concealed

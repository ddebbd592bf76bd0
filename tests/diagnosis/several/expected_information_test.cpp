#include "diagnosis/several/expected_information.hpp"

#include <gtest/gtest.h>

#include "diagnosis/whitener.hpp"
#include "toy.hpp"

namespace cpt::diagnosis {
namespace {

const std::vector<Cell> two = toy::cells(2);
const std::vector<Cell> one = toy::cells();

// A step at the top in the sounding that was made; in the next one `share` times as much.
MechanismEffect step(const std::string& name, double share) {
  return toy::effect(name, {"strength"}, 6, [share](double a, double) {
    VectorXd both(120);
    const VectorXd curve = toy::top_curve(one, a, 0.5);
    both << curve, share * curve;
    return both;
  });
}

struct Pushes {
  MatrixXd sigma = noise_covariance(two, toy::noise);
  SubsetWeigher weigher;
  Pushes(double share_of_one, double share_of_other)
      : weigher({CurveEmulator(step("one", share_of_one)), CurveEmulator(step("other", share_of_other))},
                sigma, metrics_of(two, {{{sigma, 0.0}}, MatrixXd::Zero(120, 120), MatrixXd(120, 0)}, {}),
                {}) {}
};

const VectorXd seen = toy::top_curve(one, 0.9, 0.5);

TEST(ExpectedInformation, OfAPushThatPartsTheEffects) {
  const Pushes pushes(1.0, 0.0);
  const ExpectedInformation told = expected_information(pushes.weigher, seen, 40, 1);
  EXPECT_GT(told.before, std::log(2.0) - 0.2);  // one or the other, or both
  EXPECT_GT(told.gained(), 0.3);
  EXPECT_LT(told.members_after, told.members_before);
  EXPECT_GT(told.halved, 0.3);
}

TEST(ExpectedInformation, OfAPushThatRepeatsWhatIsKnown) {
  const Pushes pushes(1.0, 1.0);
  const ExpectedInformation told = expected_information(pushes.weigher, seen, 40, 1);
  EXPECT_LT(told.gained(), 0.2);
  EXPECT_LT(told.halved, 0.2);
  const ExpectedInformation again = expected_information(pushes.weigher, seen, 40, 1);
  EXPECT_EQ(told.after, again.after);
}

// What is known of the first push alone is what a weigher of the first push says.
TEST(ExpectedInformation, KnowsOfThePresentWhatItTells) {
  const Pushes pushes(1.0, 0.0);
  std::vector<Index> rows;
  for (Index i = 0; i < 60; ++i) rows.push_back(i);
  const SubsetWeigher present(pushes.weigher, rows);
  const MatrixXd sigma = noise_covariance(one, toy::noise);
  for (const Metric& metric : present.metrics())
    if (!metric.something_else()) {
      EXPECT_LT((metric.covariance() - sigma).norm(), 1e-6 * sigma.norm());
    }
  EXPECT_EQ(present.fine()[0].curves, pushes.weigher.fine()[0].curves.topRows(60));
  EXPECT_LT(present.probability_of_nothing(seen), 0.01);
}

}  // namespace
}  // namespace cpt::diagnosis

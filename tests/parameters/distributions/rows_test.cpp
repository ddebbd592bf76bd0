// Rows of a study that have distributions: their bounds, and what designs make of them.
#include <algorithm>
#include <cmath>

#include "parameters/designs/design.hpp"
#include "tests/parameters/distributions/with_openturns.hpp"
#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

using Rows = WithOpenTurns;

constexpr const char* lognormal =
    R"("sand.G_ref" = { distribution = { kind = "lognormal", mean = 743, cv = 0.1 } })";

std::string study_with(const std::string& row, const std::string& design = "") {
  return sand_study("[parameters]\n" + row + "\n" + design);
}

TEST_F(Rows, HaveTheMedianAndTwoQuantilesWhereNothingElseIsGiven) {
  const Study study = study_of(study_with(lognormal));
  const Row& row = study.rows.at(0);
  ASSERT_TRUE(row.marginal);
  const double deviation = std::sqrt(std::log1p(0.01)), median = 743.0 / std::sqrt(1.01);
  EXPECT_NEAR(row.baseline, median, 0.05);  // four digits
  EXPECT_EQ(row.quantity->format(row.baseline), "739.3");
  EXPECT_EQ(row.quantity->value(study.baseline), row.baseline);
  EXPECT_NEAR(row.lower, median * std::exp(-1.6448536269514722 * deviation), 0.05);
  EXPECT_NEAR(row.upper, median * std::exp(+1.6448536269514722 * deviation), 0.05);
}

TEST_F(Rows, KeepWhatIsGiven) {
  const Study study = study_of(study_with(
      R"("sand.G_ref" = { baseline = 740, upper = 1000, distribution = { kind = "normal", mean = 743, cv = 0.1 } })"));
  EXPECT_EQ(study.rows.at(0).baseline, 740.0);
  EXPECT_EQ(study.rows.at(0).upper, 1000.0);
  EXPECT_LT(study.rows.at(0).lower, 700.0);
}

TEST_F(Rows, OfAChoiceTakeItsValues) {
  const Study study = study_of(study_with(
      R"("chamber.wall" = { distribution = { kind = "discrete", values = ["rigid", "flexible"], weights = [3, 1] } })"));
  const Row& row = study.rows.at(0);
  EXPECT_NE(row.lower, row.upper);
  EXPECT_EQ(row.quantity->format(row.baseline), "rigid");
}

TEST_F(Rows, SamplesFollowTheDistribution) {
  const Study study = study_of(study_with(lognormal, "[design]\nkind = \"latin_hypercube\"\nruns = 200\n"));
  const Row& row = study.rows.at(0);
  const Eigen::MatrixXd places = design_places(study);
  std::vector<double> values;
  for (const DesignPoint& point : study.points) values.push_back(point.changes.at(0).value);
  ASSERT_EQ(values.size(), 200u);
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_DOUBLE_EQ(values[i], row.marginal->quantile(places(static_cast<Eigen::Index>(i), 0)));
  std::ranges::sort(values);
  EXPECT_NEAR(values[100], row.baseline, 3.0);
  EXPECT_LT(values.front(), row.lower);  // beyond the 5 % quantile
  EXPECT_GT(values.back(), row.upper);
}

TEST_F(Rows, DesignsThatDoNotSampleStayWithinTheBounds) {
  const Study study = study_of(study_with(std::string(lognormal) + "\n\"sand.H\" = { upper = 75 }",
                                          "[design]\nkind = \"morris\"\ntrajectories = 4\n"));
  const Row& row = study.rows.at(0);
  for (const DesignPoint& point : study.points)
    for (const Change& change : point.changes)
      if (change.quantity == row.quantity) {
        EXPECT_GE(change.value, row.lower);
        EXPECT_LE(change.value, row.upper);
      }
}

TEST_F(Rows, AnAlternativeIsNoDistribution) {
  const auto errors = errors_of(study_with(
      R"("sand.G_ref" = { alternative = 800, distribution = { kind = "normal", mean = 743, cv = 0.1 } })"));
  ASSERT_EQ(errors.size(), 1u) << format(errors);
  EXPECT_EQ(errors[0].key, "parameters.sand.G_ref.alternative");
  EXPECT_EQ(errors[0].line, 8);
}

TEST_F(Rows, AMistakeInADistributionIsTheOnlyError) {
  const auto errors =
      errors_of(study_with(R"("sand.G_ref" = { distribution = { kind = "normal", mean = 743 } })",
                           "[design]\nkind = \"latin_hypercube\"\n"));
  ASSERT_EQ(errors.size(), 1u) << format(errors);
  EXPECT_EQ(errors[0].key, "parameters.sand.G_ref.distribution.standard_deviation");
}

}  // namespace
}  // namespace cpt::parameters

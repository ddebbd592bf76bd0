// What least squares make of toy soundings.
#include "validation/concealed/baselines.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/diagnosis/toy.hpp"

namespace cpt::validation::concealed {
namespace {

using namespace diagnosis;

LeastSquares fitted(const VectorXd& missing, std::size_t mechanisms = 2) {
  const auto cells = toy::cells();
  Problem problem;
  problem.cells = cells;
  problem.measurement = toy::noise;
  problem.baseline = toy::baseline(cells);
  problem.parameters = toy::parameters(cells);
  problem.mechanisms = {toy::drift(cells, 5), toy::lens(cells, 9)};
  problem.mechanisms.resize(mechanisms);
  problem.recorded =
      problem.baseline + missing + toy::curve(cells, [](double z) { return 0.01 * std::sin(400.0 * z); });
  return least_squares(prepare(problem));
}

double sum_of_weights(const LeastSquares& found) {
  return std::accumulate(found.fits.begin(), found.fits.end(), 0.0,
                         [](double sum, const LeastSquares::Fit& fit) { return sum + fit.bic_weight; });
}

TEST(LeastSquares, NameTheMechanismThatIsMissing) {
  const LeastSquares found = fitted(toy::drift_curve(toy::cells(), 0.8));
  ASSERT_EQ(found.fits.size(), 3U);
  EXPECT_EQ(found.fits[1].name, "lens");
  EXPECT_EQ(found.fits[1].parameters, 2 + 2 + 1);  // of the soil, the lens and the error
  EXPECT_EQ(found.of_nothing().name, nothing_is_missing);
  EXPECT_EQ(found.least_rmse().name, "drift");
  EXPECT_EQ(found.greatest_weight().name, "drift");
  EXPECT_NEAR(sum_of_weights(found), 1.0, 1e-12);
}

// A mechanism more never fits worse, but its parameters cost.
TEST(LeastSquares, FindNothingWhereNothingIsMissing) {
  const LeastSquares found = fitted(VectorXd::Zero(60));
  EXPECT_EQ(found.greatest_weight().name, nothing_is_missing);
  EXPECT_NE(found.least_rmse().name, nothing_is_missing);
  EXPECT_LE(found.least_rmse().rmse, found.of_nothing().rmse);
}

TEST(LeastSquares, HaveNothingToNameWithoutMechanisms) {
  const LeastSquares found = fitted(VectorXd::Zero(60), 0);
  EXPECT_EQ(found.least_rmse().name, nothing_is_missing);
  EXPECT_EQ(found.of_nothing().bic_weight, 1.0);
}

}  // namespace
}  // namespace cpt::validation::concealed

#include "diagnosis/covariance.hpp"

#include <gtest/gtest.h>

#include "diagnosis/random.hpp"
#include "diagnosis/whitener.hpp"
#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

MatrixXd draws(const MatrixXd& covariance, Index count, std::uint64_t seed) {
  Random random(seed, 0);
  MatrixXd z(covariance.rows(), count);
  for (Index k = 0; k < count; ++k) z.col(k) = random.normals(z.rows());
  return Whitener(covariance).colour(z);
}

TEST(Covariance, OfRepeatsRecoversAnAutoregression) {
  const auto cells = toy::cells();
  const MatrixXd truth = noise_covariance(cells, toy::noise);
  double length = 0.0, deviation = 0.0, error = 0.0, sample_error = 0.0;
  constexpr int sets = 20;
  for (int set = 0; set < sets; ++set) {
    MatrixXd repeats = draws(truth, 8, static_cast<std::uint64_t>(set));
    repeats.colwise() += toy::baseline(cells);
    const ShrunkCovariance estimate = covariance_of_repeats(cells, repeats);
    length += estimate.target.length / sets;
    deviation += estimate.target.deviation / sets;
    error += (estimate.covariance - truth).norm() / truth.norm() / sets;
    const MatrixXd centred = repeats.colwise() - repeats.rowwise().mean();
    sample_error += (centred * centred.transpose() / 7.0 - truth).norm() / truth.norm() / sets;
    EXPECT_GT(estimate.weight, 0.7);
  }
  EXPECT_NEAR(length, toy::noise.length, 0.1 * toy::noise.length);
  EXPECT_NEAR(deviation, toy::noise.deviation, 0.05 * toy::noise.deviation);
  EXPECT_LT(error, 0.25);
  EXPECT_GT(sample_error, 3.0 * error);
}

TEST(Covariance, OfManyRepeatsLeavesAWrongTarget) {
  const auto cells = toy::cells();
  // Noise only in the upper half: no stationary covariance.
  MatrixXd truth = noise_covariance(cells, toy::noise);
  truth.bottomRows(30) *= 0.1;
  truth.rightCols(30) *= 0.1;
  const ShrunkCovariance estimate = covariance_of_repeats(cells, draws(truth, 400, 1));
  EXPECT_LT(estimate.weight, 0.1);
  EXPECT_LT((estimate.covariance - truth).norm(), 0.2 * truth.norm());
}

TEST(Covariance, OfTheHighPassPartDoesNotSeeTheTrend) {
  const auto cells = toy::cells(2);
  const MatrixXd noise = draws(noise_covariance(cells, toy::noise), 20, 3);
  std::vector<double> length, deviation;
  for (Index k = 0; k < 20; ++k) {
    const VectorXd y = toy::baseline(cells) + noise.col(k) +
                       toy::curve(cells, [](double z) { return 0.5 * std::sin(8.0 * z); });
    const NoiseModel fit = noise_of_high_pass(cells, y, 0.3);
    length.push_back(fit.length);
    deviation.push_back(fit.deviation);
  }
  std::sort(length.begin(), length.end());
  std::sort(deviation.begin(), deviation.end());
  EXPECT_NEAR(length[10], toy::noise.length, 0.35 * toy::noise.length);
  EXPECT_NEAR(deviation[10], toy::noise.deviation, 0.15 * toy::noise.deviation);
}

TEST(Covariance, KeepsTheVarianceOfResiduals) {
  const MatrixXd residuals = draws(noise_covariance(toy::cells(), toy::noise), 10, 4);
  const MatrixXd covariance = low_rank_plus_diagonal(residuals, 2);
  EXPECT_LT((covariance.diagonal() - residuals.rowwise().squaredNorm() / 10.0).norm(), 1e-12);
  EXPECT_LT((low_rank_plus_diagonal(residuals, 10) - residuals * residuals.transpose() / 10.0).norm(), 1e-12);
  EXPECT_EQ(low_rank_plus_diagonal(MatrixXd(5, 0)).norm(), 0.0);
}

TEST(Whitener, WhitensAndMendsOnlyALittle) {
  const MatrixXd covariance = noise_covariance(toy::cells(), toy::noise);
  const Whitener whitener(covariance);
  EXPECT_LT((whitener.colour(whitener.whiten(covariance)) - covariance).norm(), 1e-12);
  EXPECT_LT((whitener.solve(covariance) - MatrixXd::Identity(60, 60)).norm(), 1e-9);
  EXPECT_NO_THROW(Whitener(MatrixXd::Ones(5, 5)));
  EXPECT_THROW(Whitener(-MatrixXd::Identity(3, 3)), std::invalid_argument);
}

}  // namespace
}  // namespace cpt::diagnosis

#include "diagnosis/several/noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "diagnosis/random.hpp"
#include "diagnosis/whitener.hpp"
#include "toy.hpp"

namespace cpt::diagnosis {
namespace {

// 4 % at 10 kPa of floor where q is 250 kPa, the percentage alone where it is large.
TEST(MeasurementNoise, HasAFloorWhereTheSoilIsSoft) {
  const std::vector<Cell> cells = toy::cells(1, 2);
  const Eigen::Vector2d simulated(std::log(250e3), std::log(250e6));
  const std::array<ChannelNoise, 1> noise = {{{0.01, 10e3, 0.01}}};
  const MatrixXd covariance = measurement_covariance(cells, simulated, noise);
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), std::hypot(0.01, 0.04), 1e-12);
  EXPECT_NEAR(std::sqrt(covariance(1, 1)), 0.01, 1e-6);
  EXPECT_NEAR(covariance(0, 1), std::exp(-1.0) * std::hypot(0.01, 0.04) * std::sqrt(covariance(1, 1)), 1e-12);
}

TEST(MeasurementNoise, LeavesCurvesIndependent) {
  std::vector<Cell> cells = toy::cells(1, 4);
  cells[2].channel = cells[3].channel = 1;
  const std::array<ChannelNoise, 2> noise = {{{0.01, 0.0, 0.05}, {0.1, 0.0, 0.05}}};
  const MatrixXd covariance = measurement_covariance(cells, VectorXd::Zero(4), noise);
  EXPECT_EQ(covariance(1, 2), 0.0);
  EXPECT_NEAR(covariance(2, 2), 0.01, 1e-15);
  EXPECT_GT(covariance(2, 3), 0.005);
}

// Runs that scatter by 1 % above and by 15 % at a layer: both are found, where one number for all would be
// far off.
TEST(ScatterOfRepeats, IsLargeOnlyWhereRunsScatter) {
  const std::vector<Cell> cells = toy::cells();
  const VectorXd truth =
      toy::curve(cells, [](double z) { return 0.01 + 0.14 * toy::bump((z - 0.4) / 0.04); });
  const Whitener unit(noise_covariance(cells, {Kernel::ar1, 1.0, 0.03}));
  double quiet = 0.0, loud = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    MatrixXd repeats(60, 8);
    for (Index k = 0; k < 8; ++k)
      repeats.col(k) =
          truth.cwiseProduct(unit.colour(Random(seed, static_cast<std::uint64_t>(k)).normals(60)).col(0));
    const MatrixXd found = scatter_of_repeats(cells, repeats);
    quiet += found.diagonal().segment(5, 15).mean() / 20.0;
    loud += found.diagonal().segment(37, 6).mean() / 20.0;
  }
  EXPECT_LT(std::sqrt(quiet), 0.045);  // drawn towards the curve's mean of 4.7 %
  EXPECT_GT(std::sqrt(loud), 0.09);
  EXPECT_LT(std::sqrt(loud), 0.16);
}

// Errors of 12 runs: nothing but their scatter has no component, a curve in them has itself.
TEST(BeyondScatter, LeavesOutWhatEveryRunScattersBy) {
  const std::vector<Cell> cells = toy::cells();
  const MatrixXd scatter = noise_covariance(cells, toy::noise);
  const Whitener whitener(scatter);
  MatrixXd errors(60, 12);
  for (Index k = 0; k < 12; ++k)
    errors.col(k) = whitener.colour(Random(9, static_cast<std::uint64_t>(k)).normals(60)).col(0);
  EXPECT_EQ(beyond_scatter(errors, scatter, 3).cols(), 0);
  const VectorXd curve = toy::top_curve(cells, 1.0, 0.5);
  for (Index k = 0; k < 12; ++k) errors.col(k) += (k % 2 == 0 ? 1.0 : -1.0) * curve;
  const MatrixXd found = beyond_scatter(errors, scatter, 3);
  ASSERT_EQ(found.cols(), 1);
  EXPECT_NEAR(std::abs(found.col(0).normalized().dot(curve.normalized())), 1.0, 0.02);
  EXPECT_NEAR(found.norm(), curve.norm(), 0.1 * curve.norm());
  EXPECT_EQ(beyond_scatter(MatrixXd(60, 0), scatter, 3).cols(), 0);
}

std::vector<std::vector<Index>> whole(Index from, Index to) {
  std::vector<Index> rows(static_cast<std::size_t>(to - from));
  std::iota(rows.begin(), rows.end(), from);
  return {rows};
}

// Smooth departures of any size do not count, layers stay outside the stretches.
TEST(EstimatedNoise, TellsNoiseFromLayersAndTrends) {
  const std::vector<Cell> cells = cells_of({{0.0, 0.005, 120}});
  const VectorXd layer = toy::curve(cells, [](double z) { return z > 0.3 ? -1.5 : 0.3 * z; });
  const MatrixXd none = MatrixXd::Zero(120, 120);
  double within = 0.0, mean = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Whitener noise(noise_covariance(cells, {Kernel::ar1, 0.02, 0.01}));
    const VectorXd difference = layer + noise.colour(Random(seed, 0).normals(120)).col(0);
    std::vector<std::vector<Index>> stretches = {whole(0, 56).front(), whole(66, 120).front()};
    const EstimatedNoise found = estimate_noise(cells, difference, none, stretches, 0.15);
    within += found.lower <= 0.02 && 0.02 <= found.upper ? 1.0 / 40.0 : 0.0;
    mean += found.relative / 40.0;
    EXPECT_EQ(found.noises.size(), 5U);
  }
  EXPECT_NEAR(mean, 0.02, 0.004);
  EXPECT_GE(within, 0.8);
}

// What the runs themselves scatter by is not the recording's.
TEST(EstimatedNoise, LeavesOutTheRunsOwnScatter) {
  const std::vector<Cell> cells = cells_of({{0.0, 0.005, 120}});
  const MatrixXd numerics = noise_covariance(cells, {Kernel::ar1, 0.03, 0.01});
  double mean = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const VectorXd difference = Whitener(numerics).colour(Random(seed, 0).normals(120)).col(0);
    mean += estimate_noise(cells, difference, numerics, whole(0, 120), 0.15).relative / 20.0;
  }
  EXPECT_LT(mean, 0.015);
}

TEST(EstimatedNoise, RefusesWhatIsTooShort) {
  const std::vector<Cell> cells = toy::cells();
  EXPECT_THROW((void)estimate_noise(cells, VectorXd::Zero(60), MatrixXd::Zero(60, 60), whole(0, 8), 0.15),
               std::invalid_argument);
}

}  // namespace
}  // namespace cpt::diagnosis

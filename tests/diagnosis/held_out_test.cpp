#include "diagnosis/held_out.hpp"

#include <gtest/gtest.h>

#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

TEST(HeldOut, CutsBlocksOfOneSoundingEach) {
  const auto cells = toy::cells(2, 25);
  const auto blocks = depth_blocks(cells, 0.1);
  ASSERT_EQ(blocks.size(), 4U);
  EXPECT_EQ(blocks[0].size(), 12U);
  EXPECT_EQ(blocks[1].back(), 24);
  EXPECT_EQ(blocks[2].front(), 25);
  EXPECT_EQ(sounding_blocks(cells).size(), 2U);
  const auto one = toy::cells();
  EXPECT_THROW((void)predict_null(toy::null(one), toy::baseline(one), sounding_blocks(one)),
               std::invalid_argument);
}

TEST(HeldOut, PredictsTheNullByConditioning) {
  const auto cells = toy::cells();
  const NullModel null = toy::null(cells);
  const VectorXd y = null.mean + draw_null(null, 1, 3).col(0);
  const auto blocks = depth_blocks(cells, 0.2);
  const Prediction prediction = predict_null(null, y, blocks);
  // p(all) = p(rest) p(block | rest).
  std::vector<Index> rest;
  for (Index i = 20; i < 60; ++i) rest.push_back(i);
  const VectorXd r = y - null.mean;
  const double expected =
      Whitener(null.covariance).log_density(r) - Whitener(null.covariance(rest, rest)).log_density(r(rest));
  EXPECT_NEAR(prediction.log_score(0), expected, 1e-9);
  double squares = 0.0;
  for (Index i = 0; i < 60; ++i) squares += std::pow(y(i) - prediction.mean(i), 2) / prediction.variance(i);
  EXPECT_NEAR(squares / 60.0, 1.0, 0.6);
}

TEST(HeldOut, ProvesATrueMechanismAndNotANullOne) {
  const auto cells = toy::cells(2);  // the same lens in both soundings
  const NullModel null = toy::null(cells);
  const CurveEmulator lens(toy::lens(cells, 40));
  const auto blocks = sounding_blocks(cells);
  int proved_true = 0, better_rmse = 0, proved_false = 0;
  const MatrixXd draws = draw_null(null, 12, 8);
  for (Index k = 0; k < 12; ++k) {
    for (const double strength : {0.0, 0.7}) {
      const VectorXd y = null.mean + draws.col(k) + toy::lens_curve(cells, strength, 0.37);
      const HeldOutGain gain =
          held_out_gain(y, predict_null(null, y, blocks), predict_mechanism(null, lens, y, blocks), 12, 1);
      EXPECT_LE(gain.lower, gain.per_cell);
      EXPECT_GE(gain.upper, gain.per_cell);
      const bool proved = gain.lower > 0.0 && gain.log_score > 0.0;
      if (strength > 0.0) {
        proved_true += proved ? 1 : 0;
        better_rmse += gain.rmse < gain.rmse_null ? 1 : 0;
      } else {
        proved_false += proved ? 1 : 0;
      }
    }
  }
  EXPECT_GE(proved_true, 10);
  EXPECT_GE(better_rmse, 11);
  EXPECT_LE(proved_false, 1);
  RecordProperty("proved_of_12_true", proved_true);
  RecordProperty("proved_of_12_null", proved_false);
}

}  // namespace
}  // namespace cpt::diagnosis

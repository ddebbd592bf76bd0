#include "diagnosis/depth_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cpt::diagnosis {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

TEST(DepthGrid, AveragesQcAndThenTakesTheLogarithm) {
  const SoundingGrid grid{0.1, 0.1, 3};
  const std::vector<double> depth{0.05, 0.12, 0.18, 0.25, 0.35, 0.45}, q_c{9e9, 1e6, 3e6, 4e6, 5e6, 9e9};
  const VectorXd y = log_cell_means(grid, depth, q_c);
  EXPECT_NEAR(y(0), std::log(2e6), 1e-12);
  EXPECT_NEAR(y(1), std::log(4e6), 1e-12);
  EXPECT_NEAR(y(2), std::log(5e6), 1e-12);
}

TEST(DepthGrid, LeavesACellOutThatIsNotWhole) {
  const SoundingGrid grid{0.0, 0.1, 4};
  const std::vector<double> depth{0.01, 0.05, 0.15, 0.35}, q_c{1e6, nan, 2e6, -1.0};
  const VectorXd y = log_cell_means(grid, depth, q_c);
  EXPECT_TRUE(std::isnan(y(0)));  // a bad sample
  EXPECT_FALSE(std::isnan(y(1)));
  EXPECT_TRUE(std::isnan(y(2)));  // no sample
  EXPECT_TRUE(std::isnan(y(3)));  // no logarithm
  EXPECT_EQ(complete_rows({y, VectorXd::Ones(4)}), (std::vector<Index>{1}));
  EXPECT_THROW((void)log_cell_means(grid, depth, std::vector<double>{1.0}), std::invalid_argument);
  EXPECT_THROW((void)complete_rows({y, VectorXd::Ones(3)}), std::invalid_argument);
}

// (0.09 - 0.04) / 0.005 falls short of 10 by rounding, (0.048 - 0.038) / 0.005 of 2, and so on.
TEST(DepthGrid, AReadingOnAnEdgeBelongsToTheCellBelowWhateverTheRounding) {
  int rounded_down = 0;
  for (int from = 30; from < 60; ++from)
    for (int cell = 0; cell < 10; ++cell) {
      const SoundingGrid grid{from / 1000.0, 0.005, 10};
      const double edge = (from + 5 * cell) / 1000.0;
      rounded_down += (edge - grid.from) / grid.height < cell ? 1 : 0;
      EXPECT_NEAR(log_cell_means(grid, std::vector<double>{edge}, std::vector<double>{1e6})(cell),
                  std::log(1e6), 1e-12)
          << from << " mm, cell " << cell;
    }
  EXPECT_GT(rounded_down, 10);
}

TEST(DepthGrid, LaysSoundingsEndToEnd) {
  const std::vector<Cell> cells = cells_of({{0.0, 0.1, 2}, {0.5, 0.2, 3}});
  ASSERT_EQ(cells.size(), 5U);
  EXPECT_EQ(cells[2].sounding, 1);
  EXPECT_DOUBLE_EQ(cells[2].depth, 0.6);
  EXPECT_EQ(concatenate({VectorXd::Ones(2), VectorXd::Zero(3)}).sum(), 2.0);
  EXPECT_EQ(select(cells, {0, 4}).back().sounding, 1);
}

}  // namespace
}  // namespace cpt::diagnosis

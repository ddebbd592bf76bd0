#include "parameters/designs/pairs.hpp"

#include <gtest/gtest.h>

#include "tests/parameters/designs/functions.hpp"

namespace cpt::parameters {
namespace {

TEST(Pairs, HaveTheirFourCornersWithTheOthersLeftAlone) {
  const Eigen::MatrixXd places = pairs_places(3);
  ASSERT_EQ(places.rows(), 12);
  EXPECT_EQ(pairs_of(3), (std::vector<std::pair<Eigen::Index, Eigen::Index>>{{0, 1}, {0, 2}, {1, 2}}));
  for (Eigen::Index k = 0; k < 4; ++k) {
    EXPECT_EQ(places(4 + k, 0), static_cast<double>(k % 2));
    EXPECT_TRUE(std::isnan(places(4 + k, 1)));
    EXPECT_EQ(places(4 + k, 2), static_cast<double>(k / 2));
  }
}

TEST(Pairs, InteractionIsHalfOfTheChangeOfAnEffect) {
  const auto y = [](double a, double b) { return 3.0 + 2.0 * a - 5.0 * b + 7.0 * a * b; };
  EXPECT_DOUBLE_EQ(interaction({y(0, 0), y(1, 0), y(0, 1), y(1, 1)}), 3.5);
  const auto sum = [](double a, double b) { return 3.0 + 2.0 * a - 5.0 * b; };
  EXPECT_DOUBLE_EQ(interaction({sum(0, 0), sum(1, 0), sum(0, 1), sum(1, 1)}), 0.0);
}

TEST(Pairs, InteractionOfAMissingRunIsUndefined) {
  EXPECT_TRUE(std::isnan(interaction({1.0, 2.0, std::nan(""), 3.0})));
}

}  // namespace
}  // namespace cpt::parameters

#include "parameters/designs/variation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::parameters {
namespace {

using Eigen::VectorXd;

TEST(Variation, IsMoreThanRounding) {
  EXPECT_TRUE(differ(2000.0, 2000.001));
  EXPECT_FALSE(differ(2000.0, 2000.0000001));
  EXPECT_FALSE(differ(2000.0, 2000.0));
  EXPECT_FALSE(differ(0.0, 0.0));
  EXPECT_TRUE(differ(0.0, 1e-300));
  EXPECT_TRUE(differ(-1.0, 1.0));
  EXPECT_FALSE(differ(std::nan(""), 1.0));
}

TEST(Variation, RunsWithoutAResultDoNotCount) {
  const double none = std::nan("");
  EXPECT_TRUE(varies(Eigen::Vector4d(3.0, none, 3.0, 3.1)));
  EXPECT_FALSE(varies(Eigen::Vector4d(3.0, none, 3.0, 3.0 + 1e-12)));
  EXPECT_FALSE(varies(VectorXd()));
  EXPECT_TRUE(is_constant(Eigen::Vector3d(3.0, none, 3.0)));
  EXPECT_FALSE(is_constant(Eigen::Vector3d(3.0, none, none))) << "one result tells nothing";
  EXPECT_FALSE(is_constant(Eigen::Vector3d(3.0, 4.0, none)));
}

}  // namespace
}  // namespace cpt::parameters

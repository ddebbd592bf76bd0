#include "diagnosis/fitted.hpp"

#include <gtest/gtest.h>

namespace cpt::diagnosis {
namespace {

// One cell: the share a / (a + c).
TEST(ExpectedError, SharesByVariance) {
  const VectorXd off = VectorXd::Constant(1, 0.3);
  const MatrixXd four = MatrixXd::Constant(1, 1, 4.0), two = MatrixXd::Constant(1, 1, 2.0);
  EXPECT_NEAR(expected_error(off, four, two)(0), 0.2, 1e-15);
}

// An error of one shape takes that shape out of scatter, and nothing at right angles to it.
TEST(ExpectedError, FollowsTheErrorsShape) {
  const VectorXd shape = VectorXd::LinSpaced(4, 1.0, 4.0).normalized();
  const MatrixXd error = 9.0 * shape * shape.transpose();
  const MatrixXd noise = MatrixXd::Identity(4, 4);
  EXPECT_LT((expected_error(shape, error, noise) - 0.9 * shape).norm(), 1e-14);
  VectorXd other(4);
  other << 2.0, -1.0, 0.0, 0.0;
  EXPECT_LT(expected_error(other, error, noise).norm(), 1e-14);
}

TEST(ExpectedError, IsAllWithoutScatterAndNothingWithoutError) {
  const VectorXd off = VectorXd::LinSpaced(5, -0.1, 0.2);
  const MatrixXd identity = MatrixXd::Identity(5, 5);
  EXPECT_LT((expected_error(off, identity, 1e-12 * identity) - off).norm(), 1e-11);
  EXPECT_EQ(expected_error(off, MatrixXd::Zero(5, 5), identity).norm(), 0.0);
}

}  // namespace
}  // namespace cpt::diagnosis

#include "diagnosis/response_surface.hpp"

#include <gtest/gtest.h>

#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

TEST(ResponseSurface, PassesThroughTheRuns) {
  const auto cells = toy::cells();
  const auto effects = toy::parameters(cells);
  const ResponseSurface model(toy::baseline(cells), effects);
  EXPECT_LT((model.predict(model.baseline_place()) - toy::baseline(cells)).norm(), 1e-12);
  EXPECT_LT((model.predict(Eigen::Vector2d(0.5, 0.0)) - effects[1].lower).norm(), 1e-12);
  EXPECT_LT((model.predict(Eigen::Vector2d(0.5, 1.0)) - effects[1].upper).norm(), 1e-12);
  // From the baseline widened twice, half the way is the old end.
  const ResponseSurface wide = model.widened(2.0);
  EXPECT_LT((wide.predict(Eigen::Vector2d(0.75, 0.4)) - effects[0].upper).norm(), 1e-12);
}

TEST(ResponseSurface, HasThePriorsMoments) {
  const auto cells = toy::cells();
  auto effects = toy::parameters(cells);
  effects.push_back({"wall", 0.0, {}, toy::baseline(cells).array() + 0.3, true});
  const NullModel null = null_model(ResponseSurface(toy::baseline(cells), effects),
                                    MatrixXd::Zero(60, 60) + 1e-12 * MatrixXd::Identity(60, 60));
  const MatrixXd draws = draw_null(null, 20000, 1);
  EXPECT_LT(draws.rowwise().mean().cwiseAbs().maxCoeff(), 0.005);
  const MatrixXd sample = draws * draws.transpose() / 20000.0;
  EXPECT_LT((sample - null.covariance).norm(), 0.02 * null.covariance.norm());
  // By hand, in the middle of the depths where nothing tilts (z = 0.3) but for 0.02 of the tilt's run.
  EXPECT_NEAR(null.covariance(29, 29), 0.2 * 0.2 / 12.0 + 0.3 * 0.3 / 4.0, 2e-4);
}

TEST(ResponseSurface, RefusesWhatIsNoEffect) {
  const auto cells = toy::cells();
  const VectorXd y = toy::baseline(cells);
  EXPECT_THROW(ResponseSurface(y, {{"none", 0.5, {}, {}}}), std::invalid_argument);
  EXPECT_THROW(ResponseSurface(y, {{"outside", 1.5, y, y}}), std::invalid_argument);
  EXPECT_THROW(ResponseSurface(y, {{"short", 0.5, VectorXd::Ones(3), y}}), std::invalid_argument);
  EXPECT_THROW(ResponseSurface(y, {{"choice", 0.5, y, y, true}}), std::invalid_argument);
}

// Twenty places in the unit square, and the curves of a law there.
template <class Law>
JointRuns joint_runs(const Law& law) {
  JointRuns joint;
  joint.places.resize(20, 2);
  joint.curves.resize(60, 20);
  Random random(7, 0);
  for (Index k = 0; k < 20; ++k) {
    joint.places.row(k) << random.uniform(), random.uniform();
    joint.curves.col(k) = law(joint.places(k, 0), joint.places(k, 1));
  }
  return joint;
}

// Two parameters that multiply, the second curved, with its baseline at the lower bound.
struct Multiplying {
  VectorXd y0 = toy::baseline(toy::cells());
  VectorXd operator()(double t, double u) const {
    return y0.array() + 0.4 * (t - 0.5) + 0.5 * u - 0.2 * u * u + 0.3 * (t - 0.5) * u * (y0.array() - 14.0);
  }
  std::vector<ParameterEffect> effects() const {
    return {{"t", 0.5, (*this)(0.0, 0.0), (*this)(1.0, 0.0)}, {"u", 0.0, {}, (*this)(0.5, 1.0)}};
  }
};

TEST(ResponseSurface, LearnsFromJointRunsWhatSingleOnesCannotTell) {
  const Multiplying law;
  const ResponseSurface single(law.y0, law.effects());
  const ResponseSurface joint(law.y0, law.effects(), joint_runs(law));
  const VectorXd truth = law(0.9, 0.6);
  EXPECT_GT((single.predict(Eigen::Vector2d(0.9, 0.6)) - truth).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_LT((joint.predict(Eigen::Vector2d(0.9, 0.6)) - truth).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_LT(joint.left_out().cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_LT((joint.predict(Eigen::Vector2d(0.5, 1.0)) - law(0.5, 1.0)).norm(), 1e-12);
  EXPECT_LT((joint.predict(Eigen::Vector2d(0.0, 0.0)) - law(0.0, 0.0)).norm(), 1e-12);
  EXPECT_LT((joint.predict(Eigen::Vector2d(0.5, 0.0)) - law.y0).norm(), 1e-12);

  const Eigen::Vector2d place(0.3, 0.7), step(1e-6, -2e-6);
  const VectorXd difference = (joint.predict(place + step) - joint.predict(place - step)) / 2.0;
  EXPECT_LT((joint.jacobian(place) * step - difference).norm(), 1e-12);
}

TEST(ResponseSurface, HasThePriorsMomentsWithProductsToo) {
  const Multiplying law;
  const MatrixXd no_noise = MatrixXd::Zero(60, 60) + 1e-12 * MatrixXd::Identity(60, 60);
  const NullModel null = null_model(ResponseSurface(law.y0, law.effects(), joint_runs(law)), no_noise);
  const MatrixXd draws = draw_null(null, 20000, 1);
  EXPECT_LT(draws.rowwise().mean().cwiseAbs().maxCoeff(), 0.01);
  EXPECT_LT((draws * draws.transpose() / 20000.0 - null.covariance).norm(), 0.03 * null.covariance.norm());
}

// Where joint runs show nothing but noise, nothing is learnt from them.
TEST(ResponseSurface, StaysAdditiveWhereJointRunsAre) {
  const auto cells = toy::cells();
  const ResponseSurface additive(toy::baseline(cells), toy::parameters(cells));
  const Whitener noise(noise_covariance(cells, toy::noise));
  Random random(3, 0);
  const JointRuns joint = joint_runs([&](double t, double u) -> VectorXd {
    return additive.predict(Eigen::Vector2d(t, u)) + noise.colour(random.normals(60));
  });
  const ResponseSurface learnt(toy::baseline(cells), toy::parameters(cells), joint);
  EXPECT_LT((learnt.predict(Eigen::Vector2d(1.0, 1.0)) - additive.predict(Eigen::Vector2d(1.0, 1.0)))
                .cwiseAbs()
                .maxCoeff(),
            0.02);
  EXPECT_NEAR(std::sqrt(learnt.left_out().squaredNorm() / 1200.0), 0.03, 0.006);
}

TEST(ResponseSurface, RefusesJointRunsOfAnotherShape) {
  const Multiplying law;
  JointRuns joint = joint_runs(law);
  joint.places.conservativeResize(20, 1);
  EXPECT_THROW(ResponseSurface(law.y0, law.effects(), joint), std::invalid_argument);
}

}  // namespace
}  // namespace cpt::diagnosis

// How a push begins: where the points lie, how the cone gets up to its speed, and that none ends up inside
// it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/initial_state.hpp"
#include "solver/point_grid.hpp"
#include "solver/presets.hpp"
#include "solver/simulate.hpp"

namespace cpt::solver {
namespace {

solver::Setup short_push(Profile profile, double to) {
  solver::Setup setup = make_setup(profile, Preset::quick);
  setup.penetrometer.final_depth = to;
  return setup;
}

TEST(StartOfPush, RisesSmoothlyToTheSoilsResistance) {
  Observer observer;
  for (const Profile profile : {Profile::homogeneous_sand, Profile::homogeneous_clay}) {
    solver::Setup setup = short_push(profile, 0.035);
    const std::vector<double> q_c = simulate(setup, observer).profile.q_c;
    const double highest = *std::ranges::max_element(q_c);
    EXPECT_LT(q_c.front(), 0.3 * highest);
    for (std::size_t k = 1; k < q_c.size(); ++k) EXPECT_GT(q_c[k], q_c[k - 1] - 0.1 * highest) << k;

    setup.numerics.start_distance = 0.0;
    const std::vector<double> sudden = simulate(setup, observer).profile.q_c;
    EXPECT_GT(sudden.front(), 2.0 * q_c.front());
  }
}

// How far the innermost point lies inside the cone [m].
double deepest_inside(const solver::Setup& setup) {
  struct Look : Observer {
    double at, R, slope, deepest = 0.0;
    bool looked = false;
    [[nodiscard]] double next_look() const override { return looked ? INFINITY : at; }
    void look(double depth, const MaterialPoints& points) override {
      looked = true;
      for (std::int32_t b = 0; b < points.bucket_count(); ++b) {
        const PointFields p = points.fields(points.bucket(b));
        for (std::int32_t k = 0; k < points.bucket(b).count; ++k) {
          const double above_face = p.z[k] + depth - slope * p.r[k];
          const double to_face = above_face / std::sqrt(1.0 + slope * slope), to_shaft = R - p.r[k];
          deepest = std::max(deepest, std::min(to_face, to_shaft));
        }
      }
    }
  } observer;
  observer.at = setup.penetrometer.final_depth - 1e-3;
  observer.R = setup.penetrometer.diameter / 2.0;
  observer.slope = 1.0 / std::tan(setup.penetrometer.apex / 2.0);
  (void)simulate(setup, observer);
  EXPECT_TRUE(observer.looked);
  return observer.deepest;
}

TEST(StartOfPush, NoPointStaysInsideTheCone) {
  for (const Profile profile : {Profile::homogeneous_sand, Profile::homogeneous_clay})
    EXPECT_LT(deepest_inside(short_push(profile, 0.1)), 1e-4);
}

TEST(StartOfPush, EveryShiftDrawsPlacesCloseToTheGrid) {
  solver::Setup setup = short_push(Profile::homogeneous_clay, 0.1);
  double off = 0.0, square = 0.0, other = 0.0;
  constexpr int points = 20000;
  for (std::uint64_t id = 0; id < points; ++id) {
    const Scatter at = scatter(0.0, id), shifted = scatter(0.25, id);
    EXPECT_LE(std::abs(at.r), farthest_off);
    EXPECT_LE(std::abs(at.z), farthest_off);
    off += at.r + at.z;
    square += at.r * at.r;
    other += at.r * shifted.r;
  }
  // Means of independent uniform numbers, at five standard errors.
  const double variance = farthest_off * farthest_off / 3.0, root = std::sqrt(points);
  EXPECT_LT(std::abs(off / points), 5.0 * std::sqrt(2.0 * variance) / root);
  EXPECT_NEAR(square / points, variance, 0.05 * variance);
  EXPECT_LT(std::abs(other / points), 5.0 * variance / root);

  const auto mass = [&](double shift) {
    setup.numerics.point_shift = shift;
    double sum = 0.0;
    for (const Point& p : initial_state(setup, {}).points) sum += p.mass;
    return sum;
  };
  EXPECT_NEAR(mass(0.4), mass(0.0), 1e-4 * mass(0.0));
}

}  // namespace
}  // namespace cpt::solver

// Looks at the material points during a push: when they come, what they show, and that they change nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "solver/point_states.hpp"
#include "solver/presets.hpp"
#include "solver/simulate.hpp"
#include "solver/step_levels.hpp"

namespace cpt::solver {
namespace {

Setup short_push(Profile profile = Profile::homogeneous_sand) {
  Setup setup = make_setup(profile, Preset::quick);
  setup.penetrometer.final_depth = 0.026;
  return setup;
}

// Looks at these depths and keeps everything it sees.
class Watcher : public Observer {
 public:
  explicit Watcher(std::vector<double> depths) : depths_(std::move(depths)) {}
  double next_look() const override {
    return seen.size() < depths_.size() ? depths_[seen.size()] : std::numeric_limits<double>::infinity();
  }
  void look(double depth, const MaterialPoints& points) override {
    depths_seen.push_back(depth);
    seen.push_back(point_states(points));
  }
  std::vector<double> depths_seen;
  std::vector<std::vector<PointState>> seen;

 private:
  std::vector<double> depths_;
};

TEST(Look, ChangesNoBitOfTheResult) {
  for (const Profile profile : {Profile::homogeneous_sand, Profile::homogeneous_clay}) {
    Observer blind;
    std::vector<double> depths;
    for (int i = 0; i < 80; ++i) depths.push_back(0.0219 + 0.0001 * i);
    Watcher watcher(depths);
    solver::Setup setup = short_push(profile);
    setup.penetrometer.final_depth = 0.03;
    const Outcome unseen = simulate(setup, blind);
    const Outcome seen = simulate(setup, watcher, {2});
    ASSERT_EQ(unseen.status, Status::completed) << unseen.reason;
    EXPECT_GT(watcher.seen.size(), 30U);
    EXPECT_EQ(unseen.profile.depth, seen.profile.depth);
    EXPECT_EQ(unseen.profile.q_c, seen.profile.q_c);
    EXPECT_EQ(unseen.profile.f_s, seen.profile.f_s);
    EXPECT_EQ(unseen.audit.energy_error, seen.audit.energy_error);
    EXPECT_EQ(unseen.steps, seen.steps);
  }
}

TEST(Look, ComesAtTheStartAndWhereAllCellsMeetBeyondEachDepth) {
  const solver::Setup setup = short_push();
  Watcher watcher({0.0, 0.0230, 0.0250, setup.penetrometer.final_depth, 1.0});
  const Outcome outcome = simulate(setup, watcher);
  ASSERT_EQ(watcher.seen.size(), 4U);
  EXPECT_NEAR(watcher.depths_seen[0], 0.02191, 1e-5) << "the shoulder starts level with the soil's top";
  const double cycle = outcome.audit.max_time_step * (1 << highest_level) * setup.penetrometer.speed;
  const double wanted[] = {0.0230, 0.0250, setup.penetrometer.final_depth};
  for (int i = 0; i < 3; ++i) {
    EXPECT_GE(watcher.depths_seen[i + 1], wanted[i]);
    EXPECT_LT(watcher.depths_seen[i + 1], wanted[i] + cycle);
  }
}

TEST(Look, ShowsEveryPointOnceByItsPermanentId) {
  Watcher watcher({0.0, 0.026});
  const Outcome outcome = simulate(short_push(Profile::layered_sand_clay), watcher);
  ASSERT_EQ(watcher.seen.size(), 2U);
  const auto &start = watcher.seen[0], &end = watcher.seen[1];
  ASSERT_EQ(start.size(), static_cast<std::size_t>(outcome.material_points));
  ASSERT_EQ(end.size(), start.size());
  std::set<std::int32_t> materials;
  double farthest = 0.0;
  for (std::size_t k = 0; k < start.size(); ++k) {
    ASSERT_EQ(start[k].id, end[k].id);
    ASSERT_TRUE(k == 0 || start[k].id > start[k - 1].id);
    ASSERT_EQ(start[k].material, end[k].material);
    ASSERT_EQ(std::isnan(end[k].e), end[k].surcharge);
    ASSERT_EQ(end[k].surcharge, end[k].material == 2);
    materials.insert(start[k].material);
    farthest = std::max(farthest, std::hypot(end[k].r - start[k].r, end[k].z - start[k].z));
  }
  EXPECT_EQ(materials.size(), 3U);
  // The tip went 4.1 mm; a point carried along by it cannot have moved much farther.
  EXPECT_GT(farthest, 0.002);
  EXPECT_LT(farthest, 0.006);
}

TEST(Look, StartsFromTheInitialStateInSIUnits) {
  const solver::Setup setup = short_push();
  Watcher watcher({0.0});
  (void)simulate(setup, watcher);
  ASSERT_EQ(watcher.seen.size(), 1U);
  double volume = 0.0;
  for (const PointState& point : watcher.seen[0]) {
    if (point.surcharge) continue;
    volume += point.volume;
    EXPECT_EQ(point.v_r, 0.0);
    EXPECT_EQ(point.v_z, 0.0);
    const double sigma_v = -point.s_zz, sigma_h = -point.s_rr;
    EXPECT_GE(sigma_v, setup.initial.sigma_v0);
    EXPECT_NEAR(sigma_h, 0.5 * sigma_v, 1e-9 * sigma_v);
    EXPECT_NEAR(point.p(), sigma_v * 2.0 / 3.0, 1e-9 * sigma_v);
    EXPECT_NEAR(point.q(), sigma_v * 0.5, 1e-9 * sigma_v);
  }
  // The rows of points need not end at the soil's top.
  const double radius = setup.chamber.radius;
  const double chamber = 3.14159265 * radius * radius * setup.chamber.soil_height;
  EXPECT_NEAR(volume, chamber, 0.005 * chamber);
}

TEST(Look, FindsPointsByIdInTheOrderAsked) {
  struct Finder : Observer {
    double next_look() const override { return done ? 1e9 : 0.024; }
    void look(double, const MaterialPoints& points) override {
      done = true;
      all = point_states(points);
      const std::int64_t ids[] = {all[500].id, all[3].id, -7, all[500].id};
      few = point_states(points, ids);
    }
    bool done = false;
    std::vector<PointState> all, few;
  } finder;
  (void)simulate(short_push(), finder);
  ASSERT_EQ(finder.few.size(), 3U) << "no point has the id -7";
  EXPECT_EQ(finder.few[0].id, finder.all[500].id);
  EXPECT_EQ(finder.few[0].z, finder.all[500].z);
  EXPECT_EQ(finder.few[1].id, finder.all[3].id);
  EXPECT_EQ(finder.few[2].id, finder.all[500].id);
}

}  // namespace
}  // namespace cpt::solver

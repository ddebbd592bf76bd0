// Histories: which points are chosen, what a row says, and the HDF5 file read back.
#include "results/push/histories.hpp"

#include "results/push/history_recorder.hpp"
#include "results/push/point_quantities.hpp"
#include "tests/results/campaign_fixture.hpp"
#include "tests/results/push_recording.hpp"

namespace cpt::results {
namespace {

// Two columns of points, the outer one beside the wall; id 7 is surcharge.
std::vector<solver::PointState> chamber() {
  std::vector<solver::PointState> points = {point(1, 0.1, 0.25),  point(2, 0.1, 0.75),  point(3, 0.4, 0.125),
                                            point(4, 0.4, 0.375), point(5, 0.4, 0.625), point(6, 0.4, 0.875),
                                            point(7, 0.4, -0.125)};
  points.back().material = 2;
  points.back().surcharge = true;
  return points;
}

solver::MaterialPoints stored(const std::vector<solver::PointState>& states) {
  std::vector<solver::Point> points;
  std::vector<std::int32_t> buckets;
  for (const solver::PointState& s : states) {
    const double volume_per_radian = s.volume / (2.0 * 3.14159265358979323846);
    points.push_back({s.r, s.z, s.v_r, s.v_z, s.s_rr, s.s_zz, s.s_tt, s.s_rz, 1.0, volume_per_radian, s.e,
                      s.h_0, 0.0, 0.0, 0.0, static_cast<double>(s.id), 0.0});
    buckets.push_back(static_cast<std::int32_t>(s.material));
  }
  return {points, buckets, 1, 3};
}

TEST(HistoryRecorder, FollowsTheNearestPointsOfTheSoil) {
  const HistoryRecorder recorder({{0.12, 0.7}, {0.4, 0.0}}, {{0.1, 0.5}, {0.49, 0.51}}, chamber(), {});
  const Histories& chosen = recorder.histories();
  ASSERT_EQ(chosen.points.size(), 2U);
  EXPECT_EQ(chosen.points[0].id, 2);
  EXPECT_EQ(chosen.points[0].start, (Place{0.1, 0.75}));
  EXPECT_EQ(chosen.points[1].id, 3) << "not the surcharge, though it is as near";
  ASSERT_EQ(chosen.walls.size(), 2U);
  EXPECT_EQ(chosen.walls[0].points, 2);
  EXPECT_EQ(chosen.walls[1].points, 1) << "none between: the nearest";
}

TEST(HistoryRecorder, RowsHoldEveryQuantityAndWallStressesArePositiveInCompression) {
  std::vector<solver::PointState> states = chamber();
  HistoryRecorder recorder({{0.1, 0.75}}, {{0.1, 0.5}}, states, {});
  recorder.add(0.02, stored(states));
  states[1].z -= 0.01;
  states[1].e += 0.05;
  states[3].s_rr = -9e3;
  states[3].volume = 3.0 * states[2].volume;
  recorder.add(0.03, stored(states));

  const Histories& histories = recorder.histories();
  EXPECT_EQ(histories.tip_depth, (std::vector<double>{0.02, 0.03}));
  const HistoryColumns& tracked = histories.points[0].columns;
  std::size_t columns = 0;
  for (const PointQuantity& quantity : point_quantities({}))
    columns += std::max<std::size_t>(1, quantity.components.size());
  EXPECT_EQ(tracked.size(), columns);
  EXPECT_EQ(tracked.at("displacement_r").values, (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(tracked.at("displacement_z").values[0], 0.0);
  EXPECT_NEAR(tracked.at("displacement_z").values[1], -0.01, 1e-15);
  EXPECT_NEAR(tracked.at("void_ratio_change").values[1], 0.05, 1e-15);
  EXPECT_EQ(tracked.at("stress_zz").values[0], -4e3);
  EXPECT_EQ(tracked.at("stress_zz").unit, "Pa");
  EXPECT_EQ(tracked.at("velocity_r").unit, "m/s");

  // Points 3 and 4: equal volumes at first, then the second weighs three times the first.
  const HistoryColumns& wall = histories.walls[0].columns;
  EXPECT_NEAR(wall.at("sigma_r").values[0], 3.5e3, 1e-9);
  EXPECT_NEAR(wall.at("sigma_v").values[0], 7e3, 1e-9);
  EXPECT_NEAR(wall.at("sigma_r").values[1], 0.25 * 3e3 + 0.75 * 9e3, 1e-9);
}

class HistoryFile : public ScratchFolder {
 protected:
  HistoryFile() {
    HistoryRecorder recorder({{0.1, 0.75}, {0.4, 0.1}}, {{0.1, 0.5}}, chamber(), {});
    for (const double depth : {0.02, 0.03, 0.04}) recorder.add(depth, stored(chamber()));
    written = recorder.histories();
    written.origin["study"] = "sand";
    written.origin["setup"] = "a = 1\nb = 2\n";
    written.profile = curve(1e6);
    written.end = soil_at_end(chamber(), chamber());
  }
  Histories written;
};

TEST_F(HistoryFile, IsReadBackBitForBit) {
  write_histories(folder / "h.h5", written);
  const Histories read = read_histories(folder / "h.h5");
  EXPECT_EQ(read.tip_depth, written.tip_depth);
  EXPECT_EQ(read.points, written.points);
  EXPECT_EQ(read.walls, written.walls);
  EXPECT_EQ(read.profile.q_c, written.profile.q_c);
  EXPECT_EQ(read.end.r.size(), 6U) << "the surcharge is no soil";
  EXPECT_EQ(read.end, written.end);
  EXPECT_EQ(read.origin.at("study"), "sand");
  EXPECT_EQ(read.origin.at("setup"), "a = 1\nb = 2\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "h.h5.tmp"));
}

TEST_F(HistoryFile, MayHoldNothingButTheProfile) {
  Histories empty;
  empty.profile = written.profile;
  write_histories(folder / "h.h5", empty);
  const Histories read = read_histories(folder / "h.h5");
  EXPECT_TRUE(read.points.empty());
  EXPECT_TRUE(read.walls.empty());
  EXPECT_TRUE(read.end.r.empty());
  EXPECT_TRUE(read.tip_depth.empty());
  EXPECT_EQ(read.profile.f_s, written.profile.f_s);
}

TEST_F(HistoryFile, ErrorsNameTheFile) {
  EXPECT_THROW(write_histories(folder / "nowhere" / "h.h5", written), Error);
  std::ofstream(folder / "text.h5") << "not HDF5 at all";
  for (const char* name : {"text.h5", "missing.h5"}) {
    try {
      (void)read_histories(folder / name);
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace cpt::results

// A real push of two millimetres, recorded.
#include "results/push/push_recorder.hpp"

#include "tests/results/campaign_fixture.hpp"
#include "tests/results/push_recording.hpp"

namespace cpt::results {
namespace {

class Recorded : public ScratchFolder {
 protected:
  FieldSeries fields{folder / "fields", "sand", "origin", point_quantities(solver::Setup{})};
  solver::Setup setup = short_push();
};

TEST_F(Recorded, RowsComeAtTheStartAndTheEndOfEachBin) {
  PushRecorder recorder({{}, {{0.0253, 0.1}}, {{0.1, 0.2}}}, setup, fields);
  const solver::Outcome outcome = simulate(setup, recorder);
  ASSERT_EQ(outcome.status, solver::Status::completed) << outcome.reason;
  const Histories histories = recorder.histories();
  const double step = 2.0 * outcome.audit.max_time_step * setup.penetrometer.speed;
  // 21.91 mm, then 22.0, 22.5, 23.0, 23.5 and the end at 23.9 mm.
  ASSERT_EQ(histories.tip_depth.size(), 6U);
  const double depths[] = {0.02191, 0.0220, 0.0225, 0.0230, 0.0235, 0.0239};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(histories.tip_depth[i], depths[i], step + 1e-5) << i;
  const HistoryColumns& tracked = histories.points.at(0).columns;
  EXPECT_EQ(tracked.at("displacement_z").values[0], 0.0);
  EXPECT_NE(tracked.at("displacement_z").values[5], 0.0);
  const HistoryColumns& wall = histories.walls.at(0).columns;
  EXPECT_NEAR(wall.at("sigma_r").values[0] / wall.at("sigma_v").values[0], 0.5, 1e-9) << "K_0";
}

TEST_F(Recorded, FieldsAreWrittenAtTheirDepthsAndBothEndsAreKept) {
  PushRecorder recorder({{0.0, 0.0225, setup.penetrometer.final_depth}, {}, {}}, setup, fields);
  const solver::Outcome outcome = simulate(setup, recorder);
  EXPECT_EQ(fields.size(), 3U);
  for (const char* file : {"sand-0m.vtu", "sand-0.0225m.vtu", "sand-0.0239m.vtu"})
    EXPECT_TRUE(std::filesystem::exists(folder / "fields" / file)) << file;
  EXPECT_TRUE(recorder.histories().tip_depth.empty()) << "nothing was to be followed";
  EXPECT_EQ(recorder.start().size(), static_cast<std::size_t>(outcome.material_points));
  EXPECT_EQ(recorder.end().size(), recorder.start().size());
  EXPECT_NO_THROW(recorder.rethrow());
}

TEST_F(Recorded, RecordingChangesNoBitOfTheResult) {
  solver::Observer blind;
  PushRecorder recorder({{0.022, 0.023}, {{0.02, 0.1}}, {{0.1, 0.2}}}, setup, fields);
  const solver::Outcome unseen = simulate(setup, blind), seen = simulate(setup, recorder);
  EXPECT_EQ(unseen.profile.q_c, seen.profile.q_c);
  EXPECT_EQ(unseen.profile.f_s, seen.profile.f_s);
  EXPECT_EQ(unseen.steps, seen.steps);
}

TEST_F(Recorded, AFieldThatCannotBeWrittenEndsTheRecordingWithItsReason) {
  std::filesystem::create_directories(folder / "fields" / "sand-0m.vtu");
  PushRecorder recorder({{0.0}, {}, {}}, setup, fields);
  const solver::Outcome outcome = simulate(setup, recorder);
  EXPECT_NE(outcome.status, solver::Status::did_not_converge) << outcome.reason;
  EXPECT_TRUE(recorder.end().empty());
  EXPECT_THROW(recorder.rethrow(), Error);
}

}  // namespace
}  // namespace cpt::results

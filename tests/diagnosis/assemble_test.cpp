// Made-up campaigns whose curves follow known laws.
#include "diagnosis/assemble.hpp"

#include <cmath>

#include "parameters/all_realizations.hpp"
#include "tests/diagnosis/request_fixture.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::diagnosis {
namespace {

// ln q_c of any setup: additive in the study's parameters, and what surface compaction adds.
double law(const solver::Setup& setup, double depth) {
  const double compaction = setup.mechanisms.surface_compaction.at(depth);
  return std::log(3e6 * std::sqrt(depth)) + 1.5 * (solver::sand_of(setup).D_r - 0.36) +
         0.01 * (solver::sand_of(setup).H - 25.0) + setup.initial.sigma_v0 / 50e3 - 1.0 + 0.8 * compaction +
         0.01 * setup.numerics.point_shift;
}

class Assembling : public ::testing::Test {
 protected:
  Assembling() {
    request = request_of(
        "study = \"sand.toml\"\nmechanisms = [\"surface_compaction\", \"cushion_transfer\"]\n" + sounding);
    SoundingData data{request.soundings[0],
                      sounding_study(quick_sand(), request.soundings[0], request.mechanisms, request.repeats,
                                     request.joint),
                      {},
                      {}};
    for (const parameters::Realization& realization : parameters::all_realizations(data.study.study)) {
      const solver::Setup setup = parameters::make_setup(data.study.study, realization);
      results::CurveRow curve{realization.id, {}};
      for (double depth = 0.02025; depth < 0.30; depth += 0.0005) {
        curve.profile.depth.push_back(depth);
        curve.profile.q_c.push_back(std::exp(law(setup, depth)));
      }
      results::RealizationRow row;
      row.id = realization.id;
      row.status = "completed";
      data.campaign.realizations.push_back(row);
      data.campaign.curves.push_back(curve);
    }
    record(data, [](double depth) { return 3e6 * std::sqrt(depth); });
    soundings.push_back(std::move(data));
  }
  template <class Curve>
  static void record(SoundingData& data, const Curve& q_c) {
    data.recording.readings.clear();
    for (double depth = 0.0005; depth < 0.30; depth += 0.001) {
      recordings::Reading reading;
      reading.depth = depth;
      reading.q_c = q_c(depth);
      data.recording.readings.push_back(reading);
    }
  }
  [[nodiscard]] std::string message() const {
    try {
      (void)assemble(request, soundings);
    } catch (const std::invalid_argument& problem) {
      return problem.what();
    }
    return "";
  }
  Request request;
  std::vector<SoundingData> soundings;
};

TEST_F(Assembling, PutsEveryRunInItsPlace) {
  const Assembled made = assemble(request, soundings);
  const Problem& problem = made.problem;
  EXPECT_EQ(problem.cells.size(), 48U);
  EXPECT_TRUE(made.remarks.empty());
  ASSERT_EQ(problem.parameters.size(), 3U);
  EXPECT_NEAR((problem.parameters[0].upper - problem.baseline).mean(), 0.15, 1e-9);
  EXPECT_EQ(problem.parameters[1].lower.size(), 0);
  EXPECT_DOUBLE_EQ(problem.parameters[1].baseline, 0.0);
  EXPECT_NEAR((problem.recorded - problem.baseline).cwiseAbs().maxCoeff(), 0.0, 1e-3);
  EXPECT_EQ(problem.repeats.cols(), 8);
  const ResponseSurface surface(problem.baseline, problem.parameters, problem.joint);
  EXPECT_NEAR(surface.left_out().cwiseAbs().maxCoeff(), 0.0, 1e-9);  // the law is additive
  ASSERT_EQ(problem.mechanisms.size(), 2U);
  const MechanismEffect& compaction = problem.mechanisms[0];
  EXPECT_TRUE(compaction.vanishes_at_zero);
  const double increase = 0.4 * compaction.design(0, 0), decay = 0.02 + 0.1 * compaction.design(0, 1);
  EXPECT_NEAR(compaction.delta(0, 0), 0.8 * increase * std::exp(-0.0425 / decay), 2e-3);
  EXPECT_FALSE(problem.mechanisms[1].vanishes_at_zero);  // its prior goes from a gain to a loss
}

TEST_F(Assembling, MechanismsOfTheReadingAreReadFromTheRunsAtHand) {
  request = request_of("study = \"sand.toml\"\nmechanisms = [\"depth_datum\", \"zero_offset\"]\n" + sounding);
  soundings[0].study =
      sounding_study(quick_sand(), request.soundings[0], request.mechanisms, request.repeats, request.joint);
  const Assembled made = assemble(request, soundings);
  ASSERT_EQ(made.problem.mechanisms.size(), 2U);
  const MechanismEffect &datum = made.problem.mechanisms[0], &offset = made.problem.mechanisms[1];
  const std::vector<Cell>& cells = made.problem.cells;
  const Index last = datum.delta.cols() - 1;
  EXPECT_DOUBLE_EQ(datum.design(last, 0), 1.0);
  const auto n = static_cast<Index>(cells.size());
  for (Index i = 10; i < n; ++i) {  // ln q = 0.5 ln z + constant
    const double z = cells[static_cast<std::size_t>(i)].depth;
    EXPECT_NEAR(datum.delta(i, last), 0.5 * std::log((z - 0.025) / z), 2e-3);
    EXPECT_NEAR(offset.delta(i, last), std::log1p(400e3 / (3e6 * std::sqrt(z))), 1e-3);
  }
  EXPECT_NEAR(datum.delta.col(last / 2).cwiseAbs().maxCoeff(), 0.0, 1e-12);  // no shift
  EXPECT_EQ(offset.joint_delta.cols(), request.joint);
}

TEST_F(Assembling, AReadingThatIsOnlyEverTooHighVanishesAtZero) {
  request = request_of("study = \"sand.toml\"\nmechanisms = [\"sleeve_load\", \"gain_drift\"]\n" + sounding);
  soundings[0].study =
      sounding_study(quick_sand(), request.soundings[0], request.mechanisms, request.repeats, request.joint);
  const Assembled made = assemble(request, soundings);
  ASSERT_EQ(made.problem.mechanisms.size(), 2U);
  EXPECT_TRUE(made.problem.mechanisms[0].vanishes_at_zero);   // from 0
  EXPECT_FALSE(made.problem.mechanisms[1].vanishes_at_zero);  // from too low to too high
}

TEST_F(Assembling, LeavesOutWhatFailedAndSaysSo) {
  const parameters::Study& study = soundings[0].study.study;
  for (const parameters::Realization& realization : parameters::all_realizations(study))
    for (const char* name : {"cushion_transfer 5", "cushion_transfer joint 2"})
      if (parameters::parameter_name(study, realization) == name)
        soundings[0].campaign.realizations[static_cast<std::size_t>(realization.id - 1)].status =
            "did_not_converge";
  const Assembled made = assemble(request, soundings);
  ASSERT_EQ(made.remarks.size(), 2U);
  EXPECT_NE(made.remarks[0].find("cushion_transfer 5"), std::string::npos);
  EXPECT_NE(made.remarks[1].find("cushion_transfer joint 2"), std::string::npos);
  EXPECT_EQ(made.problem.mechanisms[1].delta.cols(), 4);
  EXPECT_EQ(made.problem.mechanisms[1].joint_delta.cols(), 2);
}

TEST_F(Assembling, AFailedBaselineIsAnError) {
  soundings[0].campaign.realizations.front().status = "energy_drift";
  EXPECT_NE(message().find("baseline"), std::string::npos);
}

TEST_F(Assembling, RecordingsThatDoNotFitAreErrors) {
  SoundingData& data = soundings[0];
  record(data, [](double depth) { return 3e9 * std::sqrt(depth); });
  EXPECT_NE(message().find("mind its unit"), std::string::npos);
  record(data, [](double) { return 1e6; });
  EXPECT_NE(message().find("constant column"), std::string::npos);
  record(data, [](double) { return std::nan(""); });
  EXPECT_NE(message().find("no q_c at all"), std::string::npos);
  record(data, [](double depth) { return 3e6 * std::sqrt(depth); });
  for (recordings::Reading& reading : data.recording.readings) reading.depth *= 1000.0;
  EXPECT_NE(message().find("no overlap in depth"), std::string::npos);
  data.recording.readings.resize(1);
  data.recording.readings[0].depth = 0.1;
  EXPECT_NE(message().find("10 are needed"), std::string::npos);
}

// A push not made yet is its baseline; what is known of f_s is a third of what is known of q_c.
TEST_F(Assembling, UnmeasuredPushesAreTheirBaselines) {
  for (results::CurveRow& curve : soundings[0].campaign.curves)
    for (const double q_c : curve.profile.q_c) curve.profile.f_s.push_back(0.01 * q_c * q_c / 1e6);
  soundings[0].recording.readings.clear();
  const NoiseModel noise{Kernel::ar1, 0.02, 0.01};
  const Problem tip = assemble_unmeasured(request, soundings, solver::channel("q_c"), noise).problem;
  const Problem sleeve = assemble_unmeasured(request, soundings, solver::channel("f_s"), noise).problem;
  EXPECT_EQ(tip.recorded, tip.baseline);
  EXPECT_EQ(sleeve.recorded, sleeve.baseline);
  EXPECT_DOUBLE_EQ(tip.measurement->deviation, 0.02);
  EXPECT_DOUBLE_EQ(sleeve.measurement->deviation, 0.06);
  ASSERT_EQ(tip.mechanisms.size(), 2U);
  // f_s grows as the square of q_c here: every effect counts double.
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR((sleeve.mechanisms[k].delta - 2.0 * tip.mechanisms[k].delta).cwiseAbs().maxCoeff(), 0.0,
                1e-4);
}

}  // namespace
}  // namespace cpt::diagnosis

#include "diagnosis/design.hpp"

#include <algorithm>
#include <set>

#include "diagnosis/prior_range.hpp"
#include "parameters/all_realizations.hpp"
#include "tests/diagnosis/request_fixture.hpp"

namespace cpt::diagnosis {
namespace {

SoundingStudy made(const std::string& more = "") {
  const Request request = request_of("study = \"sand.toml\"\n" + sounding + more);
  return sounding_study(quick_sand(), request.soundings[0], request.mechanisms, request.repeats,
                        request.joint);
}

TEST(Design, EveryRunIsPossibleAndDifferent) {
  const SoundingStudy sounding_runs = made();
  std::set<std::string> names, settings;
  for (const parameters::Realization& realization : parameters::all_realizations(sounding_runs.study)) {
    const solver::Setup setup = parameters::make_setup(sounding_runs.study, realization);
    for (const solver::Problem& problem : solver::problems(setup))
      ADD_FAILURE() << parameters::parameter_name(sounding_runs.study, realization) << ": "
                    << problem.message;
    settings.insert(parameters::settings_text(sounding_runs.study, realization));
    if (realization.side == parameters::Side::point)
      names.insert(std::string(parameters::parameter_name(sounding_runs.study, realization)));
  }
  EXPECT_EQ(names.size(), sounding_runs.study.points.size());
  EXPECT_EQ(settings.size(), parameters::all_realizations(sounding_runs.study).size());
}

TEST(Design, FillsThePriorOfEachMechanism) {
  const SoundingStudy sounding_runs = made();
  ASSERT_GE(sounding_runs.design.mechanisms.size(), 9U);
  for (const MechanismDesign& design : sounding_runs.design.mechanisms) {
    const Index dimensions = design.unit.cols();
    EXPECT_GE(design.unit.rows(), 4 * dimensions) << design.mechanism.name;
    EXPECT_GE(design.unit.minCoeff(), 0.0);
    EXPECT_LE(design.unit.maxCoeff(), 1.0);
    for (Index j = 0; j < dimensions; ++j)
      EXPECT_GT(design.unit.col(j).maxCoeff() - design.unit.col(j).minCoeff(), 0.7) << design.mechanism.name;
    if (design.mechanism.of_reading) continue;  // it has no runs
    for (Index k = 0; k < design.unit.rows(); ++k) {
      const auto& point = sounding_runs.study.points[design.first_point + static_cast<std::size_t>(k)];
      EXPECT_EQ(point.name.find(design.mechanism.name), 0U);
      const auto& parameter = design.mechanism.parameters[design.varied[0]];
      EXPECT_DOUBLE_EQ(point.changes[design.varied[0]].value, prior_value(parameter, design.unit(k, 0)));
    }
  }
}

TEST(Design, EachMechanismAlsoRunsInOtherSoil) {
  const SoundingStudy plain = made(), known = made("fixed = { \"initial.sigma_v0_kPa\" = 60 }\n");
  for (const MechanismDesign& design : plain.design.mechanisms) {
    if (design.mechanism.of_reading) {
      EXPECT_EQ(design.joint_unit.rows(), static_cast<Index>(plain.design.joint));
      continue;
    }
    ASSERT_EQ(design.joint_unit.rows(), 3);
    for (Index k = 0; k < 3; ++k) {
      const std::size_t at = design.first_joint + static_cast<std::size_t>(k);
      const auto& point = plain.study.points[at];
      EXPECT_EQ(point.name, std::string(design.mechanism.name) + " joint " + std::to_string(k + 1));
      EXPECT_EQ(point.changes.size(), design.varied.size() + plain.study.rows.size());
      // Where an input is known, the others are the same as where it is not.
      const auto& beside = known.study.points[at];
      ASSERT_EQ(beside.changes.size(), point.changes.size() - 1);
      for (const parameters::Change& change : beside.changes)
        EXPECT_TRUE(std::ranges::any_of(point.changes, [&](const parameters::Change& other) {
          return other.quantity == change.quantity && other.value == change.value;
        })) << change.quantity->name;
    }
  }
}

TEST(Design, AMechanismOfTheReadingCostsNoRun) {
  for (const parameters::DesignPoint& point : made().study.points)
    for (const char* name :
         {"depth_datum", "zero_offset", "zero_drift", "gain_drift", "sleeve_load", "inclination"})
      EXPECT_EQ(point.name.find(name), std::string::npos) << point.name;
}

TEST(Design, WhatAMechanismDoesNotVaryIsTheStudys) {
  parameters::Study study = quick_sand();
  study.baseline.mechanisms.previous_push.depth = 0.6;
  const Request request = request_of("study = \"sand.toml\"\n" + sounding);
  const SoundingStudy runs =
      sounding_study(study, request.soundings[0], request.mechanisms, request.repeats, request.joint);
  int pushed_before = 0;
  for (const parameters::Realization& realization : parameters::all_realizations(runs.study)) {
    const solver::Setup setup = parameters::make_setup(runs.study, realization);
    if (!setup.mechanisms.previous_push.on()) continue;
    EXPECT_EQ(setup.mechanisms.previous_push.depth, 0.6);
    ++pushed_before;
  }
  EXPECT_GE(pushed_before, 9);
}

TEST(Design, WhatIsKnownIsNoLongerUncertain) {
  const SoundingStudy plain = made(), known = made("fixed = { \"initial.sigma_v0_kPa\" = 60 }\n");
  EXPECT_EQ(plain.study.rows.size(), known.study.rows.size() + 1);
  EXPECT_DOUBLE_EQ(known.study.baseline.initial.sigma_v0, 60e3);
  EXPECT_EQ(plain.study.database, "/studies/sand-diagnosis.sqlite");
  EXPECT_NE(plain.study.database, known.study.database);
}

TEST(Design, WhatIsKnownHoldsInTheMechanismsRunsToo) {
  const SoundingStudy first = made("fixed = { \"previous_push.share\" = 0 }\n");
  for (const parameters::Realization& realization : parameters::all_realizations(first.study))
    EXPECT_FALSE(parameters::make_setup(first.study, realization).mechanisms.previous_push.on());
  const SoundingStudy second = made();
  EXPECT_TRUE(std::ranges::any_of(parameters::all_realizations(second.study), [&](const auto& realization) {
    return parameters::make_setup(second.study, realization).mechanisms.previous_push.on();
  }));
}

}  // namespace
}  // namespace cpt::diagnosis

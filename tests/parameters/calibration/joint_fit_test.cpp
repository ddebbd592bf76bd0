// Parameters come back from tests of a sand that has them, and intervals say how far they may be off.
#include "parameters/calibration/joint_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "solver/constitutive/critical_state_line.hpp"
#include "tests/parameters/calibration/synthetic_tests.hpp"

namespace cpt::calibration {
namespace {

constexpr ReadingScatter clean = {0.0, 0.0, 0.0, 0.0};
const std::vector<SpecimenState> four = {{0.62, 50e3}, {0.66, 300e3}, {0.80, 100e3}, {0.82, 400e3}};

std::vector<const FitParameter*> named(const std::vector<std::string_view>& names) {
  std::vector<const FitParameter*> list;
  for (const std::string_view name : names) list.push_back(find_fit_parameter(name));
  return list;
}

// Table 2, with what is not fitted as in the other sand.
solver::NorSandParameters start(const std::vector<const FitParameter*>& free) {
  solver::NorSandParameters sand = other_sand();
  for (const FitParameter* parameter : free) parameter->set(sand, parameter->of({}));
  return sand;
}

TEST(FitParameters, HaveTheStudysUnitsAndRanges) {
  EXPECT_EQ(fit_parameters().size(), 10U);
  const FitParameter& phi = *find_fit_parameter("phi_cs_deg");
  solver::NorSandParameters sand;
  EXPECT_NEAR(phi.of(sand), 30.0, 1e-12);
  phi.set(sand, 33.0);
  EXPECT_NEAR(sand.phi_cs, 33.0 * std::acos(-1.0) / 180.0, 1e-12);
  const FitParameter& H = *find_fit_parameter("H");
  EXPECT_TRUE(H.logarithmic);
  EXPECT_DOUBLE_EQ(H.lower(), 0.0);
  EXPECT_DOUBLE_EQ(H.upper(), std::log(2000.0));
  EXPECT_EQ(find_fit_parameter("D_r_percent"), nullptr);
}

TEST(SimulatedTests, ObservationsAreWhatWasRead) {
  const LaboratoryTests tests = synthetic_tests(other_sand(), {{0.7, 100e3}}, 0.8, clean, 1);
  const SimulatedTests simulated(tests);
  ASSERT_EQ(simulated.observations().size(), 80U + 80U + 1U + 24U);
  std::vector<double> values;
  EXPECT_EQ(simulated.run(other_sand(), values), "");
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(values[i], simulated.observations()[i].measured,
                1e-5);  // rows between which one is interpolated
  // The law's shear modulus is that of G_ref, b and the void ratio.
  EXPECT_NEAR(small_strain_modulus(tests.triaxial[0], other_sand()), 620.0 * 100e3 / (0.7 - 0.051), 1.0);
}

TEST(FirstEstimates, EndsAndPeaksTellTheCriticalStateAndTheDilatancy) {
  const auto free = named({"e_cs0", "lambda", "phi_cs_deg", "N", "chi_tc", "G_ref", "b"});
  const LaboratoryTests tests = synthetic_tests(other_sand(), four, 0.0, clean, 1);
  const FirstEstimates found = first_estimates(tests, start(free), free);
  ASSERT_EQ(found.states.size(), 4U);
  for (const TestStates& states : found.states) {
    EXPECT_LE(states.D_peak, states.D_end + 0.05);
    EXPECT_EQ(states.critical, std::abs(states.D_end) <= 0.05 && std::abs(states.q_change) <= 0.05);
  }
  const auto off = [&](std::string_view name) {
    const FitParameter& parameter = *find_fit_parameter(name);
    return std::abs(parameter.scaled(parameter.of(found.sand)) -
                    parameter.scaled(parameter.of(other_sand()))) /
           parameter.range();
  };
  EXPECT_LT(off("phi_cs_deg"), 0.05);
  EXPECT_LT(off("N"), 0.15);
  EXPECT_LT(off("chi_tc"), 0.15);
  EXPECT_LT(off("e_cs0"), 0.05);
  EXPECT_LT(off("G_ref"), 1e-6);
  EXPECT_LT(off("b"), 1e-6);
}

TEST(JointFit, CleanTestsGiveTheSandBack) {
  const auto free = named({"e_cs0", "lambda", "G_ref", "phi_cs_deg", "N", "chi_tc", "H"});
  const JointFit fit = fit_jointly(synthetic_tests(other_sand(), four, 0.0, clean, 1), start(free), free);
  ASSERT_EQ(fit.problem, "");
  for (const ParameterFit& one : fit.parameters) {
    EXPECT_TRUE(one.told) << one.remark;
    EXPECT_NEAR(one.value, one.parameter->of(other_sand()), 0.01 * one.parameter->of(other_sand()))
        << one.parameter->quantity->name;
  }
}

TEST(JointFit, TheTruthLiesWhereTheCovarianceSays) {
  const auto free = named({"e_cs0", "lambda", "phi_cs_deg", "N", "chi_tc", "H"});
  const ReadingScatter scatter;
  const JointFit fit = fit_jointly(synthetic_tests(other_sand(), four, 0.80, scatter, 1), start(free), free);
  ASSERT_EQ(fit.problem, "");
  const auto n = static_cast<Eigen::Index>(free.size());
  ASSERT_EQ(fit.correlation.rows(), n);
  Eigen::VectorXd off(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const ParameterFit& one = fit.parameters[static_cast<std::size_t>(j)];
    ASSERT_TRUE(one.told) << one.remark;
    EXPECT_LT(one.low, one.value);
    EXPECT_GT(one.high, one.value);
    off(j) = (one.parameter->scaled(one.value) - one.parameter->scaled(one.parameter->of(other_sand()))) /
             one.standard_deviation;
    EXPECT_NEAR(fit.correlation(j, j), 1.0, 1e-9);
  }
  const double distance = off.dot(fit.correlation.ldlt().solve(off));
  EXPECT_LT(distance, 22.46);  // 99.9 % of chi-squared with 6 degrees of freedom
  // The scatter of the readings is found, too, within what some hundred readings tell.
  EXPECT_NEAR(fit.channels[0].scatter / scatter.q, 1.0, 0.2);
  EXPECT_NEAR(fit.channels[1].scatter / scatter.eps_v, 1.0, 0.2);
  EXPECT_NEAR(fit.channels[2].scatter / scatter.e, 1.0, 0.6);
  EXPECT_NEAR(fit.misfit(0, 0) / scatter.q, 1.0, 0.4);
}

TEST(JointFit, WhatTheTestsDoNotTellStaysAsGiven) {
  // The first few per cent of strain of one test: nothing tells how the critical state line bends.
  LaboratoryTests tests = synthetic_tests(other_sand(), {{0.70, 200e3}}, 0.0, {}, 3);
  tests.triaxial[0].readings.resize(12);
  const auto free = named({"lambda", "m", "H", "phi_cs_deg"});
  const JointFit fit = fit_jointly(tests, start(free), free);
  ASSERT_EQ(fit.problem, "");
  int told = 0;
  for (const ParameterFit& one : fit.parameters) {
    told += one.told ? 1 : 0;
    if (one.told) continue;
    EXPECT_DOUBLE_EQ(one.value, one.given);
    EXPECT_NE(one.remark.find("not told by these tests"), std::string::npos) << one.remark;
    EXPECT_TRUE(std::isnan(one.low));
  }
  EXPECT_GT(told, 0);
  EXPECT_LT(told, 4);
}

TEST(JointFit, ReadingsThatShareAnErrorCountForFewer) {
  LaboratoryTests tests = synthetic_tests(other_sand(), four, 0.0, {}, 5);
  const auto free = named({"phi_cs_deg", "H"});
  const JointFit independent = fit_jointly(tests, start(free), free);
  for (TriaxialCurve& curve : tests.triaxial)
    for (std::size_t i = 1; i < curve.readings.size(); ++i)
      curve.readings[i].q *= 1.0 + 0.03 * std::sin(0.2 * static_cast<double>(i));
  const JointFit shared = fit_jointly(tests, start(free), free);
  EXPECT_LT(independent.channels[0].inflation, 1.5);
  EXPECT_GT(shared.channels[0].autocorrelation, 0.5);
  EXPECT_GT(shared.channels[0].inflation, 3.0);
}

TEST(JointFit, SameTestsGiveTheSameBits) {
  const auto free = named({"phi_cs_deg", "H"});
  const LaboratoryTests tests = synthetic_tests(other_sand(), {{0.7, 100e3}}, 0.0, {}, 1);
  const JointFit one = fit_jointly(tests, start(free), free), other = fit_jointly(tests, start(free), free);
  for (std::size_t j = 0; j < one.parameters.size(); ++j)
    EXPECT_EQ(one.parameters[j].value, other.parameters[j].value);
}

TEST(JointFit, SaysWhyThereIsNone) {
  LaboratoryTests tests = synthetic_tests(other_sand(), {{0.7, 100e3}}, 0.0, {}, 1);
  tests.triaxial[0].readings.resize(3);
  for (Reading& reading : tests.triaxial[0].readings) reading.eps_v = not_given;
  tests.triaxial[0].G_0 = not_given;
  const auto free = named({"phi_cs_deg", "H", "N", "chi_tc"});
  EXPECT_EQ(fit_jointly(tests, other_sand(), free).problem, "2 readings cannot tell 4 parameters");
}

}  // namespace
}  // namespace cpt::calibration

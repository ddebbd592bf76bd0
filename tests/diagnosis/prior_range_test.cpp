#include "diagnosis/prior_range.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/mechanisms/catalogue.hpp"

namespace cpt::diagnosis {
namespace {

TEST(PriorRange, TakesPlacesToValuesBetweenTheEnds) {
  const solver::Mechanism& datum = *solver::find_mechanism("depth_datum");
  const solver::MechanismParameter& shift = datum.parameters.front();  // -25 to 25 mm
  EXPECT_EQ(prior_value(shift, 0.0), shift.prior_lower);
  EXPECT_EQ(prior_value(shift, 1.0), shift.prior_upper);
  EXPECT_EQ(prior_value(shift, 0.3), shift.prior_lower + 0.3 * (shift.prior_upper - shift.prior_lower));
  EXPECT_DOUBLE_EQ(prior_deviation(shift, 0.4, 0.1), 0.1 * (shift.prior_upper - shift.prior_lower));
  const parameters::Row row{&shift.quantity, 0.0, shift.prior_lower, shift.prior_upper};
  EXPECT_EQ(row_value(row, 0.3), prior_value(shift, 0.3));
}

// Two of three within a quarter of the range to either side, half of them within an eighth of that.
TEST(PriorRange, FaultsOfTheInstrumentAreMostlySmall) {
  const solver::MechanismParameter& gain = solver::find_mechanism("gain_drift")->parameters.front();
  ASSERT_EQ(gain.prior, solver::Prior::accuracy);
  EXPECT_DOUBLE_EQ(prior_value(gain, 0.0), gain.prior_lower);
  EXPECT_DOUBLE_EQ(prior_value(gain, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(prior_value(gain, 1.0), gain.prior_upper);
  EXPECT_DOUBLE_EQ(prior_value(gain, 0.75), gain.prior_upper / 8.0);
  EXPECT_NEAR(prior_value(gain, 0.5 + 0.5 * std::cbrt(0.25)), 0.25 * gain.prior_upper, 1e-12);
  EXPECT_GT(std::cbrt(0.25), 0.62);
  EXPECT_NEAR(prior_deviation(gain, 0.9, 0.001), 3.0 * 0.8 * 0.8 * 0.001 * 2.0 * gain.prior_upper, 1e-6);
}

TEST(PriorRange, KeepsToWholeNumbersAndChoices) {
  solver::Quantity whole = *solver::find_quantity("sand.H");
  whole.integer = true;
  EXPECT_EQ(row_value({&whole, 1.0, 1.0, 4.0}, 0.4), 2.0);
  // Of three choices the rows' two, not the one between them.
  solver::Quantity choice = *solver::find_quantity("chamber.wall");
  choice.choices = {"rigid", "stiff", "flexible"};
  EXPECT_EQ(row_value({&choice, 0.0, 0.0, 2.0}, 0.49), 0.0);
  EXPECT_EQ(row_value({&choice, 0.0, 0.0, 2.0}, 0.5), 2.0);
}

TEST(PriorRange, WhatHasOneValueIsNotVaried) {
  solver::Mechanism lens = *solver::find_mechanism("density_lens");
  EXPECT_EQ(varied_parameters(lens), (std::vector<std::size_t>{0, 1, 2}));
  lens.parameters[1].prior_upper = lens.parameters[1].prior_lower;
  EXPECT_EQ(varied_parameters(lens), (std::vector<std::size_t>{0, 2}));
}

}  // namespace
}  // namespace cpt::diagnosis

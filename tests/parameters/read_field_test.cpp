// Rows that are random fields over depth.
#include "parameters/read_field.hpp"

#include <gtest/gtest.h>

#include <set>

#include "parameters/all_realizations.hpp"
#include "parameters/designs/design.hpp"
#include "parameters/read_study.hpp"

namespace cpt::parameters {
namespace {

StudyOrErrors parsed(const std::string& row, const std::string& design) {
  return parse_study("profile = \"homogeneous_clay\"\npreset = \"quick\"\n[parameters]\n" + row +
                         "\n[[windows]]\nname = \"deep\"\nfrom_m = 0.3\nto_m = 0.32\n" + design,
                     "study.toml");
}

const std::string row =
    "\"clay.s_u_kPa\" = { baseline = 27.9, field = { cv = 0.2, correlation_length_m = 0.05 } }\n"
    "\"clay.G_kPa\" = { lower = 500, upper = 600 }\n";

double value_of(const Study& study, const Realization& realization, std::string_view name) {
  const solver::Setup setup = make_setup(study, realization);
  return solver::find_quantity(name, setup)->value(setup);
}

TEST(Field, SetsItsPartsAndDrawsItsSeedInEveryRunOfAPropagation) {
  const auto read = parsed(row, "[design]\nkind = \"propagation\"\nruns = 20\n");
  ASSERT_TRUE(std::holds_alternative<Study>(read)) << format(std::get<std::vector<StudyError>>(read));
  const Study& study = std::get<Study>(read);
  ASSERT_EQ(study.rows.size(), 2U);
  EXPECT_TRUE(study.rows[0].only_drawn());
  EXPECT_EQ(study.design.rows, (std::vector<std::size_t>{1, 0}));  // the field comes last
  const auto realizations = all_realizations(study);
  ASSERT_EQ(realizations.size(), 1U + 2U + 20U);  // no run of the field's seed alone
  std::set<double> seeds;
  for (const Realization& realization : realizations) {
    EXPECT_NEAR(value_of(study, realization, "clay.s_u_field_deviation_kPa"), 0.2 * 27.9, 1e-9);
    EXPECT_EQ(value_of(study, realization, "clay.s_u_field_length_m"), 0.05);
    EXPECT_EQ(value_of(study, realization, "clay.s_u_kPa"), 27.9);
    const double seed = value_of(study, realization, "clay.s_u_field_seed");
    EXPECT_EQ(seed, std::floor(seed));
    if (realization.point >= 0)
      seeds.insert(seed);
    else
      EXPECT_EQ(seed, 1.0);
  }
  EXPECT_EQ(seeds.size(), 20U);
}

TEST(ShiftPoints, EveryRunOfAPropagationDrawsItsOwn) {
  const std::string one = "\"clay.G_kPa\" = { lower = 500, upper = 600 }\n";
  const auto read = parsed(one, "[design]\nkind = \"propagation\"\nruns = 20\nshift_points = true\n");
  ASSERT_TRUE(std::holds_alternative<Study>(read)) << format(std::get<std::vector<StudyError>>(read));
  const Study& study = std::get<Study>(read);
  const auto realizations = all_realizations(study);
  ASSERT_EQ(realizations.size(), 1U + 2U + 20U);
  std::set<double> shifts;
  for (const Realization& realization : realizations) {
    const double shift = value_of(study, realization, "numerics.point_shift");
    if (realization.point < 0)
      EXPECT_EQ(shift, 0.0);
    else
      shifts.insert(shift);
  }
  EXPECT_EQ(shifts.size(), 20U);
  EXPECT_GE(*shifts.begin(), -0.5);
  EXPECT_LT(*shifts.begin(), -0.4);
  EXPECT_LE(*shifts.rbegin(), 0.5);
  EXPECT_GT(*shifts.rbegin(), 0.4);
  // Without it none.
  const auto without = parsed(one, "[design]\nkind = \"propagation\"\nruns = 20\nshift_points = false\n");
  ASSERT_TRUE(std::holds_alternative<Study>(without));
  EXPECT_EQ(std::get<Study>(without).rows.size(), 1U);
}

TEST(ShiftPoints, IsRefusedWhereItMeansNothing) {
  const auto message = [](const std::string& rows, const std::string& design) {
    const auto read = parsed(rows, design);
    return std::holds_alternative<Study>(read) ? "" : format(std::get<std::vector<StudyError>>(read));
  };
  const std::string one = "\"clay.G_kPa\" = { lower = 500, upper = 600 }\n";
  EXPECT_NE(message(one, "[design]\nkind = \"morris\"\nshift_points = true\n")
                .find("design.shift_points: means nothing to morris; it belongs to"),
            std::string::npos);
  EXPECT_NE(message(one, "[design]\nkind = \"propagation\"\nshift_points = 1\n")
                .find("design.shift_points: must be true or false, not"),
            std::string::npos);
  EXPECT_NE(message(one + "\"numerics.point_shift\" = { lower = -0.4, upper = 0.4 }\n",
                    "[design]\nkind = \"propagation\"\nshift_points = true\n")
                .find("numerics.point_shift is a row of [parameters]"),
            std::string::npos);
}

TEST(NumericalError, IsReadByChannelAndRefusedWhereItMeansNothing) {
  const std::string one = "\"clay.G_kPa\" = { lower = 500, upper = 600 }\n";
  const std::string start = "[design]\nkind = \"propagation\"\nruns = 20\nnumerical_error_percent = ";
  const auto read = parsed(one, start + "{ q_c = 5, f_s = 35 }\n");
  ASSERT_TRUE(std::holds_alternative<Study>(read)) << format(std::get<std::vector<StudyError>>(read));
  EXPECT_DOUBLE_EQ(std::get<Study>(read).design.numerical_error[0], 0.05);
  EXPECT_DOUBLE_EQ(std::get<Study>(read).design.numerical_error[1], 0.35);
  EXPECT_EQ(std::get<Study>(read).design.numerical_error[2], 0.0);
  const auto message = [&](const std::string& design) {
    const auto bad = parsed(one, design);
    return std::holds_alternative<Study>(bad) ? "" : format(std::get<std::vector<StudyError>>(bad));
  };
  EXPECT_NE(message("[design]\nkind = \"morris\"\nnumerical_error_percent = { q_c = 5 }\n")
                .find("means nothing to morris; it belongs to propagation"),
            std::string::npos);
  EXPECT_NE(message(start + "5\n").find("must be a table, not"), std::string::npos);
  EXPECT_NE(message(start + "{ qc = 5 }\n").find("qc"), std::string::npos);
  EXPECT_NE(message(start + "{ q_c = -5 }\n").find("-5 must be from 0 to 100"), std::string::npos);
}

TEST(Field, StaysThatOfTheBaselineWhereADesignDrawsNothing) {
  const auto read = parsed(row + "\"contact.adhesion_ratio\" = { lower = 0.3, upper = 0.7 }\n",
                           "[design]\nkind = \"morris\"\ntrajectories = 2\n");
  ASSERT_TRUE(std::holds_alternative<Study>(read)) << format(std::get<std::vector<StudyError>>(read));
  const Study& study = std::get<Study>(read);
  EXPECT_EQ(study.design.rows, (std::vector<std::size_t>{1, 2}));
  for (const Realization& realization : all_realizations(study))
    EXPECT_EQ(value_of(study, realization, "clay.s_u_field_seed"), 1.0);
}

TEST(Field, RefusesWhatIsNone) {
  struct Case {
    std::string field, key, message;
  };
  const auto of_clay = [](const std::string& field) {
    return "\"clay.s_u_kPa\" = { baseline = 27.9, field = " + field + " }\n";
  };
  const std::string key = "parameters.clay.s_u_kPa.field";
  for (const Case& bad :
       {Case{"\"clay.nu\" = { field = { cv = 0.1, correlation_length_m = 0.1 } }\n",
             "parameters.clay.nu.field", "clay.nu cannot be a random field"},
        Case{of_clay("3"), key, "must be a table, not a number"},
        Case{of_clay("{ correlation_length_m = 0.1 }"), key + ".standard_deviation", "is missing"},
        Case{of_clay("{ cv = 0.1, standard_deviation = 3, correlation_length_m = 0.1 }"),
             key + ".standard_deviation", "stands beside cv"},
        Case{of_clay("{ cv = -0.1, correlation_length_m = 0.1 }"), key + ".cv", "-0.1 must be above 0"},
        Case{of_clay("{ cv = 0.1, correlation_length_m = 0.001 }"), key + ".correlation_length_m",
             "0.001 is outside of 0.01 to 100"},
        Case{of_clay("{ cv = 0.1 }"), key + ".correlation_length_m", "missing"},
        Case{of_clay("{ cv = 0.1, correlation_length_m = 0.1, kind = \"beta\" }"), key + ".kind",
             "lognormal"},
        Case{of_clay("{ cv = 0.1, correlation_length_mm = 100 }"), key + ".correlation_length_mm",
             "unknown"}}) {
    const auto read = parsed(bad.field, "");
    ASSERT_TRUE(std::holds_alternative<std::vector<StudyError>>(read)) << bad.field;
    const auto& errors = std::get<std::vector<StudyError>>(read);
    EXPECT_EQ(errors[0].key, bad.key) << format(errors);
    EXPECT_EQ(errors[0].line, 4);
    EXPECT_NE((errors[0].message + errors[0].hint).find(bad.message), std::string::npos) << format(errors);
  }
}

TEST(Field, IsPossibleForWhatTheLawsSay) {
  const auto may =
      field_quantities(solver::make_setup(solver::Profile::layered_sand_clay, solver::Preset::quick));
  EXPECT_EQ(may, (std::vector<std::string>{"sand.D_r_percent", "clay.s_u_kPa"}));
}

}  // namespace
}  // namespace cpt::parameters

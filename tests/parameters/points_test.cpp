// Points of a study: realizations that change several inputs at once, and repeats of the baseline.
#include <cmath>

#include "parameters/all_realizations.hpp"
#include "tests/parameters/studies.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::parameters {
namespace {

TEST(Points, ComeAfterTheRows) {
  const Study study = study_of(sand_study(
      "[parameters]\nsand.H = { baseline = 25, upper = 75 }\n"
      "[[points]]\nname = \"dense and smooth\"\nsand.D_r_percent = 46\n\"contact.friction_ratio\" = 0.3\n"
      "[[points]]\nname = \"flexible\"\nchamber.wall = \"flexible\"\n"));
  const auto realizations = all_realizations(study);
  ASSERT_EQ(realizations.size(), 4U);
  const Realization& both = realizations[2];
  EXPECT_EQ(both.id, 3);
  EXPECT_EQ(both.side, Side::point);
  EXPECT_EQ(parameter_name(study, both), "dense and smooth");
  EXPECT_TRUE(std::isnan(parameter_value(study, both)));
  EXPECT_EQ(value_text(study, both), "sand.D_r_percent = 46, contact.friction_ratio = 0.3");
  const solver::Setup setup = make_setup(study, both);
  EXPECT_DOUBLE_EQ(solver::sand_of(setup).D_r, 0.46);
  EXPECT_DOUBLE_EQ(setup.contact.friction_ratio, 0.3);
  EXPECT_EQ(make_setup(study, realizations[3]).chamber.wall, solver::Wall::flexible);
  EXPECT_EQ(value_text(study, realizations[3]), "chamber.wall = flexible");
}

TEST(Points, ErrorsTellWhatIsWrong) {
  struct Case {
    std::string point, key, message;
  };
  for (const Case& bad :
       {Case{"sand.H = 50", "points.name", "missing"},
        Case{"name = \"\"\nsand.H = 50", "points.name", "empty"},
        Case{"name = \"a\"", "points", "changes nothing"},
        Case{"name = \"a\"\nsand.G = 5", "points.sand.G", "unknown quantity"},
        Case{"name = \"a\"\nsand.H = -5", "points.sand.H", "outside the valid range"},
        Case{"name = \"a\"\nclay.s_u_kPa = 30", "points.clay.s_u_kPa", "no clay"},
        Case{"name = \"a\"\nsand.H = 50\n[[points]]\nname = \"a\"\nsand.H = 60", "points.name",
             "another point"},
        Case{"name = \"a\"\npenetrometer.final_depth_m = 0.985", "points.a", "final_depth"}}) {
    const auto errors = errors_of(sand_study("[[points]]\n" + bad.point + "\n"));
    ASSERT_FALSE(errors.empty()) << bad.point;
    EXPECT_EQ(errors.front().key, bad.key) << format(errors);
    EXPECT_NE(format(errors).find(bad.message), std::string::npos) << format(errors);
  }
}

TEST(Repeats, ShiftTheMaterialPointsEvenlyToEitherSide) {
  const Study study = study_of("repeats = 4\n" + sand_study("[[points]]\nname = \"a\"\nsand.H = 50\n"));
  const auto realizations = all_realizations(study);
  ASSERT_EQ(realizations.size(), 6U);
  EXPECT_EQ(realizations[1].side, Side::point);
  const std::vector<double> shifts = {-0.4, -0.2, 0.2, 0.4};
  for (std::size_t k = 0; k < 4; ++k) {
    const Realization& repeat = realizations[k + 2];
    EXPECT_EQ(repeat.side, Side::repeat);
    EXPECT_EQ(parameter_name(study, repeat), "repeat " + std::to_string(k + 1));
    solver::Setup setup = study.baseline;
    EXPECT_DOUBLE_EQ(make_setup(study, repeat).numerics.point_shift, shifts[k]);
    setup.numerics.point_shift = make_setup(study, repeat).numerics.point_shift;
    EXPECT_EQ(settings_text(study, repeat), solver::canonical_text(setup));
  }
}

TEST(Repeats, GoAroundFromAShiftedBaseline) {
  const Study study = study_of("repeats = 2\n" + sand_study("[fixed]\n\"numerics.point_shift\" = 0.3\n"));
  EXPECT_DOUBLE_EQ(make_setup(study, all_realizations(study)[1]).numerics.point_shift, -0.1);
  EXPECT_DOUBLE_EQ(make_setup(study, all_realizations(study)[2]).numerics.point_shift, -0.3);
}

// Both bounds with the shifts of the repeats, after all else; a bound that is the baseline has its repeat
// already.
TEST(Repeats, PairsHaveTheShiftsOfTheRepeats) {
  const Study study =
      study_of("repeats = 2\npaired_repeats = [\"sand.H\", \"sand.nu\"]\n" +
               sand_study("[parameters]\nsand.nu = { baseline = 0.2, lower = 0.1, upper = 0.3 }\n"
                          "sand.H = { baseline = 25, upper = 75 }\n"));
  const auto realizations = all_realizations(study);
  std::vector<std::string> names;
  for (const Realization& r : realizations)
    if (r.point >= 0) names.emplace_back(parameter_name(study, r));
  EXPECT_EQ(names, (std::vector<std::string>{"repeat 1", "repeat 2", "repeat 1, sand.H upper",
                                             "repeat 2, sand.H upper", "repeat 1, sand.nu lower",
                                             "repeat 1, sand.nu upper", "repeat 2, sand.nu lower",
                                             "repeat 2, sand.nu upper"}));
  const solver::Setup pair = make_setup(study, realizations.back()),
                      repeat = make_setup(study, realizations[5]);
  EXPECT_EQ(realizations.back().side, Side::point);
  EXPECT_EQ(pair.numerics.point_shift, repeat.numerics.point_shift);
  EXPECT_EQ(solver::sand_of(pair).nu, 0.3);
}

TEST(Repeats, PairsThatCannotBeAreTold) {
  const std::string row = "[parameters]\nsand.H = { baseline = 25, upper = 75 }\n";
  const auto told = [&](const std::string& top, const char* words, const char* hint) {
    const auto errors = errors_of(top + sand_study(row));
    ASSERT_EQ(errors.size(), 1U) << top << format(errors);
    EXPECT_EQ(errors[0].key, "paired_repeats");
    EXPECT_NE(errors[0].message.find(words), std::string::npos) << errors[0].message;
    EXPECT_EQ(errors[0].hint, hint);
  };
  told("paired_repeats = [\"sand.H\"]\n", "wants repeats", "add repeats = 6");
  told("repeats = 2\npaired_repeats = [\"sand.h\"]\n", "is no row of [parameters]",
       "did you mean \"sand.H\"?");
  told("repeats = 2\npaired_repeats = [\"sand.H\", \"sand.H\"]\n", "named twice", "");
  told("repeats = 2\npaired_repeats = [4]\n", "must hold names, not", "");
  told("repeats = 2\npaired_repeats = \"sand.H\"\n", "must be an array of names",
       "such as paired_repeats = [\"sand.H\"]");
}

TEST(Repeats, ErrorsTellWhatIsWrong) {
  for (const char* bad : {"repeats = 3\n", "repeats = 0\n", "repeats = 22\n", "repeats = \"four\"\n"}) {
    const auto errors = errors_of(bad + sand_study(""));
    ASSERT_FALSE(errors.empty()) << bad;
    EXPECT_EQ(errors.front().key, "repeats") << format(errors);
  }
  const auto errors =
      errors_of("repeats = 2\n" + sand_study("[[points]]\nname = \"repeat 1\"\nsand.H = 50\n"));
  ASSERT_FALSE(errors.empty());
  EXPECT_NE(format(errors).find("names a point"), std::string::npos) << format(errors);
}

}  // namespace
}  // namespace cpt::parameters

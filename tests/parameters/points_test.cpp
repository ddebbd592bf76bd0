// Points of a study: realizations that change several inputs at once.
#include <cmath>

#include "parameters/designs/one_at_a_time.hpp"
#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

TEST(Points, ComeAfterTheRows) {
  const Study study = study_of(sand_study(
      "[parameters]\nsand.H = { baseline = 25, upper = 75 }\n"
      "[[points]]\nname = \"dense and smooth\"\nsand.D_r_percent = 46\n\"contact.friction_ratio\" = 0.3\n"
      "[[points]]\nname = \"flexible\"\nchamber.wall = \"flexible\"\n"));
  const auto realizations = one_at_a_time(study);
  ASSERT_EQ(realizations.size(), 4U);
  const Realization& both = realizations[2];
  EXPECT_EQ(both.id, 3);
  EXPECT_EQ(both.side, Side::point);
  EXPECT_EQ(parameter_name(study, both), "dense and smooth");
  EXPECT_TRUE(std::isnan(parameter_value(study, both)));
  EXPECT_EQ(value_text(study, both), "sand.D_r_percent = 46, contact.friction_ratio = 0.3");
  const solver::Setup setup = make_setup(study, both);
  EXPECT_DOUBLE_EQ(setup.sand.D_r, 0.46);
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

}  // namespace
}  // namespace cpt::parameters

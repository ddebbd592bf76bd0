#include "parameters/all_realizations.hpp"

#include <cmath>
#include <set>

#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

Study three_rows() {
  return study_of(
      sand_study("[parameters]\n"
                 "sand.nu = { baseline = 0.2, lower = 0.1, upper = 0.3 }\n"
                 "sand.H = { baseline = 25, lower = 25, upper = 75 }\n"
                 "chamber.wall = { baseline = \"rigid\", alternative = \"flexible\" }\n"));
}

TEST(OneAtATime, BaselineThenRowsLowerBeforeUpper) {
  const Study study = three_rows();
  const auto realizations = all_realizations(study);
  ASSERT_EQ(realizations.size(), 5u);
  const std::vector<std::pair<std::string, std::string>> expected = {{"", "baseline"},
                                                                     {"sand.nu", "lower"},
                                                                     {"sand.nu", "upper"},
                                                                     {"sand.H", "upper"},
                                                                     {"chamber.wall", "lower"}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(realizations[i].id, static_cast<int>(i) + 1);
    EXPECT_EQ(parameter_name(study, realizations[i]), expected[i].first);
    EXPECT_EQ(to_string(realizations[i].side), expected[i].second);
  }
  EXPECT_TRUE(std::isnan(parameter_value(study, realizations[0])));
  EXPECT_EQ(parameter_value(study, realizations[1]), 0.1);
  EXPECT_EQ(parameter_value(study, realizations[2]), 0.3);
  EXPECT_EQ(parameter_value(study, realizations[3]), 75.0);
  EXPECT_EQ(parameter_value(study, realizations[4]), 0.0);
}

TEST(OneAtATime, ABoundEqualToTheBaselineReusesTheBaseline) {
  const auto realizations = all_realizations(three_rows());
  EXPECT_EQ(realization_of(realizations, 0, Side::lower), 2);
  EXPECT_EQ(realization_of(realizations, 0, Side::upper), 3);
  EXPECT_EQ(realization_of(realizations, 0, Side::baseline), 1);
  EXPECT_EQ(realization_of(realizations, 1, Side::lower), 1);
  EXPECT_EQ(realization_of(realizations, 1, Side::upper), 4);
  EXPECT_EQ(realization_of(realizations, 2, Side::lower), 5);
  EXPECT_EQ(realization_of(realizations, 2, Side::upper), 1);
}

TEST(OneAtATime, ARealizationChangesOneInputOfTheBaseline) {
  const Study study = three_rows();
  std::set<std::string> texts;
  for (const Realization& realization : all_realizations(study)) {
    solver::Setup setup = make_setup(study, realization);
    texts.insert(settings_text(study, realization));
    EXPECT_EQ(settings_text(study, realization), solver::canonical_text(setup));
    if (realization.row < 0) continue;
    const Row& row = study.rows[static_cast<std::size_t>(realization.row)];
    EXPECT_EQ(row.quantity->value(setup), parameter_value(study, realization));
    row.quantity->set_value(setup, row.baseline);
    EXPECT_EQ(solver::canonical_text(setup), solver::canonical_text(study.baseline));
  }
  EXPECT_EQ(texts.size(), 5u);
}

}  // namespace
}  // namespace cpt::parameters

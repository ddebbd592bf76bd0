#include "parameters/run_order.hpp"

#include <algorithm>
#include <numeric>

#include "parameters/all_realizations.hpp"
#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

RunOrder order_of(const Study& study) { return run_order(study, all_realizations(study)); }

TEST(RunOrder, RowsThatLikelyMatterComeFirstWithBothBounds) {
  const Study study = study_of(
      "repeats = 2\n" +
      sand_study("[parameters]\n"
                 "sand.nu = { baseline = 0.2, lower = 0.1, upper = 0.3 }\n"               // 2, 3
                 "chamber.wall = { baseline = \"rigid\", alternative = \"flexible\" }\n"  // 4
                 "sand.D_r_percent = { baseline = 36, lower = 26, upper = 46 }\n"         // 5, 6
                 "sand.H = { baseline = 25, lower = 25, upper = 75 }\n"                   // 7
                 "initial.sigma_h0_kPa = { baseline = 25, lower = 15, upper = 35 }\n"     // 8, 9
                 "[[points]]\nname = \"both\"\nsand.H = 50\nsand.nu = 0.3\n"));  // 10; repeats 11, 12
  const RunOrder order = order_of(study);
  EXPECT_EQ(order.ids, (std::vector<int>{1, 7, 5, 6, 8, 9, 4, 2, 3, 10, 11, 12}));
  EXPECT_EQ(order.leading, 7);  // the baseline and four rows
}

// Narrow bounds matter less than wide ones of the same input.
TEST(RunOrder, ExpectsMoreOfWiderBounds) {
  const auto first_row = [](const std::string& bounds) {
    return study_of(sand_study("[parameters]\nsand.H = { baseline = 25, " + bounds + " }\n")).rows.at(0);
  };
  EXPECT_GT(expected_effect(first_row("upper = 75")), expected_effect(first_row("upper = 30")));
  EXPECT_GT(expected_effect(first_row("upper = 30")), 0.0);
}

TEST(RunOrder, StudyOfTheBaselineAlone) {
  const RunOrder order = order_of(study_of(sand_study("")));
  EXPECT_EQ(order.ids, std::vector<int>{1});
  EXPECT_EQ(order.leading, 1);
}

TEST(RunOrder, HoldsEveryRealizationOfTheExampleOnce) {
  const std::filesystem::path file = CPT_EXAMPLES "/sens.toml";
  const Study study = study_of(text_of(file), file);
  RunOrder order = order_of(study);
  EXPECT_EQ(order.leading, 8);  // H, density, friction and sigma'_h0: seven bounds
  std::vector<int> all(order.ids.size());
  std::iota(all.begin(), all.end(), 1);
  EXPECT_EQ(all.size(), all_realizations(study).size());
  std::ranges::sort(order.ids);
  EXPECT_EQ(order.ids, all);
}

}  // namespace
}  // namespace cpt::parameters

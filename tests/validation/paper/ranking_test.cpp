#include "validation/paper/ranking.hpp"

#include <gtest/gtest.h>

#include "tests/validation/paper/paper_campaigns.hpp"

namespace cpt::validation::paper {
namespace {

// Every parameter of a study belongs to exactly one group of its ranking, so that no pair is left out or
// counted twice.
TEST(Published, RankingsNameEveryParameterOnce) {
  const PaperCampaigns campaigns;
  const Studies studies = campaigns.studies();
  for (const Ranking* ranking :
       {&sand_ranking, &clay_ranking, &embedded_sand_ranking, &embedded_clay_ranking}) {
    std::map<std::string_view, int> named;
    for (const Group& group : ranking->groups)
      for (const std::string_view parameter : group.parameters) ++named[parameter];
    const auto& parameters = studies.find(ranking->study)->second.parameters;
    EXPECT_EQ(named.size(), parameters.size()) << ranking->window;
    for (const auto& parameter : parameters) EXPECT_EQ(named[parameter.name], 1) << parameter.name;
  }
}

TEST(Ranking, CountsPairsOfDifferentGroups) {
  const PaperCampaigns campaigns;
  const Studies studies = campaigns.studies();
  const StudyView sand(studies, sand_study);
  const RankingComparison result = compare(sand, sand_ranking);
  EXPECT_EQ(result.pairs, 1 * 11 + 4 * 7 + 4 * 3);
  EXPECT_EQ(result.in_order, result.pairs);
  EXPECT_EQ(result.levels, 12);
  EXPECT_EQ(result.at_level, 12);
  EXPECT_TRUE(result.out_of_order.empty() && result.off_level.empty() && result.missing.empty());
}

TEST(Ranking, NamesWhatIsOutOfOrder) {
  PaperCampaigns campaigns;
  Studies studies = campaigns.studies();
  // The index of N, which belongs to the last group, becomes larger than all but that of H.
  for (results::SensitivityRow& row : studies.find(sand_study)->second.sensitivity)
    if (row.parameter == "sand.N") row.si = row.si_abs = 0.4;
  const RankingComparison result = compare(StudyView(studies, sand_study), sand_ranking);
  EXPECT_EQ(result.pairs - result.in_order, 8);
  ASSERT_EQ(result.out_of_order.size(), 8u);
  EXPECT_TRUE(result.out_of_order[0].starts_with("N (0.400) over D")) << result.out_of_order[0];
  EXPECT_EQ(result.off_level, std::vector<std::string>{"N (0.400)"});
}

TEST(Ranking, LeavesOutWhatHasNoIndex) {
  // 13 is H's upper bound.
  const PaperCampaigns campaigns({{sand_study, {{13, "crashed"}}}});
  const Studies studies = campaigns.studies();
  const RankingComparison result = compare(StudyView(studies, sand_study), sand_ranking);
  EXPECT_EQ(result.pairs, 4 * 7 + 4 * 3);
  EXPECT_EQ(result.missing, "1 of 12 parameters have no index");
}

}  // namespace
}  // namespace cpt::validation::paper

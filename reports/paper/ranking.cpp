#include "reports/paper/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/text.hpp"

namespace cpt::reports::paper {
namespace {

struct Placed {
  std::string text;  // symbol and size
  double size;
  std::size_t group;
};

}  // namespace

RankingComparison compare(const StudyView& study, const Ranking& ranking) {
  RankingComparison result;
  std::vector<Placed> placed;
  const Value noise = study.noise(ranking.window);
  for (std::size_t g = 0; g < ranking.groups.size(); ++g) {
    const Group& group = ranking.groups[g];
    for (const std::string_view parameter : group.parameters) {
      const Value index = study.index(ranking.window, parameter);
      if (!index) {
        if (std::find(result.missing.begin(), result.missing.end(), index.missing) == result.missing.end())
          result.missing.push_back(index.missing);
        continue;
      }
      const double size = std::abs(index.number);
      placed.push_back({fmt::format("{} ({})", study.symbol(parameter), decimals(size, 3)), size, g});
      if (!noise) continue;
      ++result.levels;
      if ((size > noise.number) == (group.level == Level::above_noise))
        ++result.at_level;
      else
        result.off_level.push_back(placed.back().text);
    }
  }
  for (const Placed& first : placed)
    for (const Placed& second : placed) {
      if (first.group >= second.group) continue;
      ++result.pairs;
      if (first.size > second.size)
        ++result.in_order;
      else
        result.out_of_order.push_back(fmt::format("{} over {}", second.text, first.text));
    }
  std::stable_sort(placed.begin(), placed.end(),
                   [](const Placed& a, const Placed& b) { return a.size > b.size; });
  for (const Placed& p : placed) result.ours += (result.ours.empty() ? "" : ", ") + p.text;
  return result;
}

std::string in_words(const StudyView& study, const Ranking& ranking) {
  std::string text;
  for (const Group& group : ranking.groups) {
    text += text.empty() ? "" : " > ";
    for (const std::string_view& parameter : group.parameters)
      text += (&parameter == group.parameters.data() ? "" : ", ") + study.symbol(parameter);
  }
  return text;
}

std::string_view words_for(const Ranking& ranking, std::string_view parameter) {
  for (const Group& group : ranking.groups)
    if (std::find(group.parameters.begin(), group.parameters.end(), parameter) != group.parameters.end())
      return group.words;
  return {};
}

}  // namespace cpt::reports::paper

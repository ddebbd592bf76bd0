#include "validation/paper/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/text.hpp"

namespace cpt::validation::paper {
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
  std::size_t without = 0;
  std::string reason;
  for (std::size_t g = 0; g < ranking.groups.size(); ++g) {
    const Group& group = ranking.groups[g];
    for (const std::string_view parameter : group.parameters) {
      const Value index = study.index(ranking.window, parameter);
      if (!index) {
        ++without;
        reason = index.missing;
        continue;
      }
      const double size = std::abs(index.number);
      placed.push_back(
          {fmt::format("{} ({})", study.symbol(parameter), drawing::decimals(size, 3)), size, g});
      if (!noise) continue;
      ++result.levels;
      if ((size > noise.number) == (group.level == Level::above_noise))
        ++result.at_level;
      else
        result.off_level.push_back(placed.back().text);
    }
  }
  const std::size_t all = placed.size() + without;
  if (without > 0)
    result.missing =
        study.snapshot() == nullptr ? reason : fmt::format("{} of {} parameters have no index", without, all);
  for (const Placed& first : placed)
    for (const Placed& second : placed) {
      if (first.group >= second.group) continue;
      ++result.pairs;
      if (first.size > second.size)
        ++result.in_order;
      else
        result.out_of_order.push_back(fmt::format("{} over {}", second.text, first.text));
    }
  return result;
}

std::string group_of(const Ranking& ranking, std::string_view parameter) {
  for (std::size_t g = 0; g < ranking.groups.size(); ++g) {
    const Group& group = ranking.groups[g];
    if (std::find(group.parameters.begin(), group.parameters.end(), parameter) != group.parameters.end())
      return fmt::format("{}: {}", g + 1, html(drawing::symbolic(group.words)));
  }
  return {};
}

}  // namespace cpt::validation::paper

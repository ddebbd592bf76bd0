#include "parameters/nearest_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "parameters/quantity_synonyms.hpp"
#include "solver/quantities.hpp"

namespace cpt::parameters {
namespace {

using solver::quantities_of, solver::Quantity, solver::Setup;

// Distances are in half edits: 1 for another case, 2 for a letter inserted, left out, replaced or swapped.
using HalfEdits = std::size_t;
constexpr HalfEdits far_away = std::numeric_limits<HalfEdits>::max();

HalfEdits replacement(char a, char b) {
  if (a == b) return 0;
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return lower(a) == lower(b) ? 1 : 2;
}

// Optimal string alignment distance.
HalfEdits distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<HalfEdits>> d(a.size() + 1, std::vector<HalfEdits>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = 2 * i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = 2 * j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] =
          std::min({d[i - 1][j] + 2, d[i][j - 1] + 2, d[i - 1][j - 1] + replacement(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 2);
    }
  return d[a.size()][b.size()];
}

std::string_view without_unit(std::string_view name) {
  constexpr std::array<std::string_view, 20> suffixes = {
      "_kg_per_m3", "_g_per_cm3", "_mm_per_s", "_cm_per_s", "_m_per_s", "_percent",  "_deg",
      "_rad",       "_GPa",       "_MPa",      "_kPa",      "_Pa",      "_mm",       "_cm",
      "_m",         "_bar",       "_psi",      "_pct",      "_degrees", "_kN_per_m3"};
  for (const std::string_view suffix : suffixes)
    if (name.size() > suffix.size() && name.ends_with(suffix))
      return name.substr(0, name.size() - suffix.size());
  return name;
}

std::string_view last_part(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

// A name cut short, or without its beginning.
bool is_part(std::string_view given, std::string_view wanted) {
  return given.size() >= 3 && (wanted.starts_with(given) || wanted.ends_with(given));
}

HalfEdits quantity_distance(std::string_view name, std::string_view quantity) {
  const std::string_view given = without_unit(name), wanted = without_unit(quantity);
  const std::string_view given_part = last_part(given), wanted_part = last_part(wanted);
  HalfEdits nearest = std::min(
      {distance(name, quantity), distance(given, wanted) + 1, distance(given_part, wanted_part) + 3});
  const bool same_group = name.substr(0, name.find('.')) == quantity.substr(0, quantity.find('.'));
  if (is_part(given_part, wanted_part)) nearest = std::min<HalfEdits>(nearest, same_group ? 3 : 4);
  return nearest;
}

std::string_view group_of(std::string_view name) {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? "" : name.substr(0, dot);
}

// The words of a name or a sentence, in lower case.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!words.back().empty())
      words.emplace_back();
  if (words.back().empty()) words.pop_back();
  return words;
}

// The one whose meaning holds all words of the name: of the group, else of all; "" where there are several.
std::string_view of_this_meaning(std::string_view group, std::string_view part, const Setup& setup) {
  const std::vector<std::string> wanted = words_of(part);
  if (part.size() < 4 || wanted.empty()) return "";
  for (const bool own_group : {true, false}) {
    std::string_view found;
    int count = 0;
    for (const Quantity* quantity : quantities_of(setup)) {
      if (own_group && group_of(quantity->name) != group) continue;
      const std::vector<std::string> meaning = words_of(quantity->meaning);
      if (!std::ranges::all_of(wanted, [&](const std::string& word) {
            return std::ranges::find(meaning, word) != meaning.end();
          }))
        continue;
      found = quantity->name;
      ++count;
    }
    if (count == 1) return found;
    if (count > 1) return "";
  }
  return "";
}

// The quantity of that name without regard to signs and case, or that the field calls so.
std::string_view quantity_called(std::string_view name, const Setup& setup) {
  const std::string word = squeezed(last_part(without_unit(name)));
  if (word.empty()) return "";
  std::string_view elsewhere;
  const auto take = [&](std::string_view quantity) {
    if (elsewhere.empty()) elsewhere = quantity;
    return group_of(quantity) == group_of(name);
  };
  for (const Quantity* quantity : quantities_of(setup))
    if (squeezed(last_part(without_unit(quantity->name))) == word && take(quantity->name))
      return quantity->name;
  // The words of sand and clay are those of any soil with the same parameter.
  for (const Synonym& synonym : quantity_synonyms()) {
    if (synonym.word != word) continue;
    const bool of_soil = !solver::find_quantity(synonym.quantity)->soil.empty();
    for (const Quantity* quantity : quantities_of(setup))
      if (quantity->name == synonym.quantity ||
          (of_soil && !quantity->soil.empty() && last_part(quantity->name) == last_part(synonym.quantity)))
        if (take(quantity->name)) return quantity->name;
  }
  return elsewhere;
}

constexpr std::size_t longest = 100;  // nobody means a name with more

struct Near {
  std::string_view name;
  HalfEdits edits = far_away;
};

template <class Distance>
Near nearest(std::string_view name, std::size_t count, const Distance& candidate) {
  Near best;
  if (name.empty() || name.size() > longest) return best;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [text, edits] = candidate(i);
    if (edits < best.edits) best = {text, edits};
  }
  return best;
}

// A name is near if at most half of its letters are edited.
std::string_view if_near(std::string_view name, const Near& found) {
  return found.edits <= std::max<HalfEdits>(3, name.size()) ? found.name : std::string_view();
}

}  // namespace

std::string_view nearest_quantity(std::string_view name) { return nearest_quantity(name, Setup{}); }

std::string_view nearest_quantity(std::string_view name, const Setup& setup) {
  constexpr HalfEdits other_case = 1, one_letter = 2;
  if (name.size() > longest) return "";
  const auto list = quantities_of(setup);
  const Near found = nearest(name, list.size(), [&](std::size_t i) {
    return std::pair(std::string_view(list[i]->name), quantity_distance(name, list[i]->name));
  });
  if (found.edits <= other_case) return found.name;
  if (const std::string_view called = quantity_called(name, setup); !called.empty()) return called;
  if (found.edits <= one_letter) return found.name;
  const std::string_view meant = of_this_meaning(group_of(name), last_part(without_unit(name)), setup);
  return meant.empty() ? if_near(name, found) : meant;
}

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> names) {
  return if_near(name, nearest(name, names.size(), [&](std::size_t i) {
                   const HalfEdits edits = distance(name, names[i]);
                   return std::pair(names[i],
                                    is_part(name, names[i]) ? std::min<HalfEdits>(edits, 3) : edits);
                 }));
}

}  // namespace cpt::parameters

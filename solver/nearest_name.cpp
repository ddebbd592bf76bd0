// Hints for misspelt names.
#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <vector>

#include "solver/quantities.hpp"

namespace cpt::solver {
namespace {

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

// A name is near if at most half of its letters are edited.
template <class Distance>
std::string_view nearest(std::string_view name, std::size_t count, const Distance& candidate) {
  constexpr std::size_t longest = 100;  // nobody means a quantity with this
  if (name.empty() || name.size() > longest) return "";
  std::string_view best;
  HalfEdits smallest = far_away;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [text, edits] = candidate(i);
    if (edits < smallest) {
      smallest = edits;
      best = text;
    }
  }
  return smallest <= std::max<HalfEdits>(3, name.size()) ? best : std::string_view();
}

}  // namespace

std::string_view nearest_quantity(std::string_view name) {
  const auto list = all_quantities();
  return nearest(name, list.size(), [&](std::size_t i) {
    return std::pair(list[i].name, quantity_distance(name, list[i].name));
  });
}

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> names) {
  return nearest(name, names.size(), [&](std::size_t i) {
    const HalfEdits edits = distance(name, names[i]);
    return std::pair(names[i], is_part(name, names[i]) ? std::min<HalfEdits>(edits, 3) : edits);
  });
}

}  // namespace cpt::solver

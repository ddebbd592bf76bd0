#include "recordings/ags4_groups.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cpt::recordings {
namespace {

void read_row(const Line& line, std::vector<PlacedText> cells, std::vector<AgsGroup>& groups,
              Problems& problems) {
  const std::string kind = cells.front().text;
  const int column = cells.front().column;
  cells.erase(cells.begin());
  if (kind == "GROUP") {
    if (cells.empty()) return problems.add(line.number, column, "a group without a name", "a name");
    groups.push_back({cells.front().text, line.number, {}, {}, {}});
    return;
  }
  if (groups.empty())
    return problems.add(line.number, column, in_quotes(kind), "\"GROUP\" first", "is this an AGS4 file?");
  AgsGroup& group = groups.back();
  if (kind == "HEADING") {
    for (const PlacedText& cell : cells) group.headings.push_back(cell.text);
    return;
  }
  if (kind != "UNIT" && kind != "TYPE" && kind != "DATA")
    return problems.add(line.number, column, in_quotes(kind), "GROUP, HEADING, UNIT, TYPE or DATA");
  if (cells.size() != group.headings.size())
    return problems.add(line.number, column, fmt::format("{} values", cells.size()),
                        fmt::format("{}, one for each heading of {}", group.headings.size(), group.name),
                        "is the line cut off?");
  if (kind == "UNIT") {
    group.units.clear();
    for (const PlacedText& cell : cells) group.units.push_back(cell.text);
  }
  if (kind == "DATA") group.rows.push_back({line.number, std::move(cells)});
}

}  // namespace

std::optional<std::size_t> AgsGroup::place_of(std::string_view heading) const {
  const auto found = std::find(headings.begin(), headings.end(), heading);
  if (found == headings.end()) return std::nullopt;
  return static_cast<std::size_t>(found - headings.begin());
}

std::string AgsGroup::text(const AgsRow& row, std::string_view heading) const {
  const auto place = place_of(heading);
  return place && *place < row.cells.size() ? row.cells[*place].text : std::string();
}

std::string AgsGroup::unit(std::string_view heading) const {
  const auto place = place_of(heading);
  return place && *place < units.size() ? units[*place] : std::string();
}

std::vector<AgsGroup> read_ags_groups(const std::vector<Line>& lines, Problems& problems) {
  std::vector<AgsGroup> groups;
  for (const Line& line : lines) {
    if (problems.full()) break;
    if (trimmed(line.text).empty()) continue;
    std::vector<PlacedText> cells = fields_of(line, ',', problems);
    if (problems.any() && (cells.empty() || problems.errors().back().line == line.number)) continue;
    read_row(line, std::move(cells), groups, problems);
  }
  return groups;
}

const AgsGroup* find_group(const std::vector<AgsGroup>& groups, std::string_view name) {
  const auto found =
      std::find_if(groups.begin(), groups.end(), [&](const AgsGroup& group) { return group.name == name; });
  return found == groups.end() ? nullptr : &*found;
}

}  // namespace cpt::recordings

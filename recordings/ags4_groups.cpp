#include "recordings/ags4_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cpt::recordings {
namespace {

class GroupReader {
 public:
  explicit GroupReader(Problems& problems) : problems_(problems) {}

  void read_row(const Line& line, std::vector<PlacedText> cells) {
    const PlacedText kind = cells.front();
    cells.erase(cells.begin());
    if (kind.text == "GROUP") return read_group(kind, cells);
    if (groups.empty())
      return problems_.add(kind.line, kind.column, in_quotes(kind.text), "\"GROUP\" first",
                           "is this an AGS4 file?");
    AgsGroup& group = groups.back();
    if (kind.text == "HEADING") return read_headings(kind, cells, group);
    if (kind.text != "UNIT" && kind.text != "TYPE" && kind.text != "DATA")
      return problems_.add(kind.line, kind.column, in_quotes(kind.text),
                           "GROUP, HEADING, UNIT, TYPE or DATA");
    if (cells.size() != group.headings.size())
      return problems_.add(kind.line, kind.column, fmt::format("{} values", cells.size()),
                           fmt::format("{}, one for each heading of {}", group.headings.size(), group.name),
                           "is the line cut off, or do unquoted numbers have decimal commas?");
    if (kind.text == "UNIT") read_units(kind, cells, group);
    if (kind.text == "DATA") group.rows.push_back({line.number, std::move(cells)});
  }

  std::vector<AgsGroup> groups;

 private:
  void read_group(const PlacedText& kind, const std::vector<PlacedText>& cells) {
    if (cells.empty() || cells.front().text.empty())
      return problems_.add(kind.line, kind.column, "a group without a name", "a name");
    groups.push_back({cells.front().text, kind.line, 0, {}, {}, {}, {}});
  }

  // Deliveries that were joined may repeat headings and units; the rows above mean what stood above them.
  void read_headings(const PlacedText& kind, const std::vector<PlacedText>& cells, AgsGroup& group) {
    std::vector<std::string> headings;
    for (const PlacedText& cell : cells) {
      if (!cell.text.empty() && std::find(headings.begin(), headings.end(), cell.text) != headings.end())
        return problems_.add(cell.line, cell.column, "a second heading " + in_quotes(cell.text), "each once");
      headings.push_back(cell.text);
    }
    if (group.headings.empty())
      group.headings = std::move(headings);
    else if (group.headings != headings)
      problems_.add(kind.line, kind.column, "other headings in the same group " + group.name,
                    "one HEADING row in a group",
                    "were files joined? begin the second part with its GROUP row");
  }

  void read_units(const PlacedText& kind, const std::vector<PlacedText>& cells, AgsGroup& group) {
    std::vector<std::string> units;
    for (const PlacedText& cell : cells) units.push_back(cell.text);
    if (group.units.empty() && group.rows.empty()) {
      group.units = std::move(units);
      group.unit_line = kind.line;
      for (const PlacedText& cell : cells) group.unit_columns.push_back(cell.column);
    } else if (group.units != units) {
      problems_.add(kind.line, kind.column, "other units in the same group " + group.name,
                    "one UNIT row in a group, above its data",
                    "were files joined? begin the second part with its GROUP row");
    }
  }

  Problems& problems_;
};

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
  GroupReader reader(problems);
  for (const Line& line : lines) {
    if (problems.full()) break;
    if (trimmed(line.text).empty()) continue;
    std::vector<PlacedText> cells = fields_of(line, ',', problems);
    if (problems.any() && (cells.empty() || problems.errors().back().line == line.number)) continue;
    reader.read_row(line, std::move(cells));
  }
  return std::move(reader.groups);
}

std::vector<const AgsGroup*> find_groups(const std::vector<AgsGroup>& groups, std::string_view name) {
  std::vector<const AgsGroup*> found;
  for (const AgsGroup& group : groups)
    if (group.name == name) found.push_back(&group);
  return found;
}

}  // namespace cpt::recordings

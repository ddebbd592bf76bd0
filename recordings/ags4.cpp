#include "recordings/ags4.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "recordings/ags4_groups.hpp"
#include "recordings/decimal_mark.hpp"
#include "recordings/inclination.hpp"
#include "recordings/units.hpp"
#include "recordings/unknown_facts.hpp"

namespace cpt::recordings {
namespace {

struct Heading {
  const char* name;
  const char* what;
  Dimension dimension;
  const char* unit;  // the format's
  double Reading::*place;
};
constexpr std::array scpt_headings = {
    Heading{"SCPT_DPTH", "depth", Dimension::length, "m", &Reading::depth},
    Heading{"SCPT_RES", "q_c", Dimension::pressure, "MN/m2", &Reading::q_c},
    Heading{"SCPT_FRES", "f_s", Dimension::pressure, "kN/m2", &Reading::f_s},
    Heading{"SCPT_PWP2", "u_2", Dimension::pressure, "kN/m2", &Reading::u_2},
};
constexpr std::array slopes = {"SCPT_SLP1", "SCPT_SLP2"};  // deg, across each other

std::string push_of(const AgsGroup& group, const AgsRow& row) {
  const std::string number = group.text(row, "SCPG_TESN");
  return group.text(row, "LOCA_ID") + (number.empty() ? "" : "/" + number);
}

bool names(const std::string& wanted, const std::string& push) {
  return wanted == push || push.starts_with(wanted + "/");
}

// A group SCPT with what its headings mean. Another one may have other headings and units.
struct Source {
  const AgsGroup* group;
  std::array<std::optional<std::size_t>, scpt_headings.size()> places;
  std::array<double, scpt_headings.size()> scales{};
  std::array<std::optional<std::size_t>, slopes.size()> slope_places;
  std::array<double, slopes.size()> slope_scales{};
};

class PushReader {
 public:
  PushReader(const std::vector<AgsGroup>& groups, Recording& recording, Problems& problems)
      : groups_(groups), recording_(recording), problems_(problems) {}

  void read(const std::string& wanted) {
    const std::vector<const AgsGroup*> found = find_groups(groups_, "SCPT");
    if (found.empty()) return no_group();
    for (const AgsGroup* group : found)
      for (const char* needed : {"SCPT_DPTH", "SCPT_RES"})
        if (!group->place_of(needed))
          problems_.add(group->line, 1, "group SCPT without " + std::string(needed), "this heading");
    if (problems_.any() || !choose_push(found, wanted)) return;
    if (found.size() > 1)
      recording_.remarks.push_back({{0, found[1]->line, found.back()->line},
                                    fmt::format("{} groups SCPT", found.size()),
                                    "rows of all are read",
                                    "files that were joined repeat their groups"});
    read_facts();
    for (const AgsGroup* group : found) sources_.push_back(source(*group));
    if (problems_.any()) return;
    hear_decimal_mark();
    for (const Source& source : sources_) read_rows(source);
    if (others_.lines.rows > 0) recording_.set_aside.push_back(others_);
    if (repeated_.lines.rows > 0) recording_.set_aside.push_back(repeated_);
    mark_.tell(recording_);
    unknown_.tell(recording_);
  }

 private:
  void no_group() {
    std::string list;
    for (const AgsGroup& group : groups_) list += (list.empty() ? "" : ", ") + group.name;
    problems_.add(0, 0, "no group SCPT", "one: it holds the readings of a static cone penetration test",
                  list.empty() ? "" : "groups of this file: " + list.substr(0, 200));
  }

  bool choose_push(const std::vector<const AgsGroup*>& found, const std::string& wanted) {
    std::vector<std::string> pushes;
    for (const AgsGroup* group : found)
      for (const AgsRow& row : group->rows) {
        const std::string push = push_of(*group, row);
        if (std::find(pushes.begin(), pushes.end(), push) == pushes.end()) pushes.push_back(push);
      }
    std::string list;
    std::vector<std::string> fitting;
    for (const std::string& push : pushes) {
      if (list.size() < 200) list += (list.empty() ? "" : ", ") + push;
      if (wanted.empty() || names(wanted, push)) fitting.push_back(push);
    }
    if (pushes.empty()) {
      problems_.add(found.front()->line, 1, "group SCPT without data", "at least one reading");
      return false;
    }
    if (fitting.size() != 1) {
      problems_.add(0, 0,
                    wanted.empty() ? fmt::format("{} pushes", pushes.size())
                                   : fmt::format("{} pushes named {}", fitting.size(), in_quotes(wanted)),
                    "one push", "choose one of " + list);
      return false;
    }
    recording_.id = push_ = fitting.front();
    return true;
  }

  struct Described {
    const AgsGroup* group = nullptr;
    const AgsRow* row = nullptr;
  };

  // The first row of groups of a name that belongs to the chosen push.
  Described described(const std::string& name) {
    Described first;
    Lines contradicting;
    for (const AgsGroup* group : find_groups(groups_, name))
      for (const AgsRow& row : group->rows) {
        const bool ours = name == "PROJ"   ? true
                          : name == "SCPG" ? push_of(*group, row) == push_
                                           : names(group->text(row, "LOCA_ID"), push_);
        if (!ours) continue;
        if (first.row == nullptr)
          first = {group, &row};
        else if (!same_texts(first, {group, &row}))
          contradicting.add(row.line);
      }
    if (contradicting.rows > 0) {
      contradicting.rows = 0;
      recording_.remarks.push_back({contradicting, fmt::format("another row of {} with other values", name),
                                    "the first one counts", "the file contradicts itself"});
    }
    return first;
  }

  static bool same_texts(const Described& one, const Described& other) {
    return std::all_of(one.group->headings.begin(), one.group->headings.end(),
                       [&](const std::string& heading) {
                         return !other.group->place_of(heading) ||
                                one.group->text(*one.row, heading) == other.group->text(*other.row, heading);
                       });
  }

  void read_facts() {
    for (const std::string name : {"PROJ", "LOCA", "SCPG"}) {
      const auto [group, row] = described(name);
      if (row == nullptr) continue;
      for (std::size_t i = 0; i < group->headings.size(); ++i)
        if (!row->cells[i].text.empty())
          recording_.facts.push_back(
              {group->headings[i], row->cells[i].text, group->unit(group->headings[i])});
      if (name == "LOCA") {
        recording_.x = fact(*group, *row, "LOCA_NATE", Dimension::length, "m");
        recording_.y = fact(*group, *row, "LOCA_NATN", Dimension::length, "m");
        recording_.elevation = fact(*group, *row, "LOCA_GL", Dimension::length, "m");
        recording_.date = group->text(*row, "LOCA_STAR");
      }
      if (name == "SCPG") {
        recording_.cone_area = fact(*group, *row, "SCPG_CSA", Dimension::area, "cm2");
        recording_.area_quotient = fact(*group, *row, "SCPG_CAR", std::nullopt, "");
      }
    }
  }

  // Without a dimension: a ratio.
  double fact(const AgsGroup& group, const AgsRow& row, const std::string& heading,
              std::optional<Dimension> dimension, const char* unit) {
    const std::string text = group.text(row, heading);
    if (text.empty()) return not_given;
    const auto value = lone_number(trimmed(text));
    const std::string label = group.unit(heading);
    std::optional<double> scale = 1.0;
    if (dimension && value) scale = unit_of({heading, *dimension, label, unit, group.unit_line}, recording_);
    if (!value || !scale) {
      unknown_.add(row.line, heading, scale ? text : text + " " + label);
      return not_given;
    }
    return *value * *scale;
  }

  Source source(const AgsGroup& group) {
    Source source{&group, {}, {}, {}, {}};
    for (std::size_t i = 0; i < scpt_headings.size(); ++i)
      take(group, scpt_headings[i].name, scpt_headings[i].dimension, scpt_headings[i].unit, source.places[i],
           source.scales[i]);
    for (std::size_t i = 0; i < slopes.size(); ++i)
      take(group, slopes[i], Dimension::angle, "deg", source.slope_places[i], source.slope_scales[i]);
    return source;
  }

  void take(const AgsGroup& group, const std::string& heading, Dimension dimension, const char* standard,
            std::optional<std::size_t>& place, double& scale) {
    place = group.place_of(heading);
    if (!place) return;
    const std::string label = group.unit(heading);
    const int line = group.unit_line > 0 ? group.unit_line : group.line;
    if (const auto found = unit_of({heading, dimension, label, standard, line}, recording_)) {
      scale = *found;
    } else if (dimension == Dimension::angle) {
      place.reset();
      recording_.remarks.push_back({{0, line, line},
                                    fmt::format("unit of {} is {}", heading, in_quotes(label)),
                                    "not read",
                                    "it is no unit of an angle"});
    } else {
      problems_.add(line, group.unit_columns[*place], in_quotes(label),
                    fmt::format("the unit of {}: {}", heading, known_units(dimension)));
    }
  }

  void hear_decimal_mark() {
    for (const Source& source : sources_)
      for (const AgsRow& row : source.group->rows) {
        if (push_of(*source.group, row) != push_) continue;
        for (const auto& place : source.places)
          if (place) mark_.hear(trimmed(row.cells[*place].text));
        for (const auto& place : source.slope_places)
          if (place) mark_.hear(trimmed(row.cells[*place].text));
      }
  }

  void read_rows(const Source& source) {
    const std::size_t before = recording_.readings.size();
    for (const AgsRow& row : source.group->rows) {
      if (problems_.full()) return;
      ++recording_.rows_read;
      if (push_of(*source.group, row) != push_) {
        others_.lines.add(row.line);
        continue;
      }
      Reading reading;
      reading.line = row.line;
      for (std::size_t i = 0; i < scpt_headings.size(); ++i)
        if (source.places[i])
          reading.*scpt_headings[i].place =
              cell(row, *source.places[i], scpt_headings[i].name) * source.scales[i];
      if (source.slope_places[0] && source.slope_places[1])
        reading.inclination =
            resultant(cell(row, *source.slope_places[0], slopes[0]) * source.slope_scales[0],
                      cell(row, *source.slope_places[1], slopes[1]) * source.slope_scales[1]);
      if (!repeats(reading)) recording_.readings.push_back(reading);
    }
    for (std::size_t i = before; i < recording_.readings.size(); ++i)
      if (const Reading& reading = recording_.readings[i]; !std::isnan(reading.depth))
        earlier_.emplace(reading.depth, reading);
  }

  /// Whether a row says what one of an earlier group has said; another value at the same depth is a problem.
  bool repeats(const Reading& reading) {
    const auto [first, last] = earlier_.equal_range(reading.depth);
    if (std::isnan(reading.depth) || first == last) return false;
    const auto same = [&](double Reading::*place, const Reading& other) {
      return other.*place == reading.*place || (std::isnan(other.*place) && std::isnan(reading.*place));
    };
    for (auto it = first; it != last; ++it) {
      const Reading& other = it->second;
      if (same(&Reading::q_c, other) && same(&Reading::f_s, other) && same(&Reading::u_2, other) &&
          same(&Reading::inclination, other)) {
        repeated_.lines.add(reading.line);
        return true;
      }
    }
    problems_.add(reading.line, 1,
                  fmt::format("another reading at {:g} m than in line {}", reading.depth, first->second.line),
                  fmt::format("one at each depth of {}", push_),
                  "the file holds two versions of this push: remove one of the groups SCPT");
    return true;
  }

  double cell(const AgsRow& row, std::size_t place, const char* heading) {
    const PlacedText& cell = row.cells[place];
    const std::string_view text = trimmed(cell.text);
    if (text.empty()) return not_given;
    const auto found = mark_.number(text);
    if (!found)
      problems_.add(row.line, cell.column, in_quotes(cell.text),
                    fmt::format("a number or nothing ({})", heading), number_hint(text));
    return found.value_or(not_given);
  }

  const std::vector<AgsGroup>& groups_;
  Recording& recording_;
  Problems& problems_;
  std::vector<Source> sources_;
  std::string push_;
  DecimalMark mark_;
  UnknownFacts unknown_;
  SetAside others_{{}, "belongs to another push"};
  SetAside repeated_{{}, "says the same as a row of an earlier group SCPT"};
  std::multimap<double, Reading> earlier_;  // by depth, of the groups before
};

/// A group of AGS 3: "**PROJ".
bool is_ags3(std::string_view line) { return line.starts_with("\"**") || line.starts_with("**"); }

}  // namespace

bool is_ags4(std::string_view first_line) {
  return first_line.starts_with("\"GROUP\"") || first_line.starts_with("GROUP,") || is_ags3(first_line);
}

void read_ags4(const std::vector<Line>& lines, const ReadOptions& options, Recording& recording,
               Problems& problems) {
  for (const Line& line : lines)
    if (is_ags3(trimmed(line.text)))
      return problems.add(line.number, column_of(line.text, trimmed(line.text)),
                          in_quotes(trimmed(line.text)) + ", a group of AGS 3", "AGS 4",
                          "AGS 3 is not read: export it as AGS 4, or its readings (group STCN) as CSV");
  const std::vector<AgsGroup> groups = read_ags_groups(lines, problems);
  if (!problems.any()) PushReader(groups, recording, problems).read(options.push);
}

}  // namespace cpt::recordings

#include "recordings/ags4.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recordings/ags4_groups.hpp"
#include "recordings/inclination.hpp"
#include "recordings/units.hpp"

namespace cpt::recordings {
namespace {

struct Heading {
  const char* name;
  const char* what;
  Dimension dimension;
  const char* unit;  // the format's
  double Reading::*place;
};
constexpr std::array headings = {
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

class PushReader {
 public:
  PushReader(const std::vector<AgsGroup>& groups, Recording& recording, Problems& problems)
      : groups_(groups), recording_(recording), problems_(problems) {}

  void read(const std::string& wanted) {
    readings_ = find_group(groups_, "SCPT");
    if (readings_ == nullptr) return no_group();
    for (const char* needed : {"SCPT_DPTH", "SCPT_RES"})
      if (!readings_->place_of(needed))
        problems_.add(readings_->line, 1, "group SCPT without " + std::string(needed), "this heading");
    if (problems_.any() || !choose_push(wanted)) return;
    read_facts();
    read_rows();
  }

 private:
  void no_group() {
    std::string list;
    for (const AgsGroup& group : groups_) list += (list.empty() ? "" : ", ") + group.name;
    problems_.add(0, 0, "no group SCPT", "one: it holds the readings of a static cone penetration test",
                  list.empty() ? "" : "groups of this file: " + list.substr(0, 200));
  }

  bool choose_push(const std::string& wanted) {
    std::vector<std::string> pushes;
    for (const AgsRow& row : readings_->rows) {
      const std::string push = push_of(*readings_, row);
      if (std::find(pushes.begin(), pushes.end(), push) == pushes.end()) pushes.push_back(push);
    }
    std::string list;
    std::vector<std::string> fitting;
    for (const std::string& push : pushes) {
      if (list.size() < 200) list += (list.empty() ? "" : ", ") + push;
      if (wanted.empty() || names(wanted, push)) fitting.push_back(push);
    }
    if (pushes.empty()) {
      problems_.add(readings_->line, 1, "group SCPT without data", "at least one reading");
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

  // Rows of another group that belong to the chosen push.
  const AgsRow* row_of(const AgsGroup& group, bool whole_key) const {
    for (const AgsRow& row : group.rows)
      if (whole_key ? push_of(group, row) == push_ : names(group.text(row, "LOCA_ID"), push_)) return &row;
    return nullptr;
  }

  void read_facts() {
    for (const char* name : {"PROJ", "LOCA", "SCPG"}) {
      const AgsGroup* group = find_group(groups_, name);
      if (group == nullptr || group->rows.empty()) continue;
      const std::string kind = name;
      const AgsRow* row = kind == "PROJ" ? &group->rows.front() : row_of(*group, kind == "SCPG");
      if (row == nullptr) continue;
      for (std::size_t i = 0; i < group->headings.size(); ++i)
        if (!row->cells[i].text.empty())
          recording_.facts.push_back(
              {group->headings[i], row->cells[i].text, group->unit(group->headings[i])});
      if (kind == "LOCA") {
        recording_.x = value(*group, *row, "LOCA_NATE", Dimension::length, "m");
        recording_.y = value(*group, *row, "LOCA_NATN", Dimension::length, "m");
        recording_.elevation = value(*group, *row, "LOCA_GL", Dimension::length, "m");
        recording_.date = group->text(*row, "LOCA_STAR");
      }
      if (kind == "SCPG") {
        recording_.cone_area = value(*group, *row, "SCPG_CSA", Dimension::area, "cm2");
        if (const auto quotient = number(group->text(*row, "SCPG_CAR"))) recording_.area_quotient = *quotient;
      }
    }
  }

  double scale(const AgsGroup& group, const std::string& heading, Dimension dimension, const char* unit) {
    return unit_of({heading, dimension, group.unit(heading), unit, group.line}, recording_);
  }

  double value(const AgsGroup& group, const AgsRow& row, const std::string& heading, Dimension dimension,
               const char* unit) {
    const std::string text = group.text(row, heading);
    if (text.empty()) return not_given;
    if (const auto found = number(text)) return *found * scale(group, heading, dimension, unit);
    problems_.add(row.line, row.cells[*group.place_of(heading)].column, in_quotes(text),
                  "a number or nothing (" + heading + ")", number_hint(text));
    return not_given;
  }

  void read_rows() {
    std::array<double, headings.size()> scales{};
    for (std::size_t i = 0; i < headings.size(); ++i)
      if (readings_->place_of(headings[i].name))
        scales[i] = scale(*readings_, headings[i].name, headings[i].dimension, headings[i].unit);
    std::array<double, 2> slope_scales{};
    for (std::size_t i = 0; i < slopes.size(); ++i)
      if (readings_->place_of(slopes[i]))
        slope_scales[i] = scale(*readings_, slopes[i], Dimension::angle, "deg");
    SetAside others{{}, "belongs to another push"};
    for (const AgsRow& row : readings_->rows) {
      if (problems_.full()) return;
      ++recording_.rows_read;
      if (push_of(*readings_, row) != push_) {
        others.lines.add(row.line);
        continue;
      }
      Reading reading;
      reading.line = row.line;
      for (std::size_t i = 0; i < headings.size(); ++i)
        if (scales[i] > 0.0) reading.*headings[i].place = cell(row, headings[i].name) * scales[i];
      const bool both = slope_scales[0] > 0.0 && slope_scales[1] > 0.0;
      if (both)
        reading.inclination =
            resultant(cell(row, slopes[0]) * slope_scales[0], cell(row, slopes[1]) * slope_scales[1]);
      recording_.readings.push_back(reading);
    }
    if (others.lines.rows > 0) recording_.set_aside.push_back(others);
  }

  double cell(const AgsRow& row, const char* heading) {
    const PlacedText& cell = row.cells[*readings_->place_of(heading)];
    if (trimmed(cell.text).empty()) return not_given;
    const auto found = number(trimmed(cell.text));
    if (!found)
      problems_.add(row.line, cell.column, in_quotes(cell.text),
                    fmt::format("a number or nothing ({})", heading), number_hint(cell.text));
    return found.value_or(not_given);
  }

  const std::vector<AgsGroup>& groups_;
  Recording& recording_;
  Problems& problems_;
  const AgsGroup* readings_ = nullptr;
  std::string push_;
};

}  // namespace

bool is_ags4(std::string_view first_line) {
  return first_line.starts_with("\"GROUP\"") || first_line.starts_with("GROUP,");
}

void read_ags4(const std::vector<Line>& lines, const ReadOptions& options, Recording& recording,
               Problems& problems) {
  const std::vector<AgsGroup> groups = read_ags_groups(lines, problems);
  if (!problems.any()) PushReader(groups, recording, problems).read(options.push);
}

}  // namespace cpt::recordings

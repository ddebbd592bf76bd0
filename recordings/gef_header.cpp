#include "recordings/gef_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recordings/units.hpp"

namespace cpt::recordings {
namespace {

constexpr int most_columns = 500;

// MEASUREMENTVAR by number, as far as it has a place in a recording.
struct Variable {
  int number;
  Dimension dimension;
  const char* standard;  // unit
  double& (*place)(Recording&);
};
const std::array variables = {
    Variable{1, Dimension::area, "mm2", [](Recording& r) -> double& { return r.cone_area; }},
    Variable{13, Dimension::length, "m", [](Recording& r) -> double& { return r.predrilled_depth; }},
    Variable{16, Dimension::length, "m", [](Recording& r) -> double& { return r.stated_end; }},
    Variable{20, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.q_c_zero.before; }},
    Variable{21, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.q_c_zero.after; }},
    Variable{22, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.f_s_zero.before; }},
    Variable{23, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.f_s_zero.after; }},
    Variable{26, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.u_2_zero.before; }},
    Variable{27, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.u_2_zero.after; }},
};

class HeaderReader {
 public:
  HeaderReader(Recording& recording, Problems& problems) : recording_(recording), problems_(problems) {}

  GefHeader read(const std::vector<Line>& lines) {
    for (std::size_t i = 0; i < lines.size() && !problems_.full(); ++i) {
      line_ = lines[i];
      const std::string_view text = trimmed(line_.text);
      if (text.empty()) continue;
      if (text.front() != '#') {
        problem(text, "a header line that starts with '#', or #EOH= before the data",
                "does #EOH= end the header?");
        return header_;
      }
      if (read_entry(text.substr(1))) {
        header_.data = i + 1;
        finish();
        return header_;
      }
    }
    problems_.add(line_.number, 1, "the end of the file", "#EOH= at the end of the header",
                  "the file seems to be cut off");
    return header_;
  }

 private:
  void problem(std::string_view at, std::string expected, std::string hint = {}) {
    problems_.add(line_.number, column_of(line_.text, at), in_quotes(at), std::move(expected),
                  std::move(hint));
  }

  /// True at #EOH=.
  bool read_entry(std::string_view entry) {
    const std::size_t equals = std::min(entry.find('='), entry.size());
    const std::string key = lower_case(trimmed(entry.substr(0, equals)));
    const std::string_view value = trimmed(entry.substr(std::min(equals + 1, entry.size())));
    if (key == "eoh") return true;
    std::vector<Field> fields = split(value, ',');
    const auto text = [&](std::size_t i) { return i < fields.size() ? fields[i].text : std::string_view(); };
    if (key == "column") {
      if (const auto count = whole_number(text(0), 1, most_columns))
        column(*count);
      else
        problem(text(0), fmt::format("the number of columns, 1 to {}", most_columns));
    } else if (key == "columninfo") {
      read_column_info(fields);
    } else if (key == "columnvoid") {
      const auto index = whole_number(text(0), 1, most_columns);
      const auto value_of_void = number(text(1));
      if (index && value_of_void)
        column(*index).void_value = value_of_void;
      else
        problem(value, "column number, value that means void");
    } else if (key == "columnseparator" || key == "recordseparator") {
      if (!value.empty()) (key[0] == 'c' ? header_.column_separator : header_.record_separator) = value[0];
    } else if (key == "dataformat" && lower_case(value).starts_with("binary")) {
      problem(value, "ASCII data", "binary GEF files are not read; export it as ASCII");
    } else if ((key == "procedurecode" || key == "reportcode") &&
               lower_case(text(0)).starts_with("gef-bore")) {
      problem(text(0), "GEF-CPT-Report", "this is a borehole, not a cone penetration test");
    } else if (key == "lastscan") {
      header_.last_scan = whole_number(text(0), 0, 1'000'000'000);
    } else {
      read_fact(key, value, fields);
    }
    return false;
  }

  GefColumn& column(int index) {
    if (header_.columns.size() < static_cast<std::size_t>(index))
      header_.columns.resize(static_cast<std::size_t>(index));
    return header_.columns[static_cast<std::size_t>(index) - 1];
  }

  void read_column_info(const std::vector<Field>& fields) {
    // Names may hold commas; the quantity is the last field.
    const auto index = fields.size() < 4 ? std::nullopt : whole_number(fields[0].text, 1, most_columns);
    const auto quantity = fields.size() < 4 ? std::nullopt : whole_number(fields.back().text, 1, 1'000'000);
    if (!index || !quantity)
      return problem(trimmed(line_.text), "#COLUMNINFO= column, unit, name, quantity number",
                     "quantities: 1 length, 2 q_c, 3 f_s, 6 u_2, 8 inclination, 11 corrected depth, 12 time");
    GefColumn& info = column(*index);
    info.quantity = *quantity;
    info.unit = std::string(fields[1].text);
    info.name = std::string(fields[2].text);
    info.line = line_.number;
  }

  void read_fact(const std::string& key, std::string_view value, const std::vector<Field>& fields) {
    const auto value_of = [&](std::size_t i) {
      const auto found = i < fields.size() ? number(fields[i].text) : std::nullopt;
      return found ? *found : not_given;
    };
    if (key == "testid" && !value.empty()) recording_.id = std::string(value);
    if (key == "xyid") {
      recording_.x = value_of(1);
      recording_.y = value_of(2);
    }
    if (key == "zid") recording_.elevation = value_of(1);
    if (key == "startdate" || (key == "filedate" && recording_.date.empty())) read_date(value, fields);
    if (key == "measurementvar") read_variable(fields);
    if (key == "measurementvar" || key == "measurementtext") {
      // number, value, unit, what it is; or number, text, what it is
      const bool has_unit = key == "measurementvar" && fields.size() > 3;
      const std::string number = fields.empty() ? "" : std::string(fields[0].text);
      const std::string meaning = fields.size() > 2 ? std::string(fields.back().text) : "";
      recording_.facts.push_back({fmt::format("{} {}: {}", key, number, meaning),
                                  fields.size() > 1 ? std::string(fields[1].text) : "",
                                  has_unit ? std::string(fields[2].text) : ""});
    } else if (key != "columnminmax" && key != "firstscan") {
      recording_.facts.push_back({key, std::string(value), ""});
    }
  }

  void read_date(std::string_view value, const std::vector<Field>& fields) {
    std::array<int, 3> parts{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto part = i < fields.size() ? whole_number(fields[i].text, 0, 9999) : std::nullopt;
      if (!part) {
        recording_.date = std::string(value);
        return;
      }
      parts[i] = *part;
    }
    recording_.date = fmt::format("{:04}-{:02}-{:02}", parts[0], parts[1], parts[2]);
  }

  void read_variable(const std::vector<Field>& fields) {
    const auto index = fields.empty() ? std::nullopt : whole_number(fields[0].text, 1, 100000);
    if (!index || fields.size() < 2) return;
    const auto value = number(fields[1].text);
    const auto* variable = std::find_if(variables.begin(), variables.end(),
                                        [&](const Variable& v) { return v.number == *index; });
    const bool wanted = variable != variables.end() || *index == 3;
    if (!wanted) return;
    if (!value)
      return problem(fields[1].text, fmt::format("the number of measurementvar {}", *index),
                     number_hint(fields[1].text));
    if (*index == 3) {
      recording_.area_quotient = *value;
      return;
    }
    const std::string_view label = fields.size() > 2 ? fields[2].text : std::string_view();
    variable->place(recording_) =
        *value * unit_of({fmt::format("measurementvar {}", *index), variable->dimension,
                          label.empty() || label == "-" ? variable->standard : label, variable->standard,
                          line_.number},
                         recording_);
  }

  void finish() {
    for (ZeroReading* zero : {&recording_.q_c_zero, &recording_.f_s_zero, &recording_.u_2_zero})
      zero->drift = zero->after - zero->before;
    if (header_.columns.empty())
      problems_.add(line_.number, 1, "a header without #COLUMNINFO", "one for each column");
  }

  Recording& recording_;
  Problems& problems_;
  GefHeader header_;
  Line line_{1, {}};
};

}  // namespace

GefHeader read_gef_header(const std::vector<Line>& lines, Recording& recording, Problems& problems) {
  return HeaderReader(recording, problems).read(lines);
}

}  // namespace cpt::recordings

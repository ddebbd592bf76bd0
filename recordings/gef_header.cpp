#include "recordings/gef_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recordings/decimal_mark.hpp"
#include "recordings/gef_entries.hpp"
#include "recordings/units.hpp"
#include "recordings/unknown_facts.hpp"

namespace cpt::recordings {
namespace {

constexpr int most_columns = 500;
constexpr const char* joined_files = "were two files joined? take them apart";

// MEASUREMENTVAR by number, as far as it has a place in a recording.
struct Variable {
  int number;
  Dimension dimension;
  const char* standard;  // unit; nullptr: a ratio
  double& (*place)(Recording&);
};
const std::array variables = {
    Variable{1, Dimension::area, "mm2", [](Recording& r) -> double& { return r.cone_area; }},
    Variable{3, Dimension::area, nullptr, [](Recording& r) -> double& { return r.area_quotient; }},
    Variable{13, Dimension::length, "m", [](Recording& r) -> double& { return r.predrilled_depth; }},
    Variable{16, Dimension::length, "m", [](Recording& r) -> double& { return r.stated_end; }},
    Variable{20, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.q_c_zero.before; }},
    Variable{21, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.q_c_zero.after; }},
    Variable{22, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.f_s_zero.before; }},
    Variable{23, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.f_s_zero.after; }},
    Variable{26, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.u_2_zero.before; }},
    Variable{27, Dimension::pressure, "MPa", [](Recording& r) -> double& { return r.u_2_zero.after; }},
};

// Least numbers of fields of entries with numbers: fewer are left by a comma that sets fields apart.
constexpr std::size_t fields_of_position = 3, fields_of_height = 2, fields_of_void = 2;

class HeaderReader {
 public:
  HeaderReader(Recording& recording, Problems& problems) : recording_(recording), problems_(problems) {}

  GefHeader read(const std::vector<Line>& lines) {
    const GefEntries entries = read_gef_entries(lines, problems_);
    header_.data = entries.data;
    Lines wrapped;
    for (const GefEntry& entry : entries.entries) {
      if (problems_.full()) break;
      entry_ = &entry;
      read_entry();
      for (std::size_t i = 1; i < entry.lines().size(); ++i) wrapped.add(entry.lines()[i].number);
    }
    if (problems_.any()) return header_;
    if (wrapped.rows > 0) {
      wrapped.rows = 0;
      recording_.remarks.push_back({wrapped, "header lines without '#'", "joined to the line before",
                                    "long entries are wrapped by some programs"});
    }
    finish();
    return header_;
  }

 private:
  void problem(std::string_view at, std::string expected, std::string hint = {}) {
    entry_->problem(at, std::move(expected), std::move(hint), problems_);
  }

  void read_entry() {
    const std::string key = entry_->key();
    const std::string_view value = entry_->value();
    const std::vector<Field> fields = entry_->fields();
    const std::string_view first = fields.empty() ? std::string_view() : fields[0].text;
    if (key == "column") {
      read_column_count(first);
    } else if (key == "columninfo") {
      read_column_info(fields);
    } else if (key == "columnvoid") {
      read_void(fields);
    } else if (key == "columntext") {
      header_.texts =
          fields.size() < 2 || (lower_case(fields[1].text) != "off" && lower_case(fields[1].text) != "uit");
    } else if (key == "columnseparator" || key == "recordseparator") {
      if (!value.empty()) (key[0] == 'c' ? header_.column_separator : header_.record_separator) = value[0];
    } else if (key == "dataformat" && lower_case(value).starts_with("binary")) {
      problem(value, "ASCII data", "binary GEF files are not read; export it as ASCII");
    } else if ((key == "procedurecode" || key == "reportcode") && lower_case(first).starts_with("gef-bore")) {
      problem(first, "GEF-CPT-Report", "this is a borehole, not a cone penetration test");
    } else if (key == "lastscan") {
      header_.last_scan = whole_number(first, 0, 1'000'000'000);
    } else {
      read_fact(key, value, fields);
    }
  }

  GefColumn& column(int index) {
    if (header_.columns.size() < static_cast<std::size_t>(index))
      header_.columns.resize(static_cast<std::size_t>(index));
    return header_.columns[static_cast<std::size_t>(index) - 1];
  }

  void read_column_count(std::string_view text) {
    const auto count = whole_number(text, 1, most_columns);
    if (!count) return problem(text, fmt::format("the number of columns, 1 to {}", most_columns));
    if (columns_ && *columns_ != *count)
      return problem(text, fmt::format("{} columns, as #COLUMN said before", *columns_), joined_files);
    columns_ = count;
    column(*count);
  }

  void read_column_info(const std::vector<Field>& fields) {
    // Names may hold commas; the quantity is the last field, 0 where it has no number.
    const auto index = fields.size() < 4 ? std::nullopt : whole_number(fields[0].text, 1, most_columns);
    if (!index)
      return problem(entry_->value(), "#COLUMNINFO= column, unit, name, quantity number",
                     "quantities: 1 length, 2 q_c, 3 f_s, 6 u_2, 8 inclination, 11 corrected depth, 12 time");
    const auto quantity = whole_number(fields.back().text, 0, 1'000'000);
    if (!quantity) unknown_.add(entry_->line(), fmt::format("columninfo {}", *index), fields.back().text);
    GefColumn& info = column(*index);
    if (info.line > 0 && (info.quantity != quantity.value_or(0) || info.unit != fields[1].text))
      return problem(entry_->value(),
                     fmt::format("column {} once: line {} says something else of it", *index, info.line),
                     joined_files);
    info.quantity = quantity.value_or(0);
    info.unit = std::string(fields[1].text);
    info.name = std::string(fields[2].text);
    info.line = entry_->place_of(fields[1].text).line;
    info.unit_column = entry_->place_of(fields[1].text).column;
  }

  void read_void(const std::vector<Field>& fields) {
    const auto index = fields.empty() ? std::nullopt : whole_number(fields[0].text, 1, most_columns);
    if (!index || fields.size() < 2) return problem(entry_->value(), "column number, value that means void");
    const bool cut = fields.size() == fields_of_void + 1 && cut_number(fields, 1);
    const std::string_view text = cut ? joined(fields[1], fields[2]) : fields[1].text;
    GefColumn& info = column(*index);
    // A comma among the digits of a lone value is a decimal mark: there is nothing to set apart.
    if (cut)
      info.void_values.push_back(
          number_of_any_size(std::string(fields[1].text) + "." + std::string(fields[2].text)).value());
    else if (const auto value = number_of_any_size(text))
      info.void_values.push_back(*value);
    else
      info.void_texts.push_back(lower_case(text));
  }

  void read_fact(const std::string& key, std::string_view value, const std::vector<Field>& fields) {
    if (key == "testid" && !value.empty()) recording_.id = std::string(value);
    if (key == "xyid") {
      const auto whole = coordinates(fields, fields_of_position);
      recording_.x = coordinate(key, whole, 1);
      recording_.y = coordinate(key, whole, 2);
    }
    if (key == "zid") recording_.elevation = coordinate(key, coordinates(fields, fields_of_height), 1);
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

  /// Fields of a position. Where a comma may be decimal mark or not, the fields are one, which is no number.
  static std::vector<Field> coordinates(const std::vector<Field>& fields, std::size_t least) {
    constexpr std::size_t most_decimals = 3;  // more may be a coordinate of its own
    std::vector<Field> whole = with_decimal_commas(fields);
    if (whole.size() < least) return fields;
    const bool cut = whole.size() == fields.size() && fields.size() > least && cut_number(fields, 1) &&
                     fields[2].text.size() <= most_decimals;
    const bool long_decimals = std::any_of(whole.begin(), whole.end(), [&](const Field& field) {
      const std::size_t comma = field.text.find(',');
      return comma != field.text.npos && field.text.size() - comma > most_decimals + 1;
    });
    if (cut || (least == fields_of_position && long_decimals))
      whole = {fields.front(), {joined(fields[1], fields.back()), fields[1].column}};
    return whole;
  }

  double coordinate(const std::string& key, const std::vector<Field>& fields, std::size_t at) {
    if (at >= fields.size()) return not_given;
    const auto value = lone_number(fields[at].text);
    if (!value) unknown_.add(entry_->line(), key, fields[at].text);
    return value.value_or(not_given);
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

  void read_variable(const std::vector<Field>& cut_fields) {
    std::vector<Field> fields = with_decimal_commas(cut_fields);
    // Also without blanks a unit is no number.
    if (fields.size() == cut_fields.size() && cut_number(fields, 1)) {
      fields[1].text = joined(fields[1], fields[2]);
      fields.erase(fields.begin() + 2);
    }
    const auto index = fields.empty() ? std::nullopt : whole_number(fields[0].text, 1, 100000);
    if (!index || fields.size() < 2) return;
    const auto* variable = std::find_if(variables.begin(), variables.end(),
                                        [&](const Variable& v) { return v.number == *index; });
    if (variable == variables.end()) return;
    const std::string name = fmt::format("measurementvar {}", *index);
    const std::string_view label = fields.size() > 2 ? fields[2].text : std::string_view();
    const auto value = lone_number(fields[1].text);
    if (!value) return unknown_.add(entry_->line(), name, fields[1].text);
    std::optional<double> scale = 1.0;
    if (variable->standard != nullptr)
      scale =
          label.empty() || label == "-"
              ? scale_of(variable->dimension, variable->standard)
              : unit_of({name, variable->dimension, label, variable->standard, entry_->line()}, recording_);
    if (!scale) return unknown_.add(entry_->line(), name, fmt::format("{} {}", fields[1].text, label));
    double& place = variable->place(recording_);
    const double found = *value * *scale;
    if (!std::isnan(place) && place != found) twice_.add(entry_->line());
    place = found;
  }

  void finish() {
    for (ZeroReading* zero : {&recording_.q_c_zero, &recording_.f_s_zero, &recording_.u_2_zero})
      zero->drift = zero->after - zero->before;
    unknown_.tell(recording_);
    if (twice_.rows > 0) {
      twice_.rows = 0;
      recording_.remarks.push_back({twice_, "a second measurementvar of the same number with another value",
                                    "the last one counts", "the header contradicts itself"});
    }
    if (header_.columns.empty())
      problems_.add(static_cast<int>(header_.data), 1, "a header without #COLUMNINFO", "one for each column");
  }

  Recording& recording_;
  Problems& problems_;
  GefHeader header_;
  std::optional<int> columns_;
  UnknownFacts unknown_;
  Lines twice_;
  const GefEntry* entry_ = nullptr;
};

}  // namespace

GefHeader read_gef_header(const std::vector<Line>& lines, Recording& recording, Problems& problems) {
  return HeaderReader(recording, problems).read(lines);
}

}  // namespace cpt::recordings

#include "cli/soundings/recording_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cli/common/cells.hpp"
#include "cli/soundings/recording_interpretation.hpp"

namespace cpt::cli {
namespace {

using recordings::Interpretation;
using recordings::Reading;
using recordings::Recording;
using results::Cell;
using results::Table;

struct MeasuredQuantity {
  const char* name;
  const char* unit;
  double scale;  // of the unit, in SI
  double Reading::*place;
};
constexpr MeasuredQuantity measured_quantities[] = {
    {"depth", "m", 1.0, &Reading::depth},
    {"length", "m", 1.0, &Reading::length},
    {"q_c", "kPa", 1e3, &Reading::q_c},
    {"f_s", "kPa", 1e3, &Reading::f_s},
    {"u_2", "kPa", 1e3, &Reading::u_2},
    {"inclination", "deg", std::numbers::pi / 180.0, &Reading::inclination},
    {"speed", "mm/s", 1e-3, &Reading::speed},
    {"time", "s", 1.0, &Reading::time},
};

Table facts_table(const Recording& r) {
  Table table{{"fact", "value", "unit"}, {}};
  const auto text = [&](const char* name, std::string_view value) {
    if (!value.empty()) table.rows.push_back({name, std::string(value), ""});
  };
  const auto number = [&](const char* name, double value, const char* unit) {
    if (!std::isnan(value)) table.rows.push_back({name, value, unit});
  };
  text("file", r.file);
  text("format", r.format);
  text("id", r.id);
  text("date", r.date);
  number("x", r.x, "m");
  number("y", r.y, "m");
  number("elevation", r.elevation, "m");
  number("predrilled", r.predrilled_depth, "m");
  number("cone area", r.cone_area * 1e4, "cm2");
  number("area quotient", r.area_quotient, "");
  text("depth", name_of(r.depth_rule));
  number("rows read", r.rows_read, "");
  number("rows kept", static_cast<double>(r.readings.size()), "");
  int aside = 0;
  for (const recordings::SetAside& set : r.set_aside) aside += set.lines.rows;
  number("rows set aside", aside, "");
  return table;
}

Table quantity_table(const Recording& r, const Interpretation& interpretation) {
  Table table{{"quantity", "unit", "values", "void", "min", "median", "max"}, {}};
  const auto add = [&](const char* name, const char* unit, double scale, const std::vector<double>& values) {
    const recordings::Spread s = recordings::spread(values);
    if (s.values == 0) return;
    table.rows.push_back({name, unit, whole(s.values),
                          whole(r.readings.size() - static_cast<std::size_t>(s.values)), cell(s.min / scale),
                          cell(s.median / scale), cell(s.max / scale)});
  };
  for (const MeasuredQuantity& quantity : measured_quantities)
    add(quantity.name, quantity.unit, quantity.scale, column(r, quantity.place));
  for (const DerivedColumn& derived : derived_columns(interpretation))
    if (std::string_view name = derived.name; name != "zone" && (name != "q_t" || interpretation.corrected))
      add(derived.name, derived.unit, 1.0, derived.values);
  return table;
}

Table aside_table(const Recording& r) {
  Table table{{"rows", "first_line", "last_line", "reason"}, {}};
  for (const recordings::SetAside& set : r.set_aside)
    table.rows.push_back({whole(set.lines.rows), whole(set.lines.first), whole(set.lines.last), set.reason});
  return table;
}

Table remark_table(const Recording& r) {
  Table table{{"rows", "first_line", "last_line", "found", "done", "why"}, {}};
  for (const recordings::Remark& remark : r.remarks)
    table.rows.push_back({whole(remark.lines.rows), whole(remark.lines.first), whole(remark.lines.last),
                          remark.found, remark.done, remark.why});
  return table;
}

Table header_table(const Recording& r) {
  Table table{{"name", "value", "unit"}, {}};
  for (const recordings::Fact& fact : r.facts) table.rows.push_back({fact.name, fact.value, fact.unit});
  return table;
}

std::string place(const recordings::Lines& lines) {
  if (lines.first == 0) return "the file";
  const std::string where = lines.first == lines.last
                                ? fmt::format("line {}", lines.first)
                                : fmt::format("lines {} to {}", lines.first, lines.last);
  if (lines.rows == 0) return where;
  return fmt::format("{} row{}, {}", lines.rows, lines.rows == 1 ? "" : "s", where);
}

std::string summary_to_read(const Recording& r, const Interpretation& interpretation) {
  std::string text;
  for (const auto& row : facts_table(r).rows) {
    const auto& unit = std::get<std::string>(row[2]);
    const auto* number = std::get_if<double>(&row[1]);
    const std::string value =
        number != nullptr ? fmt::format("{:.10g}", *number) : std::get<std::string>(row[1]);
    text +=
        fmt::format("{:<15} {}{}{}\n", std::get<std::string>(row[0]), value, unit.empty() ? "" : " ", unit);
  }
  text += '\n';
  text += results::format(quantity_table(r, interpretation), results::Format::table);
  text += interpretation_text(r, interpretation);
  if (!r.set_aside.empty()) text += "\nSet aside\n";
  for (const recordings::SetAside& set : r.set_aside)
    text += fmt::format("  {}: {}\n", place(set.lines), set.reason);
  text += r.remarks.empty() ? "\nNothing to remark\n" : "\nRemarks\n";
  for (const recordings::Remark& remark : r.remarks)
    text +=
        fmt::format("  {}: {}\n    -> {}: {}\n", place(remark.lines), remark.found, remark.done, remark.why);
  return text;
}

// The parts below each other, with the columns of all.
std::string as_csv(const Recording& r, const Interpretation& interpretation) {
  Table all{{"part"}, {}};
  const auto add = [&](const std::string& part, const Table& table) {
    for (const std::string& column : table.columns)
      if (std::find(all.columns.begin(), all.columns.end(), column) == all.columns.end())
        all.columns.push_back(column);
    for (const auto& row : table.rows) {
      auto& line = all.rows.emplace_back();
      line.emplace_back(part);
      for (std::size_t i = 0; i < row.size(); ++i) {
        const auto at = static_cast<std::size_t>(
            std::find(all.columns.begin(), all.columns.end(), table.columns[i]) - all.columns.begin());
        line.resize(std::max(line.size(), at + 1));
        line[at] = row[i];
      }
    }
  };
  add("recording", facts_table(r));
  add("quantity", quantity_table(r, interpretation));
  for (const results::NamedTable& part : interpretation_tables(r, interpretation)) add(part.name, part.table);
  add("set aside", aside_table(r));
  add("remark", remark_table(r));
  add("header", header_table(r));
  for (auto& row : all.rows) row.resize(all.columns.size());
  return results::format(all, results::Format::csv);
}

std::string as_json(const Recording& r, const Interpretation& interpretation) {
  std::string text = "{";
  const auto add = [&](const std::string& part, const Table& table) {
    text += fmt::format("{}\n\"{}\": {}", text.size() == 1 ? "" : ",", part,
                        results::format(table, results::Format::json));
    text.pop_back();  // the line break
  };
  add("recording", facts_table(r));
  add("quantities", quantity_table(r, interpretation));
  for (const results::NamedTable& part : interpretation_tables(r, interpretation)) add(part.name, part.table);
  add("set_aside", aside_table(r));
  add("remarks", remark_table(r));
  add("header", header_table(r));
  return text + "\n}\n";
}

}  // namespace

std::string summary(const Recording& recording, const Interpretation& interpretation,
                    results::Format format) {
  switch (format) {
    case results::Format::csv:
      return as_csv(recording, interpretation);
    case results::Format::json:
      return as_json(recording, interpretation);
    case results::Format::table:
      break;
  }
  return summary_to_read(recording, interpretation);
}

Table readings_table(const Recording& recording, const Interpretation& interpretation) {
  Table table{{"line", "depth_m", "length_m", "q_c_kPa", "f_s_kPa", "u_2_kPa", "inclination_deg",
               "speed_mm_per_s", "time_s", "predrilled", "after_stop"},
              {}};
  const std::vector<DerivedColumn> derived = derived_columns(interpretation);
  for (const DerivedColumn& column : derived) table.columns.emplace_back(column.header);
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    const Reading& reading = recording.readings[i];
    auto& row = table.rows.emplace_back();
    row.push_back(whole(reading.line));
    for (const MeasuredQuantity& quantity : measured_quantities)
      row.push_back(cell(reading.*quantity.place / quantity.scale));
    row.push_back(whole(reading.predrilled ? 1 : 0));
    row.push_back(whole(reading.after_stop ? 1 : 0));
    for (const DerivedColumn& column : derived) row.push_back(cell(column.values[i]));
  }
  return table;
}

}  // namespace cpt::cli

#include "recordings/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "recordings/delimited.hpp"
#include "recordings/units.hpp"

namespace cpt::recordings {
namespace {

struct Quantity {
  std::string_view name;
  Dimension dimension;
  double Reading::*place;
};
constexpr std::array quantities = {
    Quantity{"depth", Dimension::length, &Reading::depth},
    Quantity{"length", Dimension::length, &Reading::length},
    Quantity{"q_c", Dimension::pressure, &Reading::q_c},
    Quantity{"f_s", Dimension::pressure, &Reading::f_s},
    Quantity{"u_2", Dimension::pressure, &Reading::u_2},
    Quantity{"inclination", Dimension::angle, &Reading::inclination},
    Quantity{"speed", Dimension::speed, &Reading::speed},
    Quantity{"time", Dimension::time, &Reading::time},
};
constexpr const char* known_quantities =
    "depth_m, length_m, q_c_MPa, f_s_kPa, u_2_kPa, inclination_deg, speed_mm_per_s, time_s";

struct Meaning {
  const Quantity* quantity;
  double scale;
};

std::optional<Meaning> meaning_of(std::string_view name) {
  for (const Quantity& quantity : quantities) {
    if (!name.starts_with(quantity.name) || name.size() <= quantity.name.size() + 1 ||
        name[quantity.name.size()] != '_')
      continue;
    if (const auto scale = scale_of(quantity.dimension, name.substr(quantity.name.size() + 1)))
      return Meaning{&quantity, *scale};
  }
  return std::nullopt;
}

struct Place {
  const char* name;
  double Recording::*place;
  double scale;
};
constexpr std::array places = {
    Place{"x_m", &Recording::x, 1.0},
    Place{"y_m", &Recording::y, 1.0},
    Place{"elevation_m", &Recording::elevation, 1.0},
    Place{"predrilled_m", &Recording::predrilled_depth, 1.0},
    Place{"cone_area_cm2", &Recording::cone_area, 1e-4},
    Place{"area_quotient", &Recording::area_quotient, 1.0},
};

struct Taken {
  std::size_t column;  // from 0
  Meaning meaning;
  std::string quantity;
};

class CsvReader {
 public:
  CsvReader(const ReadOptions& options, Recording& recording, Problems& problems)
      : options_(options), recording_(recording), problems_(problems) {}

  void read(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
      if (problems_.full()) return;
      const std::string_view text = trimmed(line.text);
      if (text.empty()) continue;
      if (text.front() == '#')
        read_comment(line, trimmed(text.substr(1)));
      else if (columns_ == 0)
        read_names(line);
      else if (!problems_.any() || !taken_.empty())
        read_row(line);
    }
    if (columns_ == 0)
      problems_.add(0, 0, "no line of column names", "one before the rows",
                    "lines that start with # do not count");
  }

 private:
  void read_comment(const Line& line, std::string_view comment) {
    const auto equals = comment.find('=');
    if (equals == comment.npos) return;
    const std::string key(trimmed(comment.substr(0, equals)));
    const std::string_view text = trimmed(comment.substr(equals + 1));
    if (key == "id") recording_.id = std::string(text);
    if (key == "date") recording_.date = std::string(text);
    for (const Place& place : places) {
      if (key != place.name) continue;
      if (const auto value = number(text))
        recording_.*(place.place) = *value * place.scale;
      else
        problems_.add(line.number, column_of(line.text, text), in_quotes(text), "a number (" + key + ")",
                      number_hint(text));
    }
    recording_.facts.push_back({key, std::string(text), ""});
  }

  void read_names(const Line& line) {
    for (const char candidate : {';', '\t', ','})
      if (line.text.find(candidate) != line.text.npos) {
        separator_ = candidate;
        break;
      }
    const std::vector<PlacedText> names = fields_of(line, separator_, problems_);
    columns_ = names.size();
    for (const ColumnName& wanted : options_.columns) take(line, names, wanted.quantity, wanted.column, true);
    for (const PlacedText& name : names)
      if (meaning_of(name.text)) take(line, names, name.text, name.text, false);
    list_left(names);
    const auto has = [&](double Reading::*place) {
      return std::any_of(taken_.begin(), taken_.end(),
                         [&](const Taken& taken) { return taken.meaning.quantity->place == place; });
    };
    const std::string hint = "columns of the file: " + std::string(trimmed(line.text)).substr(0, 200);
    if (!has(&Reading::q_c))
      problems_.add(line.number, 1, "no column for q_c", "a map entry such as q_c_MPa=NAME", hint);
    if (!has(&Reading::depth) && !has(&Reading::length))
      problems_.add(line.number, 1, "no column for the depth", "a map entry such as depth_m=NAME", hint);
  }

  void take(const Line& line, const std::vector<PlacedText>& names, const std::string& quantity,
            const std::string& column, bool asked) {
    const auto meaning = meaning_of(quantity);
    if (!meaning) return problems_.add(0, 0, "quantity " + in_quotes(quantity), known_quantities);
    const bool taken = std::any_of(taken_.begin(), taken_.end(), [&](const Taken& other) {
      return other.meaning.quantity == meaning->quantity;
    });
    if (taken && !asked) return;  // the map comes before the file's own names
    if (taken)
      return problems_.add(0, 0, in_quotes(std::string(meaning->quantity->name)) + " twice in the column map",
                           "each quantity once");
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i].text == column) at.push_back(i);
    if (at.size() != 1)
      return problems_.add(line.number, at.empty() ? 1 : names[at[1]].column,
                           fmt::format("{} columns named {}", at.size(), in_quotes(column)), "one",
                           "columns of the file: " + std::string(trimmed(line.text)).substr(0, 200));
    taken_.push_back({at.front(), *meaning, quantity});
  }

  void list_left(const std::vector<PlacedText>& names) {
    std::string left;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::none_of(taken_.begin(), taken_.end(), [&](const Taken& taken) { return taken.column == i; }))
        left += (left.empty() ? "" : ", ") + names[i].text;
    if (!left.empty())
      recording_.remarks.push_back({{}, "columns: " + left, "not read", "the column map does not name them"});
  }

  void read_row(const Line& line) {
    ++recording_.rows_read;
    const std::size_t before = problems_.errors().size();
    const std::vector<PlacedText> fields = fields_of(line, separator_, problems_);
    if (problems_.errors().size() > before) return;
    if (fields.size() != columns_)
      return problems_.add(line.number, 1, fmt::format("{} fields", fields.size()),
                           fmt::format("{}, as in the line of names", columns_),
                           "is the line cut off, or do its numbers have decimal commas?");
    Reading reading;
    reading.line = line.number;
    for (const Taken& taken : taken_) {
      const std::string_view text = fields[taken.column].text;
      const std::string lower = lower_case(text);
      if (text.empty() || lower == "nan" || lower == "na") continue;
      const auto value = number(text);
      if (!value) {
        problems_.add(line.number, fields[taken.column].column, in_quotes(text),
                      "a number (" + taken.quantity + ")", number_hint(text));
        continue;
      }
      const bool is_void =
          std::find(options_.voids.begin(), options_.voids.end(), *value) != options_.voids.end();
      if (!is_void) reading.*(taken.meaning.quantity->place) = *value * taken.meaning.scale;
    }
    recording_.readings.push_back(reading);
  }

  const ReadOptions& options_;
  Recording& recording_;
  Problems& problems_;
  std::vector<Taken> taken_;
  std::size_t columns_ = 0;
  char separator_ = ',';
};

}  // namespace

std::string quantity_problem(const std::string& quantity) {
  if (meaning_of(quantity)) return {};
  return fmt::format("{} is no quantity; known are {}", in_quotes(quantity), known_quantities);
}

void read_csv(const std::vector<Line>& lines, const ReadOptions& options, Recording& recording,
              Problems& problems) {
  CsvReader(options, recording, problems).read(lines);
}

}  // namespace cpt::recordings

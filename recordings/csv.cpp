#include "recordings/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "recordings/decimal_mark.hpp"
#include "recordings/delimited.hpp"
#include "recordings/units.hpp"
#include "recordings/unknown_facts.hpp"

namespace cpt::recordings {
namespace {

struct CsvQuantity {
  std::string_view name;
  Dimension dimension;
  double Reading::*place;
};
constexpr std::array csv_quantities = {
    CsvQuantity{"depth", Dimension::length, &Reading::depth},
    CsvQuantity{"length", Dimension::length, &Reading::length},
    CsvQuantity{"q_c", Dimension::pressure, &Reading::q_c},
    CsvQuantity{"f_s", Dimension::pressure, &Reading::f_s},
    CsvQuantity{"u_2", Dimension::pressure, &Reading::u_2},
    CsvQuantity{"inclination", Dimension::angle, &Reading::inclination},
    CsvQuantity{"speed", Dimension::speed, &Reading::speed},
    CsvQuantity{"time", Dimension::time, &Reading::time},
};
constexpr std::array void_words = {"", "nan", "na", "n/a", "#n/a", "<na>", "null", "none"};  // in lower case
constexpr const char* known_quantities =
    "depth_m, length_m, q_c_MPa, f_s_kPa, u_2_kPa, inclination_deg, speed_mm_per_s, time_s";

/// How the user says which column is what.
std::string entry_for(std::string_view quantity) {
  return fmt::format("--column {0}=NAME, or in a request columns = {{ {0} = \"NAME\" }}", quantity);
}

struct Meaning {
  const CsvQuantity* quantity;
  double scale;
};

std::optional<Meaning> meaning_of(std::string_view name) {
  for (const CsvQuantity& quantity : csv_quantities) {
    if (!name.starts_with(quantity.name) || name.size() <= quantity.name.size() + 1 ||
        name[quantity.name.size()] != '_' || name.find_first_of(" ([") != name.npos)
      continue;
    if (const auto scale = scale_of(quantity.dimension, name.substr(quantity.name.size() + 1)))
      return Meaning{&quantity, *scale};
  }
  return std::nullopt;
}

struct CommentEntry {
  const char* name;
  double Recording::*place;
  double scale;
};
constexpr std::array comment_entries = {
    CommentEntry{"x_m", &Recording::x, 1.0},
    CommentEntry{"y_m", &Recording::y, 1.0},
    CommentEntry{"elevation_m", &Recording::elevation, 1.0},
    CommentEntry{"predrilled_m", &Recording::predrilled_depth, 1.0},
    CommentEntry{"cone_area_cm2", &Recording::cone_area, 1e-4},
    CommentEntry{"area_quotient", &Recording::area_quotient, 1.0},
};

struct TakenColumn {
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
      else if (columns_ == 0 && lower_case(text).starts_with("sep=") && text.size() == 5)
        separator_ = text.back();  // how spreadsheets say it
      else if (columns_ == 0)
        read_names(line, lines);
      else if (!problems_.any() || !taken_.empty())
        read_row(line);
    }
    if (columns_ == 0)
      problems_.add(0, 0, "no line of column names", "one before the rows",
                    "lines that start with # do not count");
    mark_.tell(recording_);
    unknown_.tell(recording_);
  }

 private:
  void read_comment(const Line& line, std::string_view comment) {
    const auto equals = comment.find('=');
    if (equals == comment.npos) return;
    const std::string key(trimmed(comment.substr(0, equals)));
    const std::string_view text = trimmed(comment.substr(equals + 1));
    if (key == "id") recording_.id = std::string(text);
    if (key == "date") recording_.date = std::string(text);
    for (const CommentEntry& entry : comment_entries) {
      if (key != entry.name) continue;
      if (const auto value = lone_number(text))
        recording_.*(entry.place) = *value * entry.scale;
      else
        unknown_.add(line.number, key, text);
    }
    recording_.facts.push_back({key, std::string(text), ""});
  }

  void read_names(const Line& line, const std::vector<Line>& lines) {
    names_ = line;
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
                         [&](const TakenColumn& taken) { return taken.meaning.quantity->place == place; });
    };
    const std::string hint = "columns of the file: " + std::string(trimmed(line.text)).substr(0, 200);
    if (!has(&Reading::q_c))
      problems_.add(line.number, 1, "no column for q_c" + strange_unit("q_c_", names), entry_for("q_c_MPa"),
                    hint);
    if (!has(&Reading::depth) && !has(&Reading::length))
      problems_.add(line.number, 1, "no column for the depth" + strange_unit("depth_", names),
                    entry_for("depth_m"), hint);
    if (!problems_.any()) hear_decimal_mark(lines);
  }

  /// Says so where a column is named as a quantity, but with no unit of it.
  static std::string strange_unit(std::string_view quantity, const std::vector<PlacedText>& names) {
    for (const PlacedText& name : names)
      if (name.text.starts_with(quantity)) return ", and no unit of it in " + in_quotes(name.text);
    return {};
  }

  void hear_decimal_mark(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
      const std::string_view text = trimmed(line.text);
      // Fields between commas hold commas only in quotes.
      const bool may_hold = text.find(',') != text.npos && (separator_ != ',' || text.find('"') != text.npos);
      const bool point = text.find('.') != text.npos;
      if (line.number <= names_.number || text.starts_with('#') || !(may_hold || point)) continue;
      Problems told_later("");
      const std::vector<PlacedText> fields = fields_of(line, separator_, told_later);
      for (const TakenColumn& taken : taken_)
        if (taken.column < fields.size()) mark_.hear(trimmed(fields[taken.column].text));
    }
  }

  void take(const Line& line, const std::vector<PlacedText>& names, const std::string& quantity,
            const std::string& column, bool asked) {
    const auto meaning = meaning_of(quantity);
    if (!meaning) return problems_.add(0, 0, "quantity " + in_quotes(quantity), known_quantities);
    const bool taken = std::any_of(taken_.begin(), taken_.end(), [&](const TakenColumn& other) {
      return other.meaning.quantity == meaning->quantity;
    });
    if (taken && !asked) return;  // the map comes before the file's own names
    if (taken)
      return problems_.add(0, 0,
                           in_quotes(std::string(meaning->quantity->name)) +
                               " twice among --column, or in columns of a request",
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
      if (std::none_of(taken_.begin(), taken_.end(),
                       [&](const TakenColumn& taken) { return taken.column == i; }))
        left += (left.empty() ? "" : ", ") + (names[i].text.empty() ? "one without a name" : names[i].text);
    if (!left.empty())
      recording_.remarks.push_back(
          {{}, "columns: " + left, "not read", "neither their names nor --column say what they are"});
  }

  void read_row(const Line& line) {
    if (trimmed(line.text) == trimmed(names_.text))
      return problems_.add(line.number, 1, "the line of names again", "rows",
                           "were files joined? take them apart");
    ++recording_.rows_read;
    const std::size_t before = problems_.errors().size();
    std::vector<PlacedText> fields = fields_of(line, separator_, problems_);
    if (problems_.errors().size() > before) return;
    // Behind a comma nothing may be the rest of a number that the comma has cut.
    while (separator_ != ',' && fields.size() > columns_ && fields.back().text.empty()) fields.pop_back();
    if (fields.size() != columns_)
      return problems_.add(
          line.number, 1, fmt::format("{} fields", fields.size()),
          fmt::format("{}, as in the line of names", columns_),
          fields.size() == columns_ + 1
              ? "do its numbers have decimal commas, or its rows names without a column name?"
              : "is the line cut off, or do its numbers have decimal commas?");
    Reading reading;
    reading.line = line.number;
    for (const TakenColumn& taken : taken_) {
      const PlacedText& field = fields[taken.column];
      const std::string_view text = trimmed(field.text);
      if (is_void(text)) continue;
      const auto value = mark_.number(text);
      if (value)
        reading.*(taken.meaning.quantity->place) = *value * taken.meaning.scale;
      else
        problems_.add(line.number, field.column, in_quotes(text), "a number (" + taken.quantity + ")",
                      number_hint(text));
    }
    recording_.readings.push_back(reading);
  }

  [[nodiscard]] bool is_void(std::string_view text) const {
    if (std::find(void_words.begin(), void_words.end(), lower_case(text)) != void_words.end()) return true;
    const auto value = mark_.number_of_any_size(text);
    return value && std::any_of(options_.voids.begin(), options_.voids.end(),
                                [&](double declared) { return same_void(*value, declared); });
  }

  const ReadOptions& options_;
  Recording& recording_;
  Problems& problems_;
  std::vector<TakenColumn> taken_;
  DecimalMark mark_;
  UnknownFacts unknown_;
  Line names_{0, {}};
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

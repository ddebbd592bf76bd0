#include "recordings/geotech.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "recordings/clock.hpp"
#include "recordings/decimal_mark.hpp"
#include "recordings/units.hpp"
#include "recordings/unknown_facts.hpp"

namespace cpt::recordings {
namespace {

constexpr double mm_per_s = 1.0e-3;  // [m/s]
constexpr double cm2 = 1.0e-4;       // [m2]

struct Key {
  std::string_view name;
  double Reading::*place;
  double scale;
};
constexpr std::array keys = {
    Key{"D", &Reading::length, 1.0},
    Key{"QC", &Reading::q_c, MPa},
    Key{"FS", &Reading::f_s, kPa},
    Key{"U", &Reading::u_2, kPa},
    Key{"TA", &Reading::inclination, degree},
    Key{"B", &Reading::speed, mm_per_s},
};
struct Zero {
  std::string_view name;
  ZeroReading Recording::*place;
  double scale;
};
constexpr std::array zeros = {
    Zero{"NA", &Recording::q_c_zero, MPa},
    Zero{"NB", &Recording::f_s_zero, kPa},
    Zero{"NC", &Recording::u_2_zero, kPa},
};

// "QC=1.25": key and value with their place; "%123" has the key "%".
struct Token {
  std::string_view key;
  Field value;
};

/// Whether a piece without a key goes on with the number before, cut at a comma that is a decimal mark or
/// sets thousands apart: "QC=3,57".
bool goes_on_with(const Token& before, const Field& field) {
  const std::string_view value = before.value.text;
  return before.key != "F" && before.key != "K" && field.text.front() >= '0' && field.text.front() <= '9' &&
         field.text.find('=') == field.text.npos && value.data() + value.size() + 1 == field.text.data() &&
         (before.key == "%" ||
          number_of_any_size(value.substr(std::min(value.find_last_of(',') + 1, value.size()))));
}

std::vector<Token> tokens_of(std::string_view line) {
  std::vector<Token> tokens;
  for (const Field& field : split(line, ',')) {
    if (field.text.empty()) continue;
    if (!tokens.empty() && goes_on_with(tokens.back(), field)) {
      std::string_view& text = tokens.back().value.text;
      text = {text.data(), text.size() + 1 + field.text.size()};
      continue;
    }
    const bool time = field.text.front() == '%';
    const std::size_t end = time ? 1 : std::min(field.text.find('='), field.text.size());
    const std::string_view key = trimmed(field.text.substr(0, end));
    const std::size_t begin = time ? 1 : std::min(end + 1, field.text.size());
    std::string_view value = trimmed(field.text.substr(begin));
    if (key == "T") value = trimmed(line.substr(static_cast<std::size_t>(value.data() - line.data())));
    tokens.push_back({key, {value, column_of(line, value)}});
    if (key == "T") break;  // free text to the end of the line, commas and all
  }
  return tokens;
}

class GeotechReader {
 public:
  GeotechReader(Recording& recording, Problems& problems) : recording_(recording), problems_(problems) {}

  void read(const std::vector<Line>& lines) {
    Where where = Where::start;
    for (const Line& line : lines) {
      const std::string_view text = trimmed(line.text);
      if (text.empty()) continue;
      if (where == Where::start && text != "$")
        return problems_.add(line.number, 1, in_quotes(text), "'$' on a line of its own",
                             "is this a Geotech file?");
      if (where == Where::header && text.starts_with("#$")) return no_rows(line.number, in_quotes(text));
      if (const auto next = next_part(where, text))
        where = *next;
      else
        take(line, text, where);
    }
    if (where == Where::start || where == Where::header)
      return no_rows(std::max(1, static_cast<int>(lines.size())), "the end of the file");
    for (const Row& row : rows_)
      for (const Token& token : row.tokens)
        if (key_of(token) != keys.end()) mark_.hear(token.value.text);
    for (const Row& row : rows_)
      if (!problems_.full()) read_row(row);
    finish();
  }

 private:
  enum class Where { start, header, data, legend, further_header, further_data, further_legend };
  struct Row {
    Line line;
    std::vector<Token> tokens;
  };

  /// The part of the file that a line begins, if it begins one.
  static std::optional<Where> next_part(Where where, std::string_view text) {
    if (text == "$") return where == Where::start ? Where::header : Where::further_header;
    if (text.starts_with("#$"))
      return where == Where::data || where == Where::legend ? Where::legend : Where::further_legend;
    if (text == "#")
      return where == Where::header || where == Where::data ? Where::data : Where::further_data;
    return std::nullopt;
  }

  void take(const Line& line, std::string_view text, Where where) {
    const bool is_row = text.starts_with("D=");
    if (where == Where::header) {
      read_header(line);
    } else if (where == Where::data) {
      rows_.push_back({line, tokens_of(line.text)});
    } else if (where == Where::further_data || is_row) {
      ++recording_.rows_read;
      further_.lines.add(line.number);
    } else if (where == Where::legend) {
      if (const auto colon = text.find(':'); colon != text.npos)
        legend_[std::string(text.substr(0, colon))] = std::string(text.substr(colon + 1));
    }
  }

  static const Key* key_of(const Token& token) {
    return std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == token.key; });
  }

  void no_rows(int line, std::string found) {
    problems_.add(line, 1, std::move(found), "'#' on a line of its own, then rows D=...,QC=...",
                  "the file seems to be cut off");
  }

  void read_header(const Line& line) {
    for (const Token& token : tokens_of(line.text)) {
      if (token.value.text.empty()) continue;
      const auto set = [&](double& place, double scale) {
        if (const auto value = lone_number(token.value.text))
          place = *value * scale;
        else
          unknown_.add(line.number, token.key, token.value.text);
      };
      if (token.key == "HD") recording_.date = std::string(token.value.text);
      if (token.key == "HK") recording_.id = std::string(token.value.text);
      if (token.key == "HO") set(recording_.predrilled_depth, 1.0);
      if (token.key == "HX") set(recording_.x, 1.0);
      if (token.key == "HY") set(recording_.y, 1.0);
      if (token.key == "HZ") set(recording_.elevation, 1.0);
      if (token.key == "MA") set(recording_.area_quotient, 1.0);
      if (token.key == "MC") set(recording_.cone_area, cm2);
      recording_.facts.push_back({std::string(token.key), std::string(token.value.text), ""});
    }
  }

  void not_a_number(const Line& line, const Token& token) {
    problems_.add(line.number, token.value.column, in_quotes(token.value.text),
                  fmt::format("a number ({})", token.key), number_hint(token.value.text));
  }

  void read_row(const Row& row) {
    const Line& line = row.line;
    ++recording_.rows_read;
    Reading reading;
    reading.line = line.number;
    reading.after_stop = stop_ahead_;
    stop_ahead_ = false;
    for (auto token = row.tokens.begin(); token != row.tokens.end(); ++token) {
      const auto* key = key_of(*token);
      const auto* zero =
          std::find_if(zeros.begin(), zeros.end(), [&](const Zero& z) { return z.name == token->key; });
      if (token->key == "%") {
        if (const auto time = seconds_of(token->value.text))
          reading.time = *time;
        else
          unreadable_times_.add(line.number);
      } else if (token->key == "F") {
        ++flags_[std::string(token->value.text)];
        stop_ahead_ = stop_ahead_ || token->value.text == "13";
      } else if (key == keys.end() && zero == zeros.end()) {
        take_other(line, *token);
      } else if (std::any_of(row.tokens.begin(), token,
                             [&](const Token& t) { return t.key == token->key; })) {
        problems_.add(line.number, column_of(line.text, token->key), "a second " + in_quotes(token->key),
                      "each key once in a row", "were two rows joined?");
      } else if (!token->value.text.empty()) {
        read_value(line, *token, key, zero, reading);
      }
    }
    recording_.readings.push_back(reading);
  }

  void read_value(const Line& line, const Token& token, const Key* key, const Zero* zero, Reading& reading) {
    if (key != keys.end()) {
      if (const auto value = mark_.number(token.value.text))
        reading.*(key->place) = *value * key->scale;
      else
        not_a_number(line, token);
    } else if (const auto value = lone_number(token.value.text)) {
      set_zero(recording_.*(zero->place), *value * zero->scale);
    } else {
      unknown_.add(line.number, token.key, token.value.text);
    }
  }

  void take_other(const Line& line, const Token& token) {
    if (number_of_any_size(token.key))
      problems_.add(line.number, column_of(line.text, token.key), in_quotes(token.key), "KEY=number",
                    "was it cut off at a comma? decimals follow a point");
    else if (token.key != "K" && token.key != "T")
      others_.insert(std::string(token.key.substr(0, 8)));
  }

  static void set_zero(ZeroReading& zero, double value) {
    if (std::isnan(zero.before))
      zero.before = value;
    else
      zero.drift = value;
  }

  void finish() {
    for (const Zero& zero : zeros) {
      ZeroReading& reading = recording_.*(zero.place);
      if (std::isnan(reading.drift)) continue;
      // Some programs write the value itself: as a change it would be as large as the zero.
      const bool value_itself = std::abs(reading.drift - reading.before) < std::abs(reading.drift);
      if (value_itself) reading.drift -= reading.before;
      reading.after = reading.before + reading.drift;
    }
    if (recording_.x == 0.0 && recording_.y == 0.0) recording_.x = recording_.y = not_given;
    if (recording_.elevation == 0.0 && std::isnan(recording_.x)) recording_.elevation = not_given;
    for (const auto& [code, rows] : flags_) {
      const auto meaning = legend_.find(code);
      recording_.facts.push_back({"flag F=" + code + (meaning == legend_.end() ? "" : ": " + meaning->second),
                                  fmt::format("{}", rows), "rows"});
    }
    if (unreadable_times_.rows > 0)
      recording_.remarks.push_back({unreadable_times_, "times that are neither milliseconds nor a date",
                                    "kept without a time", "stops cannot be seen there"});
    if (!others_.empty()) {
      std::string list;
      for (const std::string& key : others_)
        if (list.size() < 100) list += (list.empty() ? "" : ", ") + key;
      recording_.remarks.push_back(
          {{}, "keys of the rows: " + list, "not read", "a recording has no place for these quantities"});
    }
    if (further_.lines.rows > 0) recording_.set_aside.push_back(further_);
    mark_.tell(recording_);
    unknown_.tell(recording_);
  }

  Recording& recording_;
  Problems& problems_;
  std::map<std::string, std::string> legend_;
  std::map<std::string, int> flags_;
  std::set<std::string> others_;
  std::vector<Row> rows_;
  DecimalMark mark_;
  UnknownFacts unknown_;
  SetAside further_{{}, "belongs to a further sounding in the file"};
  Lines unreadable_times_;
  bool stop_ahead_ = false;
};

}  // namespace

bool is_geotech(std::string_view first_line) { return first_line == "$"; }

void read_geotech(const std::vector<Line>& lines, const ReadOptions&, Recording& recording,
                  Problems& problems) {
  GeotechReader(recording, problems).read(lines);
}

}  // namespace cpt::recordings

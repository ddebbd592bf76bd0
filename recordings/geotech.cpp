#include "recordings/geotech.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "recordings/clock.hpp"

namespace cpt::recordings {
namespace {

constexpr double kPa = 1.0e3, MPa = 1.0e6;           // [Pa]
constexpr double mm_per_s = 1.0e-3;                  // [m/s]
constexpr double degree = std::numbers::pi / 180.0;  // [rad]
constexpr double cm2 = 1.0e-4;                       // [m2]

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

std::vector<Token> tokens_of(std::string_view line) {
  std::vector<Token> tokens;
  for (const Field& field : split(line, ',')) {
    if (field.text.empty()) continue;
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
    enum class Where { start, header, data, legend, further } where = Where::start;
    for (const Line& line : lines) {
      if (problems_.full()) return;
      const std::string_view text = trimmed(line.text);
      if (text.empty()) continue;
      if (text == "$") {
        where = where == Where::start ? Where::header : Where::further;
      } else if (text.starts_with("#$")) {
        if (where == Where::header) return no_rows(line.number, in_quotes(text));
        if (where != Where::further) where = Where::legend;
      } else if (text == "#") {
        if (where == Where::header) where = Where::data;
      } else if (where == Where::start) {
        return problems_.add(line.number, 1, in_quotes(text), "'$' on a line of its own",
                             "is this a Geotech file?");
      } else if (where == Where::header) {
        read_header(line);
      } else if (where == Where::data) {
        read_row(line);
      } else if (where == Where::legend) {
        if (const auto colon = text.find(':'); colon != text.npos)
          legend_[std::string(text.substr(0, colon))] = std::string(text.substr(colon + 1));
      } else if (text.starts_with("D=")) {
        ++recording_.rows_read;
        further_.lines.add(line.number);
      }
    }
    if (where == Where::start || where == Where::header)
      no_rows(std::max(1, static_cast<int>(lines.size())), "the end of the file");
    finish();
  }

 private:
  void no_rows(int line, std::string found) {
    problems_.add(line, 1, std::move(found), "'#' on a line of its own, then rows D=...,QC=...",
                  "the file seems to be cut off");
  }

  void read_header(const Line& line) {
    for (const Token& token : tokens_of(line.text)) {
      if (token.value.text.empty()) continue;
      const auto set = [&](double& place, double scale) {
        if (const auto value = number(token.value.text))
          place = *value * scale;
        else
          not_a_number(line, token);
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

  void read_row(const Line& line) {
    ++recording_.rows_read;
    Reading reading;
    reading.line = line.number;
    reading.after_stop = stop_ahead_;
    stop_ahead_ = false;
    for (const Token& token : tokens_of(line.text)) {
      const auto* key =
          std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == token.key; });
      const auto* zero =
          std::find_if(zeros.begin(), zeros.end(), [&](const Zero& z) { return z.name == token.key; });
      if (token.key == "%") {
        if (const auto time = seconds_of(token.value.text))
          reading.time = *time;
        else
          unreadable_times_.add(line.number);
      } else if (token.key == "F") {
        ++flags_[std::string(token.value.text)];
        stop_ahead_ = stop_ahead_ || token.value.text == "13";
      } else if (key == keys.end() && zero == zeros.end()) {
        if (token.key != "K" && token.key != "T") others_.insert(std::string(token.key.substr(0, 8)));
      } else if (!token.value.text.empty()) {
        const auto value = number(token.value.text);
        if (!value)
          not_a_number(line, token);
        else if (key != keys.end())
          reading.*(key->place) = *value * key->scale;
        else
          set_zero(recording_.*(zero->place), *value * zero->scale);
      }
    }
    recording_.readings.push_back(reading);
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
  }

  Recording& recording_;
  Problems& problems_;
  std::map<std::string, std::string> legend_;
  std::map<std::string, int> flags_;
  std::set<std::string> others_;
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

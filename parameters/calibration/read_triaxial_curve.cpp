#include "parameters/calibration/read_triaxial_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "parameters/nearest_name.hpp"
#include "parameters/written_number.hpp"
#include "solver/quantities.hpp"

namespace cpt::calibration {
namespace {

constexpr double kPa = 1.0e3;               // [Pa]
constexpr double percent = 0.01;            // [-]
constexpr std::size_t fewest_readings = 3;  // readings that make a curve
constexpr std::size_t at_most = 20;         // problems told at once

struct Field {
  std::string_view text;  // without blanks around it
  int column;             // of its first character, from 1
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<Field> split(std::string_view line, char separator) {
  std::vector<Field> fields;
  for (std::size_t from = 0;;) {
    const std::size_t to = std::min(line.find(separator, from), line.size());
    const std::string_view whole = line.substr(from, to - from);
    const auto blanks = std::min(whole.find_first_not_of(" \t"), whole.size());
    fields.push_back({trimmed(whole), static_cast<int>(from + blanks) + 1});
    if (to == line.size()) return fields;
    from = to + 1;
  }
}

std::optional<double> number(std::string_view text) {
  const std::optional<double> value = parameters::written_number(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

// "; decimals follow a point, not a comma: 3.5"
std::string hinted(std::string_view text) {
  const std::string hint = parameters::number_hint(text);
  return hint.empty() ? "" : "; " + hint;
}

class CurveReader {
 public:
  explicit CurveReader(const std::filesystem::path& file) : file_(file.string()) {
    curve_.name = file.stem().string();
  }

  CurveOrProblems read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a mark that some programs put first
    text = parameters::without_padding(text);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
      problem(0, "is UTF-16: save it as UTF-8");
      return problems_;
    }
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      read_line(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      if (problems_.size() >= at_most) break;
    }
    finish();
    if (!problems_.empty()) return problems_;
    return curve_;
  }

 private:
  void problem(int column, std::string message) {
    problems_.push_back({file_, line_, column, std::move(message)});
  }

  void read_line(std::string_view line) {
    const std::string_view content = trimmed(line);
    if (content.empty()) return;
    if (content.front() == '#')
      read_comment(line, content.substr(1));
    else if (!named_)
      read_names(line);
    else
      read_reading(line);
  }

  void read_comment(std::string_view line, std::string_view comment) {
    const auto equals = comment.find('=');
    if (equals == std::string_view::npos) return;
    const std::string_view key = trimmed(comment.substr(0, equals));
    const std::string_view text = trimmed(comment.substr(equals + 1));
    if (key == "test") curve_.name = std::string(text);
    const int column = static_cast<int>(line.find('=')) + 2;
    // A fact under a name that is nearly one of these would be lost; others are remarks of their own.
    if (std::ranges::find(facts, key) == facts.end() && number(text.substr(0, text.find(' '))))
      if (const std::string_view near = parameters::nearest_name(key, facts); !near.empty())
        problem(
            static_cast<int>(line.find(key)) + 1,
            fmt::format("{} = {} is not read; did you mean {}? Without = it is a remark", key, text, near));
    if (key == "p0_kPa") set(curve_.p_0, text, column, key, 0.01, 1.0e5, kPa);
    if (key == "e0") set(curve_.e_0, text, column, key, 0.1, 3.0, 1.0);
    if (key == "D_r_percent") set(curve_.D_r, text, column, key, 0.0, 120.0, percent);
  }

  void set(double& target, std::string_view text, int column, std::string_view key, double min, double max,
           double scale) {
    const auto value = number(text);
    if (!value || *value < min || *value > max)
      return problem(column, fmt::format("{} = {}: must be a number from {} to {}{}", key, text, min, max,
                                         value ? "" : hinted(text)));
    if (!std::isnan(target)) return problem(column, fmt::format("{} is there twice", key));
    target = *value * scale;
  }

  void read_names(std::string_view line) {
    named_ = true;
    for (const char candidate : {',', ';', '\t'})
      if (line.find(candidate) != std::string_view::npos) {
        separator_ = candidate;
        break;
      }
    const std::vector<Field> names = split(line, separator_);
    for (std::size_t k = 0; k < known.size(); ++k) {
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].text != known[k]) continue;
        if (place_[k]) problem(names[i].column, fmt::format("column {} is there twice", known[k]));
        place_[k] = i;
      }
      if (!place_[k] && k != eps_v)
        problem(1,
                fmt::format("there is no column {} but {}; the first line that is no comment must name the "
                            "columns eps_a_percent, q_kPa and, if measured, eps_v_percent",
                            known[k], line.substr(0, 100)));
    }
    columns_ = names.size();
  }

  void read_reading(std::string_view line) {
    if (!place_[eps_a] || !place_[q]) return;  // told already
    const std::vector<Field> fields = split(line, separator_);
    if (fields.size() != columns_)
      return problem(1, fmt::format("has {} fields where the line of names has {}", fields.size(), columns_));
    const auto value = [&](std::size_t k) -> std::optional<double> {
      const Field& field = fields[*place_[k]];
      const auto found = number(field.text);
      if (!found)
        problem(field.column, fmt::format("{}: '{}' is not a number{}", known[k], field.text,
                                          field.text == known[k]
                                              ? "; the line of names stands here again: are two tests joined?"
                                              : hinted(field.text)));
      return found;
    };
    const auto strain = value(eps_a), stress = value(q);
    const auto volume = place_[eps_v] ? value(eps_v) : std::optional(not_given);
    if (!strain || !stress || !volume) return;
    if (place_[eps_v] && std::abs(*volume) >= 100.0)
      return problem(fields[*place_[eps_v]].column,
                     fmt::format("eps_v_percent = {}: must be -100 to 100", *volume));
    const int column = fields[*place_[eps_a]].column;
    if (*strain < 0.0 || *strain >= 100.0)
      return problem(column, fmt::format("eps_a_percent = {}: must be 0 to 100", *strain));
    if (!curve_.readings.empty() && *strain * percent < curve_.readings.back().eps_a)
      return problem(column, fmt::format("eps_a_percent = {} falls: leave out unloading", *strain));
    curve_.readings.push_back({*strain * percent, *stress * kPa, *volume * percent});
  }

  void finish() {
    if (!problems_.empty()) return;
    line_ = 0;
    if (!named_) return problem(0, "has no line of column names");
    if (curve_.readings.size() < fewest_readings)
      problem(0, fmt::format("has {} readings; a curve needs {}", curve_.readings.size(), fewest_readings));
    if (!std::isnan(curve_.e_0) && !std::isnan(curve_.D_r)) problem(0, "gives both e0 and D_r_percent");
  }

  static constexpr std::array<std::string_view, 3> known = {"eps_a_percent", "q_kPa", "eps_v_percent"};
  static constexpr std::size_t eps_a = 0, q = 1, eps_v = 2;
  static constexpr std::array<std::string_view, 4> facts = {"test", "p0_kPa", "e0", "D_r_percent"};

  std::string file_;
  TriaxialCurve curve_;
  std::vector<CurveProblem> problems_;
  std::array<std::optional<std::size_t>, 3> place_;
  std::size_t columns_ = 0;
  char separator_ = ',';
  bool named_ = false;
  int line_ = 0;
};

}  // namespace

std::string format(const std::vector<CurveProblem>& problems) {
  std::string text;
  for (const CurveProblem& p : problems) {
    if (!text.empty()) text += '\n';
    text += p.line == 0 ? fmt::format("{}: {}", p.file, p.message)
                        : fmt::format("{}:{}:{}: {}", p.file, p.line, p.column, p.message);
  }
  return text;
}

CurveOrProblems parse_triaxial_curve(std::string_view text, const std::filesystem::path& file) {
  return CurveReader(file).read(text);
}

}  // namespace cpt::calibration

#include "parameters/calibration/laboratory_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "parameters/nearest_name.hpp"
#include "parameters/written_number.hpp"

namespace cpt::calibration {
namespace {

constexpr std::size_t at_most = 20;  // problems told at once

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

LaboratoryFile::LaboratoryFile(const std::filesystem::path& file, std::string& name, std::vector<Fact> facts,
                               std::vector<Column> columns, std::string_view columns_in_words)
    : file_(file.string()),
      name_(name),
      facts_(std::move(facts)),
      keys_{"test"},
      columns_(std::move(columns)),
      in_words_(columns_in_words),
      place_(columns_.size()) {
  name_ = file.stem().string();
  for (const Fact& fact : facts_) keys_.push_back(fact.key);
}

void LaboratoryFile::read(std::string_view text, const std::function<void(std::span<const Entry>)>& take) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a mark that some programs put first
  text = parameters::without_padding(text);
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return problem(0, "is UTF-16: save it as UTF-8");
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    ++line_;
    read_line(text.substr(0, end), take);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (problems_.size() >= at_most) break;
  }
  line_ = 0;
  if (!named_ && problems_.empty()) problem(0, "has no line of column names");
}

void LaboratoryFile::problem(int column, std::string message) {
  problems_.push_back({file_, line_, column, std::move(message)});
}

void LaboratoryFile::read_line(std::string_view line,
                               const std::function<void(std::span<const Entry>)>& take) {
  const std::string_view content = trimmed(line);
  if (content.empty()) return;
  if (content.front() == '#')
    read_comment(line, content.substr(1));
  else if (!named_)
    read_names(line);
  else
    read_reading(line, take);
}

void LaboratoryFile::read_comment(std::string_view line, std::string_view comment) {
  const auto equals = comment.find('=');
  if (equals == std::string_view::npos) return;
  const std::string_view key = trimmed(comment.substr(0, equals));
  const std::string_view text = trimmed(comment.substr(equals + 1));
  if (key == "test") name_ = std::string(text);
  const int column = static_cast<int>(line.find('=')) + 2;
  // A fact under a name that is nearly one of these would be lost; others are remarks of their own.
  if (std::ranges::find(keys_, key) == keys_.end() && number(text.substr(0, text.find(' '))))
    if (const std::string_view near = parameters::nearest_name(key, keys_); !near.empty())
      problem(static_cast<int>(line.find(key)) + 1,
              fmt::format("{} = {} is not read; did you mean {}? Without = it is a remark", key, text, near));
  for (const Fact& fact : facts_)
    if (key == fact.key) set(fact, text, column);
}

void LaboratoryFile::set(const Fact& fact, std::string_view text, int column) {
  const auto value = number(text);
  if (!value || *value < fact.min || *value > fact.max)
    return problem(column, fmt::format("{} = {}: must be a number from {} to {}{}", fact.key, text, fact.min,
                                       fact.max, value ? "" : hinted(text)));
  if (!std::isnan(*fact.target)) return problem(column, fmt::format("{} is there twice", fact.key));
  *fact.target = *value * fact.scale;
}

void LaboratoryFile::read_names(std::string_view line) {
  named_ = true;
  for (const char candidate : {',', ';', '\t'})
    if (line.find(candidate) != std::string_view::npos) {
      separator_ = candidate;
      break;
    }
  const std::vector<Field> names = split(line, separator_);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].text != columns_[k].name) continue;
      if (place_[k]) problem(names[i].column, fmt::format("column {} is there twice", columns_[k].name));
      place_[k] = i;
    }
    if (!place_[k] && columns_[k].required)
      problem(1, fmt::format("there is no column {} but {}; the first line that is no comment must name the "
                             "columns {}",
                             columns_[k].name, line.substr(0, 100), in_words_));
  }
  fields_ = names.size();
}

void LaboratoryFile::read_reading(std::string_view line,
                                  const std::function<void(std::span<const Entry>)>& take) {
  for (std::size_t k = 0; k < columns_.size(); ++k)
    if (columns_[k].required && !place_[k]) return;  // told already
  const std::vector<Field> fields = split(line, separator_);
  if (fields.size() != fields_)
    return problem(1, fmt::format("has {} fields where the line of names has {}", fields.size(), fields_));
  std::vector<Entry> entries;
  bool sound = true;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    Entry& entry = entries.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0);
    if (!place_[k]) continue;
    const Field& field = fields[*place_[k]];
    entry.column = field.column;
    if (const auto found = number(field.text)) {
      entry.value = *found;
      continue;
    }
    sound = false;
    problem(field.column, fmt::format("{}: '{}' is not a number{}", columns_[k].name, field.text,
                                      field.text == columns_[k].name
                                          ? "; the line of names stands here again: are two tests joined?"
                                          : hinted(field.text)));
  }
  if (sound) take(entries);
}

}  // namespace cpt::calibration

#include "campaign/external/program_results.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "campaign/last_words.hpp"

namespace cpt::campaign {
namespace {

constexpr std::size_t most_numbers = 2'000'000;  // of all outputs together
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Columns = std::map<std::string, std::vector<double>, std::less<>>;

// JSON has no word for these; some programs write them all the same.
bool says_not_finite(std::string_view text) {
  for (const std::string_view word : {"NaN", "nan", "Infinity", "inf"})
    if (text.find(word) != std::string_view::npos) return true;
  return false;
}

double number_of(const nlohmann::json& value, const std::string& name) {
  if (value.is_null()) return nan;
  if (!value.is_number())
    throw BadResults(fmt::format("{} holds {} where a number is expected", name, value.type_name()));
  return value.get<double>();
}

Columns from_json(std::string_view text, std::span<const solver::ProgramOutput> declared) {
  nlohmann::json object;
  try {
    object = nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& problem) {
    if (says_not_finite(text)) throw BadResults("its results hold NaN or an infinite number", true);
    throw BadResults(fmt::format("its results are no JSON: {}", last_line(problem.what())));
  }
  Columns columns;
  const auto take = [&](const std::string& name) {
    const auto member = object.find(name);
    if (member == object.end() || columns.contains(name)) return;
    std::vector<double>& values = columns[name];
    if (!member->is_array()) return values.push_back(number_of(*member, name));
    for (const nlohmann::json& item : *member) values.push_back(number_of(item, name));
  };
  for (const solver::ProgramOutput& output : declared) {
    take(output.name);
    if (output.is_curve()) take(output.over);
    if (const auto found = object.find(output.name);
        found != object.end() && found->is_array() != output.is_curve())
      throw BadResults(fmt::format(
          "{} is {}", output.name,
          output.is_curve() ? "one number, and declared as a curve" : "an array, and declared as a scalar"));
  }
  return columns;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    cells.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  return cells;
}

Columns from_csv(std::string_view text) {
  Columns columns;
  std::vector<std::vector<double>*> by_place;
  std::size_t line_number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = end + 1;
    ++line_number;
    if (trimmed(line).empty()) continue;
    const std::vector<std::string_view> cells = cells_of(line);
    if (by_place.empty()) {
      for (const std::string_view name : cells) by_place.push_back(&columns[std::string(name)]);
      continue;
    }
    for (std::size_t k = 0; k < cells.size() && k < by_place.size(); ++k) {
      if (cells[k].empty()) continue;
      double value = nan;
      const auto [stop, problem] = std::from_chars(cells[k].data(), cells[k].data() + cells[k].size(), value);
      if (problem != std::errc{} || stop != cells[k].data() + cells[k].size())
        throw BadResults(fmt::format("its results are no CSV: \"{}\" in line {} is no number",
                                     last_line(cells[k].substr(0, 40)), line_number));
      by_place[k]->push_back(value);
    }
  }
  return columns;
}

const std::vector<double>& column(const Columns& columns, const std::string& name) {
  const auto found = columns.find(name);
  if (found == columns.end() || found->second.empty())
    throw BadResults(fmt::format("its results have no {}", name));
  for (const double value : found->second)
    if (!std::isfinite(value)) throw BadResults(fmt::format("{} is not finite", name), true);
  return found->second;
}

}  // namespace

std::vector<solver::ProgramResult> read_results(std::string_view text,
                                                std::span<const solver::ProgramOutput> declared) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) throw BadResults("it wrote no results");
  const Columns columns = text[first] == '{' ? from_json(text, declared) : from_csv(text);
  std::vector<solver::ProgramResult> results;
  std::size_t numbers = 0;
  for (const solver::ProgramOutput& output : declared) {
    const std::vector<double>& values = column(columns, output.name);
    if (!output.is_curve()) {
      results.push_back({output.name, {}, {values.front()}});
      continue;
    }
    const std::vector<double>& over = column(columns, output.over);
    if (over.size() != values.size())
      throw BadResults(fmt::format("{} has {} numbers and its abscissa {} has {}", output.name, values.size(),
                                   output.over, over.size()));
    for (std::size_t k = 1; k < over.size(); ++k)
      if (!(over[k] > over[k - 1]))
        throw BadResults(
            fmt::format("{} does not rise: {} stands behind {}", output.over, over[k], over[k - 1]));
    if ((numbers += 2 * over.size()) > most_numbers)
      throw BadResults(fmt::format("its results have more than {} numbers", most_numbers));
    results.push_back({output.name, over, values});
  }
  return results;
}

}  // namespace cpt::campaign

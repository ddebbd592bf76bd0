#include "results/tables/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "parameters/response_names.hpp"

namespace cpt::results {
namespace {

/// What varies: the study's parameters in its order, then what its points change.
std::vector<std::string> varied_of(const Snapshot& s) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const ParameterRow& parameter : s.parameters) add(parameter.name);
  for (const InputRow& input : s.inputs) {
    if (input.realization != s.inputs.front().realization) break;  // the same of all
    add(input.quantity);
  }
  return names;
}

Cell cell_of(const std::string& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty()) return std::monostate{};
  if (error == std::errc{} && end == text.data() + text.size()) return number;
  return text;
}

constexpr std::array averages = {&WindowMeanRow::q_c_mean_kPa, &WindowMeanRow::q_c_min_kPa,
                                 &WindowMeanRow::q_c_max_kPa};

/// Of the first or of all of them.
std::vector<std::string> columns_of(const WindowRow& window) {
  const auto names = parameters::response_names(window.name, !window.output.empty());
  return {names.begin(), window.is_scalar() ? names.begin() + 1 : names.end()};
}

std::string name_of(const RealizationRow& run) {
  if (run.side == "point" || run.side == "repeat") return run.parameter;
  return run.parameter.empty() ? run.side : run.parameter + " " + run.side;
}

/// Text that Dakota reads as one word.
std::string word_of(const Cell& cell) {
  if (const auto* value = std::get_if<double>(&cell)) return fmt::format("{}", *value);
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *whole);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return "NaN";
}

}  // namespace

Table samples_table(const Snapshot& s) {
  Table table{{"realization", "name", "status", "reason"}, {}};
  const std::vector<std::string> inputs = varied_of(s);
  table.columns.insert(table.columns.end(), inputs.begin(), inputs.end());
  for (const WindowRow& window : s.windows)
    for (const std::string& name : columns_of(window)) table.columns.push_back(name);
  std::map<std::pair<int, std::string>, const WindowMeanRow*> means;
  for (const WindowMeanRow& mean : s.window_means) means[{mean.realization, mean.window}] = &mean;

  std::map<std::pair<int, std::string>, const InputRow*> input_of;
  for (const InputRow& input : s.inputs) input_of[{input.realization, input.quantity}] = &input;
  for (const RealizationRow& run : s.realizations) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.reserve(table.columns.size());
    row.emplace_back(std::int64_t{run.id});
    for (const std::string& text : {name_of(run), run.status, run.reason}) row.emplace_back(text);
    for (const std::string& input : inputs) {
      const auto found = input_of.find({run.id, input});
      row.push_back(found == input_of.end() ? Cell() : cell_of(found->second->value_text));
    }
    for (const WindowRow& window : s.windows) {
      const auto found = means.find({run.id, window.name});
      for (std::size_t k = 0; k < columns_of(window).size(); ++k)
        row.push_back(found == means.end() ? Cell(std::monostate{})
                                           : number_cell(found->second->*averages[k]));
    }
  }
  return table;
}

std::string dakota_table(const Snapshot& s) {
  const Table samples = samples_table(s);
  constexpr std::size_t id = 0, first_input = 4;
  std::size_t column = first_input + varied_of(s).size();
  std::vector<std::size_t> taken;  // columns of the samples: the inputs, and of each window the mean
  for (std::size_t i = first_input; i < column; ++i) taken.push_back(i);
  for (const WindowRow& window : s.windows) {
    taken.push_back(column);
    column += columns_of(window).size();
  }

  std::vector<std::vector<std::string>> lines = {{"%eval_id", "interface"}};
  for (const std::size_t i : taken) lines.front().push_back(samples.columns[i]);
  for (std::size_t k = 0; k < samples.rows.size(); ++k) {
    if (!s.realizations[k].ended()) continue;
    std::vector<std::string>& line = lines.emplace_back();
    line = {word_of(samples.rows[k][id]), "NO_ID"};
    for (const std::size_t i : taken) line.push_back(word_of(samples.rows[k][i]));
  }
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  std::string text;
  for (const auto& line : lines) {
    text += fmt::format("{:<{}}", line[0], widths[0]);
    for (std::size_t i = 1; i < line.size(); ++i) text += fmt::format(" {:>{}}", line[i], widths[i]);
    text += '\n';
  }
  return text;
}

}  // namespace cpt::results

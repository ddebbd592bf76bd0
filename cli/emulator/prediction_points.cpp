#include "cli/emulator/prediction_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <variant>

#include "cli/common/study_argument.hpp"
#include "cli/exchange/read_table.hpp"
#include "parameters/nearest_name.hpp"
#include "parameters/study_error.hpp"
#include "parameters/written_number.hpp"

namespace cpt::cli {
namespace {

using Eigen::Index;

constexpr std::size_t most_errors = 20;

// A value, or what is wrong with the text.
std::variant<double, std::string> value_in(const results::EmulatorInput& input, std::string_view text) {
  if (!input.choices.empty()) {
    const auto found = std::ranges::find(input.choices, text);
    if (found == input.choices.end()) return fmt::format("must be {}", input.range());
    return found == input.choices.begin() ? input.lower : input.upper;
  }
  const std::optional<double> number = parameters::written_number(text);
  if (!number) {
    const std::string hint = parameters::number_hint(text);
    return fmt::format("is not a number{}", hint.empty() ? "" : "; " + hint);
  }
  if (const std::string why = out_of_range(input, *number); !why.empty())
    return why + ", as the emulator knows no runs beyond";
  return *number;
}

std::string known_inputs(const results::Emulator& emulator, std::string_view name) {
  std::vector<std::string_view> names;
  for (const results::EmulatorInput& input : emulator.inputs) names.push_back(input.name);
  const std::string_view near = parameters::nearest_name(name, names);
  return near.empty() ? fmt::format("its inputs are {}", fmt::join(names, ", "))
                      : fmt::format("did you mean {}?", near);
}

Index index_of(const results::Emulator& emulator, const results::EmulatorInput& input) {
  return static_cast<Index>(&input - emulator.inputs.data());
}

Eigen::RowVectorXd with_settings(const results::Emulator& emulator,
                                 const std::vector<std::string>& settings) {
  Eigen::RowVectorXd values(static_cast<Index>(emulator.inputs.size()));
  for (const results::EmulatorInput& input : emulator.inputs)
    values(index_of(emulator, input)) = input.baseline;
  for (const std::string& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos) throw BadInput(fmt::format("--set {}: must be NAME=VALUE", setting));
    const std::string name = setting.substr(0, equals), text = setting.substr(equals + 1);
    const results::EmulatorInput* input = emulator.input(name);
    if (input == nullptr)
      throw BadInput(fmt::format("--set {}: {} is no input of the emulator; {}", setting, name,
                                 known_inputs(emulator, name)));
    const auto value = value_in(*input, text);
    if (const auto* why = std::get_if<std::string>(&value))
      throw BadInput(fmt::format("--set {}: {}", setting, *why));
    values(index_of(emulator, *input)) = std::get<double>(value);
  }
  return values;
}

}  // namespace

PredictionPoints point_of(const results::Emulator& emulator, const std::vector<std::string>& settings) {
  return {{settings.empty() ? "baseline" : "point"}, with_settings(emulator, settings)};
}

PredictionPoints points_of(const results::Emulator& emulator, const std::vector<std::string>& settings,
                           const std::filesystem::path& file) {
  const Eigen::RowVectorXd usual = with_settings(emulator, settings);
  const parameters::FieldTable table = read_table(file).table;
  std::vector<parameters::StudyError> errors;
  const auto add = [&](const parameters::Field& field, const std::string& key, std::string message,
                       std::string hint = "") {
    errors.push_back(
        {table.file, field.place.line, field.place.column, key, std::move(message), std::move(hint)});
  };
  std::vector<const results::EmulatorInput*> columns;
  for (const parameters::Field& name : table.names) {
    columns.push_back(emulator.input(name.text));
    if (columns.back() == nullptr && name.text != "name")
      add(name, name.text, "is no input of the emulator", known_inputs(emulator, name.text));
  }
  PredictionPoints points;
  points.values = usual.replicate(static_cast<Index>(table.rows.size()), 1);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    points.names.push_back(fmt::format("row {}", i + 1));
    for (std::size_t c = 0; c < columns.size() && errors.size() < most_errors; ++c) {
      const parameters::Field& field = table.rows[i][c];
      if (columns[c] == nullptr) {
        if (!field.text.empty()) points.names.back() = field.text;
        continue;
      }
      const auto value = value_in(*columns[c], field.text);
      if (const auto* why = std::get_if<std::string>(&value))
        add(field, columns[c]->name, fmt::format("\"{}\" {}", field.text, *why));
      else
        points.values(static_cast<Index>(i), index_of(emulator, *columns[c])) = std::get<double>(value);
    }
  }
  if (table.rows.empty()) errors.push_back({table.file, 0, 0, "", "has no rows", ""});
  if (!errors.empty()) throw BadInput(parameters::format(errors));
  return points;
}

}  // namespace cpt::cli

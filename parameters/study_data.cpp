#include "parameters/study_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "parameters/nearest_name.hpp"
#include "parameters/written_number.hpp"

namespace cpt::parameters {
namespace {

constexpr std::size_t least_numbers = 5, most_numbers = 10000;

const Value* value_at_key(const Value* table, std::string_view key) {
  const Member* member = table == nullptr ? nullptr : table->find(key);
  return member == nullptr ? nullptr : &member->value;
}

const Value* text_of(const Value& table, std::string_view key) {
  const Value* value = value_at_key(&table, key);
  return value != nullptr && value->kind == Value::Kind::text ? value : nullptr;
}

void want(const Value& distribution, const Value* data, std::vector<WantedFile>& found) {
  const Value *kind = text_of(distribution, "kind"), *file = text_of(distribution, "file"),
              *column = text_of(distribution, "column");
  if (kind == nullptr || kind->text != "empirical" || file == nullptr || column == nullptr) return;
  if (value_at_key(data, file->text) != nullptr) return;
  auto known = std::ranges::find(found, file->text, &WantedFile::file);
  if (known == found.end()) known = found.insert(known, {file->text, file->place, {}});
  if (std::ranges::find(known->columns, column->text) == known->columns.end())
    known->columns.push_back(column->text);
}

// Rows may lie in subtables: "sand.H" or [parameters.sand].
void collect(const Value& table, const Value* data, std::vector<WantedFile>& found) {
  for (const Member& member : table.members) {
    if (member.value.kind != Value::Kind::table) continue;
    if (member.key == "distribution")
      want(member.value, data, found);
    else
      collect(member.value, data, found);
  }
}

// The numbers of a column as TOML; nothing after an error.
std::string numbers_of(const FieldTable& table, const WantedFile& wanted, const std::string& column,
                       ErrorList& errors) {
  const auto refuse = [&](std::string message, std::string hint = "") {
    errors.add(wanted.place, "distribution.column", std::move(message), std::move(hint));
    return std::string();
  };
  const auto name = std::ranges::find(table.names, column, &Field::text);
  if (name == table.names.end()) {
    std::vector<std::string_view> names;
    for (const Field& field : table.names) names.push_back(field.text);
    const std::string_view near = nearest_name(column, names);
    return refuse(
        fmt::format("{} has no column \"{}\"", wanted.file, column),
        near.empty() ? fmt::format("it has {}", listed(names)) : fmt::format("did you mean \"{}\"?", near));
  }
  std::vector<double> numbers;
  for (const std::vector<Field>& row : table.rows) {
    const Field& field = row[static_cast<std::size_t>(name - table.names.begin())];
    if (field.text.empty()) continue;
    const auto value = written_number(field.text);
    if (!value || !std::isfinite(*value))
      return refuse(fmt::format("{}:{}:{}: \"{}\" is not a finite number", wanted.file, field.place.line,
                                field.place.column, field.text),
                    number_hint(field.text));
    numbers.push_back(*value);
  }
  if (numbers.size() < least_numbers || numbers.size() > most_numbers)
    return refuse(fmt::format("{} has {} numbers in column \"{}\", not {} to {}", wanted.file, numbers.size(),
                              column, least_numbers, most_numbers));
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

}  // namespace

std::vector<WantedFile> wanted_files(std::string_view study_text) {
  const auto document = parse_document(study_text);
  const Value* root = std::get_if<Value>(&document);
  std::vector<WantedFile> found;
  if (const Value* rows = value_at_key(root, "parameters")) collect(*rows, value_at_key(root, "data"), found);
  return found;
}

std::string data_section(const FieldTable& table, const WantedFile& wanted, ErrorList& errors) {
  std::string section =
      fmt::format("\n[data.{}]  # as the file was when the study was read\n", toml_string(wanted.file));
  for (const std::string& column : wanted.columns) {
    const std::string numbers = numbers_of(table, wanted, column, errors);
    if (numbers.empty()) return "";
    section += fmt::format("{} = {}\n", toml_string(column), numbers);
  }
  return section;
}

}  // namespace cpt::parameters

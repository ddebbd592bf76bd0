#include "parameters/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parameters/nearest_name.hpp"
#include "parameters/written_number.hpp"
#include "solver/quantities.hpp"

namespace cpt::parameters {
namespace {

// "write 25, without quotes" for "25".
std::string unquoted_hint(const std::string& text) {
  const std::optional<double> number = written_number(text);
  if (number && std::isfinite(*number)) return fmt::format("write {}, without quotes", *number);
  return number_hint(text);
}

std::string wrong_type(Value::Kind expected, const Value& value) {
  const std::string given = value.kind == Value::Kind::text ? fmt::format("the text \"{}\"", value.text)
                                                            : std::string(to_string(value.kind));
  return fmt::format("must be {}, not {}", to_string(expected), given);
}

const Member* field(const Value& table, std::string_view prefix, std::string_view key, bool required,
                    ErrorList& errors) {
  const Member* member = table.find(key);
  if (member == nullptr && required && !errors.is_meant(table, key))
    errors.add(table.place, joined(prefix, key), "is missing");
  return member;
}

// Text that is not empty.
std::optional<std::string> text_of(const Value& value, const std::string& key, const std::string& hint,
                                   ErrorList& errors) {
  if (value.kind == Value::Kind::text && !value.text.empty()) return value.text;
  errors.add(value.place, key,
             value.kind == Value::Kind::text ? "must not be empty" : wrong_type(Value::Kind::text, value),
             hint);
  return std::nullopt;
}

}  // namespace

void ErrorList::add(Place place, std::string key, std::string message, std::string hint) {
  errors_.push_back({file_, place.line, place.column, std::move(key), std::move(message), std::move(hint)});
}

std::vector<StudyError> ErrorList::sorted() const {
  std::vector<StudyError> errors = errors_;
  std::stable_sort(errors.begin(), errors.end(), [](const StudyError& a, const StudyError& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
  return errors;
}

std::string joined(std::string_view prefix, std::string_view key) {
  return prefix.empty() ? std::string(key) : fmt::format("{}.{}", prefix, key);
}

std::string listed(std::span<const std::string_view> names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

bool refuse_unknown_keys(const Value& table, std::string_view prefix, std::span<const std::string_view> known,
                         ErrorList& errors, std::string_view hint) {
  bool all_known = true;
  for (const Member& member : table.members) {
    if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
    all_known = false;
    const std::string_view near = nearest_name(member.key, known);
    if (!near.empty()) errors.note_meant(table, near);
    errors.add(member.place, joined(prefix, member.key),
               fmt::format("unknown key; known are {}", listed(known)),
               near.empty() ? std::string(hint) : fmt::format("did you mean {}?", near));
  }
  return all_known;
}

std::optional<double> finite_number(const Value& value, const std::string& key, ErrorList& errors) {
  if (value.kind != Value::Kind::number) {
    errors.add(value.place, key, wrong_type(Value::Kind::number, value),
               value.kind == Value::Kind::text ? unquoted_hint(value.text) : "");
    return std::nullopt;
  }
  if (!std::isfinite(value.number)) {
    errors.add(value.place, key, fmt::format("must be a finite number, not {}", value.number));
    return std::nullopt;
  }
  return value.number;
}

std::optional<double> number_field(const Value& table, std::string_view prefix, std::string_view key,
                                   bool required, ErrorList& errors) {
  const Member* member = field(table, prefix, key, required, errors);
  return member == nullptr ? std::nullopt : finite_number(member->value, joined(prefix, key), errors);
}

std::optional<bool> flag_field(const Value& table, std::string_view prefix, std::string_view key,
                               ErrorList& errors) {
  const Member* member = table.find(key);
  if (member == nullptr) return std::nullopt;
  if (member->value.kind == Value::Kind::boolean) return member->value.number != 0.0;
  errors.add(member->value.place, joined(prefix, key),
             fmt::format("must be true or false, not {}", to_string(member->value.kind)));
  return std::nullopt;
}

std::optional<std::string> text_field(const Value& table, std::string_view prefix, std::string_view key,
                                      bool required, ErrorList& errors) {
  const Member* member = field(table, prefix, key, required, errors);
  return member == nullptr ? std::nullopt : text_of(member->value, joined(prefix, key), "", errors);
}

std::optional<std::string> name_field(const Value& table, std::string_view prefix, std::string_view key,
                                      bool required, std::span<const std::string_view> names,
                                      ErrorList& errors) {
  const Member* member = table.find(key);
  const std::string hint = fmt::format("one of {}", listed(names));
  if (member == nullptr) {
    if (required && !errors.is_meant(table, key))
      errors.add(table.place, joined(prefix, key), "is missing", hint);
    return std::nullopt;
  }
  std::optional<std::string> text = text_of(member->value, joined(prefix, key), hint, errors);
  if (!text || std::find(names.begin(), names.end(), *text) != names.end()) return text;
  const std::string_view near = nearest_name(*text, names);
  errors.add(member->value.place, joined(prefix, key),
             fmt::format("\"{}\" is not one of {}", *text, listed(names)),
             near.empty() ? "" : fmt::format("did you mean \"{}\"?", near));
  return std::nullopt;
}

const Value* section(const Value& root, std::string_view key, ErrorList& errors) {
  const Member* member = root.find(key);
  if (member == nullptr) return nullptr;
  if (member->value.kind == Value::Kind::table) return &member->value;
  errors.add(member->place, std::string(key), wrong_type(Value::Kind::table, member->value),
             fmt::format("start the section with [{}]", key));
  return nullptr;
}

std::vector<const Value*> sections(const Value& root, std::string_view key, ErrorList& errors) {
  std::vector<const Value*> tables;
  const Member* member = root.find(key);
  if (member == nullptr) return tables;
  const std::string hint = fmt::format("start each with [[{}]]", key);
  if (member->value.kind != Value::Kind::array) {
    errors.add(member->place, std::string(key), wrong_type(Value::Kind::array, member->value), hint);
    return tables;
  }
  for (const Value& item : member->value.items) {
    if (item.kind == Value::Kind::table)
      tables.push_back(&item);
    else
      errors.add(item.place, std::string(key), wrong_type(Value::Kind::table, item), hint);
  }
  return tables;
}

}  // namespace cpt::parameters

#include "results/tables/json_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "parameters/fields.hpp"
#include "parameters/written_number.hpp"

namespace cpt::results {
namespace {

using Json = nlohmann::ordered_json;
using parameters::ErrorList;
using parameters::FieldTable;
using parameters::most_errors;

std::string spelt(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string spelt(const Cell& cell) {
  return std::visit(
      [](const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
          return std::string("null");
        else
          return spelt(Json(value));
      },
      cell);
}

/// Line and column of a byte, counted from 1.
parameters::Place place_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const auto line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  const std::string_view line = before.substr(line_start);
  return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
          1 + static_cast<int>(std::count_if(line.begin(), line.end(), [](char c) {
            return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
          }))};
}

/// Keys that an object has twice: of them only one would be kept.
class KeysTwice {
 public:
  bool operator()(int /*depth*/, Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) open_.emplace_back();
    if (event == Json::parse_event_t::object_end) open_.pop_back();
    if (event != Json::parse_event_t::key) return true;
    const auto& name = parsed.get_ref<const std::string&>();
    if (open_.size() == 1) table_ = name;
    if (!open_.back().insert(name).second && found_.empty())
      found_ = open_.size() == 1 ? name : fmt::format("{} of a row of {}", name, table_);
    return true;
  }
  [[nodiscard]] const std::string& found() const { return found_; }

 private:
  std::vector<std::set<std::string>> open_;  // of the objects around the present place
  std::string table_, found_;
};

/// Names of the first row; every other has the same.
void read_rows(const Json& rows, FieldTable& table, ErrorList& errors) {
  int number = 0;
  for (const Json& row : rows) {
    const std::string key = fmt::format("{}, row {}", table.name, ++number);
    if (errors.size() >= most_errors) return;
    if (!row.is_object()) {
      errors.add({}, key, fmt::format("must be an object, not {}", row.type_name()));
      continue;
    }
    if (number == 1)
      for (const auto& [name, value] : row.items()) table.names.push_back({name, {}});
    std::vector<parameters::Field>& fields = table.rows.emplace_back();
    for (const parameters::Field& name : table.names) {
      const auto found = row.find(name.text);
      if (found == row.end())
        errors.add({}, key, fmt::format("lacks \"{}\", which row 1 has", name.text));
      else if (found->is_structured() || found->is_boolean())
        errors.add(
            {}, key,
            fmt::format("\"{}\" must be a number, a text or null, not {}", name.text, found->type_name()));
      else
        fields.push_back({found->is_null()     ? std::string()
                          : found->is_string() ? found->get<std::string>()
                                               : spelt(*found),
                          {}});
    }
    if (row.size() > table.names.size())
      errors.add({}, key, fmt::format("has {} entries, row 1 has {}", row.size(), table.names.size()));
  }
}

}  // namespace

std::string json_document(std::string_view format, int version, std::span<const NamedTable> tables) {
  std::string out = fmt::format("{{\n\"format\": {},\n\"version\": {}", spelt(Json(format)), version);
  for (const NamedTable& named : tables) {
    out += fmt::format(",\n{}: [", spelt(Json(named.name)));
    const char* between = "\n";
    for (const std::vector<Cell>& row : named.table.rows) {
      out += between;
      for (std::size_t i = 0; i < row.size(); ++i)
        out +=
            fmt::format("{}{}: {}", i == 0 ? "{" : ", ", spelt(Json(named.table.columns[i])), spelt(row[i]));
      out += "}";
      between = ",\n";
    }
    out += "]";
  }
  return out + "\n}\n";
}

std::variant<std::vector<FieldTable>, std::vector<parameters::StudyError>> read_json_document(
    std::string_view json, const std::string& file, std::string_view format, int version) {
  ErrorList errors(file);
  json = parameters::without_padding(json);
  Json document;
  KeysTwice twice;
  try {
    document = Json::parse(json, std::ref(twice));
  } catch (const Json::parse_error& problem) {
    errors.add(place_of(json, problem.byte), "", "is not JSON from here on",
               json.starts_with("\xFF\xFE") || json.starts_with("\xFE\xFF")
                   ? "the file is UTF-16: save it as UTF-8"
                   : "");
    return errors.sorted();
  } catch (const Json::exception& problem) {  // a number too large for a double
    errors.add({}, "", fmt::format("cannot be read as JSON ({})", problem.what()));
    return errors.sorted();
  }
  if (!twice.found().empty()) {
    errors.add({}, twice.found(), "is there twice", "each table and each entry of a row stands once");
    return errors.sorted();
  }
  const auto says = document.is_object() ? document.find("format") : document.end();
  if (says == document.end() || *says != format) {
    errors.add({}, "format", fmt::format("must be \"{}\"", format), "is it another program's file?");
    return errors.sorted();
  }
  const auto made = document.find("version");
  if (made == document.end() || !made->is_number_integer() || *made < 1 || *made > version) {
    errors.add({}, "version", fmt::format("must be a whole number from 1 to {}", version));
    return errors.sorted();
  }
  std::vector<FieldTable> tables;
  for (const auto& [name, rows] : document.items()) {
    if (name == "format" || name == "version") continue;
    if (rows.is_array())
      read_rows(rows, tables.emplace_back(FieldTable{file, name, {}, {}}), errors);
    else
      errors.add({}, name, fmt::format("must be an array of rows, not {}", rows.type_name()));
  }
  if (!errors.empty()) return errors.sorted();
  return tables;
}

}  // namespace cpt::results

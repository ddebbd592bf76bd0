#include "results/tables/json_document.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <type_traits>
#include <variant>
#include <vector>

namespace cpt::results {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace cpt::results

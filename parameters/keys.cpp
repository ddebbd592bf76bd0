#include "parameters/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cpt::parameters {
namespace {

template <class Named>
const Named& named(std::span<const Named> all, std::string_view name) {
  const auto found = std::ranges::find(all, name, &Named::name);
  if (found == all.end()) throw std::logic_error(fmt::format("no key or table {} is listed", name));
  return *found;
}

}  // namespace

std::string values_of(const Key& key) {
  if (!key.choices.empty()) return fmt::format("one of {}", fmt::join(key.choices, ", "));
  if (std::isfinite(key.least) && std::isfinite(key.most))
    return fmt::format("{}, {} to {}", key.type, key.least, key.most);
  return std::string(key.type);
}

const KeyTable& table_named(std::span<const KeyTable> tables, std::string_view name) {
  return named(tables, name);
}

const Key& key_named(std::span<const KeyTable> tables, std::string_view table, std::string_view key) {
  return named(std::span<const Key>(table_named(tables, table).keys), key);
}

std::vector<std::string_view> known_names(std::span<const KeyTable> tables, std::string_view table) {
  std::vector<std::string_view> names;
  for (const Key& key : table_named(tables, table).keys) names.push_back(key.name);
  if (table.empty())
    for (const KeyTable& other : tables)
      if (!other.name.empty()) names.push_back(other.name);
  return names;
}

}  // namespace cpt::parameters

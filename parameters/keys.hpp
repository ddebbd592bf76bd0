// Keys of the project's TOML files, each with a sentence: the readers know them from such a list, their hints
// name the nearest, and `campaign list` and docs/reference.md print it.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cpt::parameters {

struct Key {
  std::string_view name;
  std::string_view type;     ///< "text", "number above 0", ...; with its bounds or choices: values_of
  std::string_view usually;  ///< what holds without it; "required" if the file must have it
  std::string_view meaning;  ///< one line
  double least = -std::numeric_limits<double>::infinity();  ///< of a number, included
  double most = std::numeric_limits<double>::infinity();    ///< of a number, included
  std::vector<std::string_view> choices = {};               ///< valid texts; empty: any
};

/// A section [name], a list of tables [[name]], or the top of the file ("").
struct KeyTable {
  std::string_view name;
  bool list;                 ///< written [[name]], any number of times
  std::string_view meaning;  ///< one line
  std::vector<Key> keys;
};

/// "whole number, 2 to 20", "one of sand, clay"
[[nodiscard]] std::string values_of(const Key& key);

/// The table of that name; throws std::logic_error if there is none.
[[nodiscard]] const KeyTable& table_named(std::span<const KeyTable> tables, std::string_view name);
/// The key of a table; throws std::logic_error if there is none.
[[nodiscard]] const Key& key_named(std::span<const KeyTable> tables, std::string_view table,
                                   std::string_view key);
/// All names that a table may hold: its keys, and at the top of the file the other tables too.
[[nodiscard]] std::vector<std::string_view> known_names(std::span<const KeyTable> tables,
                                                        std::string_view table);

}  // namespace cpt::parameters

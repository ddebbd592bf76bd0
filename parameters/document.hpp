// TOML text as a plain tree that knows where everything stands in the file.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cpt::parameters {

/// Place in a file, both from 1; 0 where the file as a whole is meant.
struct Place {
  int line = 0;
  int column = 0;
  friend auto operator<=>(const Place&, const Place&) = default;
};

struct Member;

/// A value of a document; only the fields of its kind are set.
struct Value {
  enum class Kind { number, text, boolean, date, array, table };
  Kind kind = Kind::table;
  Place place;
  double number = 0.0;          ///< also 1 or 0 of a boolean
  std::string text;             ///< a text's content
  std::vector<Value> items;     ///< of an array, in order
  std::vector<Member> members;  ///< of a table, in the order of the file

  [[nodiscard]] const Member* find(std::string_view key) const;
};

/// A key of a table and its value.
struct Member {
  std::string key;
  Place place;  ///< of the key
  Value value;
};

/// "a number", "a text", ...
[[nodiscard]] std::string_view to_string(Value::Kind kind);

struct SyntaxError {
  Place place;
  std::string message;
  std::string hint;  ///< what to write instead, as far as that can be guessed; never empty
};

/// As a basic string of TOML, in quotes.
[[nodiscard]] std::string toml_string(std::string_view text);

/// The document's root table, or the first thing in it that is not TOML. Padding behind the end (0x1A, zero
/// bytes) does not count.
[[nodiscard]] std::variant<Value, SyntaxError> parse_document(std::string_view toml);

}  // namespace cpt::parameters

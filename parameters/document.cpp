#include "parameters/document.hpp"

// toml++ 3.3 hands over "[[=" to a function that takes a key for granted (fixed by its pull request 301): it
// asserts, or lets the compiler assume, what is not so. Without the assertion the function tells the mistake
// itself.
#include <toml++/impl/preprocessor.h>
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT_ASSUME(expr) static_assert(true)
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "parameters/written_number.hpp"

namespace cpt::parameters {
namespace {

Place place_of(const toml::source_region& source) {
  return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

Value convert(const toml::node& node) {
  Value value;
  value.place = place_of(node.source());
  node.visit([&](const auto& typed) {
    using Node = std::decay_t<decltype(typed)>;
    if constexpr (std::is_same_v<Node, toml::table>) {
      value.kind = Value::Kind::table;
      for (const auto& [key, child] : typed)
        value.members.push_back({std::string(key.str()), place_of(key.source()), convert(child)});
      // toml++ sorts by name; a study's order is its author's.
      std::stable_sort(value.members.begin(), value.members.end(),
                       [](const Member& a, const Member& b) { return a.place < b.place; });
    } else if constexpr (std::is_same_v<Node, toml::array>) {
      value.kind = Value::Kind::array;
      for (const toml::node& child : typed) value.items.push_back(convert(child));
    } else if constexpr (std::is_same_v<Node, toml::value<std::string>>) {
      value.kind = Value::Kind::text;
      value.text = typed.get();
    } else if constexpr (std::is_same_v<Node, toml::value<double>>) {
      value.kind = Value::Kind::number;
      value.number = typed.get();
    } else if constexpr (std::is_same_v<Node, toml::value<std::int64_t>>) {
      value.kind = Value::Kind::number;
      value.number = static_cast<double>(typed.get());
    } else if constexpr (std::is_same_v<Node, toml::value<bool>>) {
      value.kind = Value::Kind::boolean;
      value.number = typed.get() ? 1.0 : 0.0;
    } else {
      value.kind = Value::Kind::date;
    }
  });
  return value;
}

std::string_view line_of(std::string_view text, int number) {
  for (int line = 1; line < number && !text.empty(); ++line)
    text.remove_prefix(std::min(text.find('\n') + 1, text.size()));
  return text.substr(0, text.find_first_of("\r\n"));
}

// Bytes of the value that begins here: up to a comma with a blank behind it, a closing bracket, a comment.
std::string_view leading_value(std::string_view text) {
  std::size_t size = 0;
  while (size < text.size() && std::string_view("}]#").find(text[size]) == std::string_view::npos &&
         !(text[size] == ',' && (size + 1 == text.size() || text[size + 1] == ' ')))
    ++size;
  text = text.substr(0, size);
  const std::size_t last = text.find_last_not_of(" \t");
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

// What a value that is not TOML was meant to be.
std::string meant(std::string_view value) {
  if (const std::string hint = number_hint(value); !hint.empty()) return hint;
  if (const std::optional<double> number = written_number(value); number && std::isfinite(*number))
    return fmt::format("this number is written {}", *number);
  const bool word = !value.empty() && std::all_of(value.begin(), value.end(), [](char c) {
    return c == '_' || c == '-' || c == '.' || c == '/' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  });
  return word ? fmt::format("a text stands in quotes: \"{}\"", value) : "";
}

std::string syntax_hint(std::string_view toml, Place place) {
  constexpr std::string_view rest = "the rest of the file is checked once this is mended";
  if (toml.starts_with("\xFF\xFE") || toml.starts_with("\xFE\xFF"))
    return "the file is UTF-16: save it as UTF-8";
  const std::string_view line = line_of(toml, place.line);
  for (std::size_t equals = line.find('='); equals != line.npos; equals = line.find('=', equals + 1)) {
    const std::size_t begin = line.find_first_not_of(" \t", equals + 1);
    if (begin == line.npos || static_cast<int>(begin) > place.column) break;
    const std::string_view value = leading_value(line.substr(begin));
    // The reader stops within the value or, of 4,5 in braces, where it misses the next key's sign.
    if (static_cast<int>(begin + value.size()) + 3 < place.column) continue;
    if (const std::string hint = meant(value); !hint.empty()) return fmt::format("{}; {}", hint, rest);
  }
  return std::string(rest);
}

}  // namespace

const Member* Value::find(std::string_view key) const {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const Member& m) { return m.key == key; });
  return found == members.end() ? nullptr : &*found;
}

std::string_view to_string(Value::Kind kind) {
  switch (kind) {
    case Value::Kind::number:
      return "a number";
    case Value::Kind::text:
      return "a text";
    case Value::Kind::boolean:
      return "true or false";
    case Value::Kind::date:
      return "a date or time";
    case Value::Kind::array:
      return "an array";
    case Value::Kind::table:
      return "a table";
  }
  return "";
}

std::string toml_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      out += fmt::format("\\u{:04X}", static_cast<int>(c));
    else
      out += c;
  }
  return out + '"';
}

std::variant<Value, SyntaxError> parse_document(std::string_view toml) {
  toml = without_padding(toml);
  try {
    return convert(toml::parse(toml));
  } catch (const toml::parse_error& error) {
    const Place place = place_of(error.source());
    return SyntaxError{place, std::string(error.description()), syntax_hint(toml, place)};
  }
}

}  // namespace cpt::parameters

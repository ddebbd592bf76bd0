#include "parameters/document.hpp"

// toml++ 3.3 hands over "[[=" to a function that takes a key for granted (fixed by its pull request 301): it
// asserts, or lets the compiler assume, what is not so. Without the assertion the function tells the mistake
// itself.
#include <toml++/impl/preprocessor.h>
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT_ASSUME(expr) static_assert(true)
#include <toml++/toml.h>

#include <algorithm>

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

std::variant<Value, SyntaxError> parse_document(std::string_view toml) {
  try {
    return convert(toml::parse(toml));
  } catch (const toml::parse_error& error) {
    return SyntaxError{place_of(error.source()), std::string(error.description())};
  }
}

}  // namespace cpt::parameters

#include "parameters/document.hpp"

#include <gtest/gtest.h>

namespace cpt::parameters {
namespace {

TEST(Document, KeepsTheOrderAndThePlacesOfTheFile) {
  const auto parsed = parse_document("z = 1\na = { y = 2.5, b = \"text\" }\n[m]\nk = [true, 1979-05-27]\n");
  const Value& root = std::get<Value>(parsed);
  ASSERT_EQ(root.members.size(), 3u);
  EXPECT_EQ(root.members[0].key, "z");
  EXPECT_EQ(root.members[1].key, "a");
  EXPECT_EQ(root.members[2].key, "m");
  EXPECT_EQ(root.members[0].value.number, 1.0);
  const Value& a = root.members[1].value;
  ASSERT_EQ(a.members.size(), 2u);
  EXPECT_EQ(a.members[0].key, "y");
  EXPECT_EQ(a.members[0].value.number, 2.5);
  EXPECT_EQ(a.find("b")->value.text, "text");
  EXPECT_EQ(a.find("b")->place, (Place{2, 16}));
  EXPECT_EQ(a.find("b")->value.place, (Place{2, 20}));
  EXPECT_EQ(a.find("c"), nullptr);
  const Value& k = root.find("m")->value.find("k")->value;
  ASSERT_EQ(k.items.size(), 2u);
  EXPECT_EQ(k.items[0].kind, Value::Kind::boolean);
  EXPECT_EQ(k.items[1].kind, Value::Kind::date);
}

TEST(Document, SyntaxErrorsHaveAPlace) {
  for (const auto& [text, line] :
       {std::pair("a = \n", 1), std::pair("a = 1\nb = = 2\n", 2), std::pair("a = 1\na = 2\n", 2),
        std::pair("[s\n", 1), std::pair("a = 1\n\n[t]\n[t]\n", 4), std::pair("a = 1\n[[=\n", 2)}) {
    const auto parsed = parse_document(text);
    ASSERT_TRUE(std::holds_alternative<SyntaxError>(parsed)) << text;
    const auto& error = std::get<SyntaxError>(parsed);
    EXPECT_EQ(error.place.line, line) << text;
    EXPECT_GT(error.place.column, 0) << text;
    EXPECT_FALSE(error.message.empty()) << text;
  }
}

}  // namespace
}  // namespace cpt::parameters

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

TEST(Document, NumbersThatAreNotTomlsGetAHint) {
  const std::pair<const char*, const char*> table[] = {
      {"x = 0,5\n", "decimals follow a point, not a comma: 0.5"},
      {"[fixed]\n\"sand.H\" = 2,5 # of the paper\n", "decimals follow a point, not a comma: 2.5"},
      {"r = { baseline = 0,5, upper = 3 }\n", "decimals follow a point, not a comma: 0.5"},
      {"r = { baseline = 36, upper = 4,5 }\n", "decimals follow a point, not a comma: 4.5"},
      {"x = 1.5D3\n", "this number is written 1500"},
      {"x = \xE2\x88\x92"
       "5\n",
       "this number is written -5"},
      {"x = .5\n", "this number is written 0.5"},
      {"x = 1 000\n", "thousands are not set apart: 1000"},
      {"x = 25 kPa\n", "the number alone, without a unit: 25"},
      {"x = 5%\n", "the number alone, without a unit: 5"},
      {"preset = quick\n", "a text stands in quotes: \"quick\""},
      {"\xFF\xFEx", "the file is UTF-16: save it as UTF-8"},
      {"x = = 1\n", "the rest of the file is checked"},
      {"x = 1\nx = 2\n", "the rest of the file is checked"}};
  for (const auto& [text, hint] : table) {
    const auto parsed = parse_document(text);
    ASSERT_TRUE(std::holds_alternative<SyntaxError>(parsed)) << text;
    EXPECT_NE(std::get<SyntaxError>(parsed).hint.find(hint), std::string::npos)
        << text << std::get<SyntaxError>(parsed).hint;
  }
}

TEST(Document, WhatOldSystemsPutBehindTheEndDoesNotCount) {
  const auto parsed = parse_document(std::string_view("\xEF\xBB\xBFx = +5\r\n\x1A\0\0", 14));
  ASSERT_TRUE(std::holds_alternative<Value>(parsed));
  EXPECT_EQ(std::get<Value>(parsed).find("x")->value.number, 5.0);
  for (const std::string_view text :
       {std::string_view("x = 1\n\x1Ay = 2\n"), std::string_view("x = 1\n\0y = 2\n", 13)}) {
    const auto refused = parse_document(text);
    ASSERT_TRUE(std::holds_alternative<SyntaxError>(refused));
    EXPECT_EQ(std::get<SyntaxError>(refused).place.line, 2);
  }
}

}  // namespace
}  // namespace cpt::parameters

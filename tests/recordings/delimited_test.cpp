// Tables of delimited text.
#include "recordings/delimited.hpp"

#include "tests/recordings/files.hpp"

namespace cpt::recordings {
namespace {

using Texts = std::vector<std::string>;

Texts texts(const std::vector<PlacedText>& fields) {
  Texts all;
  for (const PlacedText& field : fields) all.push_back(field.text);
  return all;
}

DelimitedTable read(std::string_view text) {
  Problems problems("a.csv");
  DelimitedTable table = read_delimited(text, problems);
  EXPECT_FALSE(problems.any()) << format(problems.errors());
  return table;
}

std::string refused(std::string_view text) {
  Problems problems("a.csv");
  (void)read_delimited(text, problems);
  EXPECT_TRUE(problems.any()) << text;
  return format(problems.errors());
}

TEST(Delimited, QuotedFieldsHoldSeparatorsQuotesAndLineBreaks) {
  const DelimitedTable table =
      read("name, x ,\"y z\"\n\"a, \"\"b\"\"\",1,\n\"two\r\nlines\" , 2,\" kept \"\n");
  EXPECT_EQ(texts(table.names), (Texts{"name", "x", "y z"}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(texts(table.rows[0]), (Texts{"a, \"b\"", "1", ""}));
  EXPECT_EQ(texts(table.rows[1]), (Texts{"two\r\nlines", "2", " kept "}));
}

TEST(Delimited, FieldsKnowTheirPlaceAlsoBehindLineBreaks) {
  const DelimitedTable table = read("# made by hand\n\na,b\n\"1\n2\",φφ\nx,\"y\"\n");
  EXPECT_EQ(table.names[1].line, 3);
  EXPECT_EQ(table.rows[0][0].line, 4);
  EXPECT_EQ(table.rows[0][1].line, 5);
  EXPECT_EQ(table.rows[0][1].column, 4);
  EXPECT_EQ(table.rows[1][0].line, 6);
  EXPECT_EQ(table.rows[1][1].column, 4);  // inside its quotes
}

TEST(Delimited, NamesTellTheSeparator) {
  for (const char* text : {"a,b\n1,2\n", "a;b\r\n1;2\r\n", "a\tb\n1\t2\n", "a b\n1   2\n", "a , b\r1,2"}) {
    const DelimitedTable table = read(text);
    EXPECT_EQ(texts(table.names), (Texts{"a", "b"})) << text;
    ASSERT_EQ(table.rows.size(), 1U) << text;
    EXPECT_EQ(texts(table.rows[0]), (Texts{"1", "2"})) << text;
  }
  EXPECT_EQ(texts(read("a\tb\tc\n\t\t3\n").rows[0]), (Texts{"", "", "3"}));
}

// As its reference manual shows it, and as later versions and other programs write it.
TEST(Delimited, DakotasTables) {
  for (const char* header : {"%eval_id interface   x1   obj_fn \n", "eval_id interface x1 obj_fn\n",
                             "%eval_id interface\tx1\tobj_fn\n"}) {
    const DelimitedTable table = read(header + std::string("1   NO_ID  0.9  0.0002 \n2\tNO_ID 1.1 NaN\n"));
    EXPECT_EQ(texts(table.names), (Texts{"eval_id", "interface", "x1", "obj_fn"}));
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(texts(table.rows[1]), (Texts{"2", "NO_ID", "1.1", "NaN"}));
  }
}

TEST(Delimited, WhatIsWrongIsToldWithItsPlace) {
  expect_has(refused("a,b,a\n1,2,3\n"), "a.csv:1:5: error: found a second column 'a'");
  expect_has(refused("a,,c\n1,2,3\n"), "a.csv:1:3: error: found a column without a name");
  expect_has(refused("a,b\n1,2\n1,2,3\n"), "a.csv:3:1: error: found 3 fields, expected 2");
  expect_has(refused("a,b\n1,\"2\n3,4\n"), "a.csv:2:3: error: found '\"2', expected a closing quote");
  expect_has(refused("a,b\n\"1\"x,2\n"), "a.csv:2:4: error: found 'x,2', expected a comma");
  expect_has(refused("# nothing\n\n"), "no line of column names");
}

}  // namespace
}  // namespace cpt::recordings

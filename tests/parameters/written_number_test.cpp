#include "parameters/written_number.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::parameters {
namespace {

TEST(WrittenNumber, IsReadWholeOrNotAtAll) {
  const std::pair<const char*, double> numbers[] = {{"25", 25.0},
                                                    {"+25", 25.0},
                                                    {"-25", -25.0},
                                                    {"0.5", 0.5},
                                                    {".5", 0.5},
                                                    {"5.", 5.0},
                                                    {"1e3", 1000.0},
                                                    {"1E+3", 1000.0},
                                                    {"1.5D+03", 1500},
                                                    {"1.5d-1", 0.15},
                                                    {"-1.5D0", -1.5},
                                                    {"\xE2\x88\x92"
                                                     "5",
                                                     -5.0},
                                                    {"007", 7.0}};
  for (const auto& [text, value] : numbers) {
    const auto read = written_number(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(*read, value) << text;
  }
  EXPECT_TRUE(std::isnan(*written_number("nan")));
  EXPECT_TRUE(std::isinf(*written_number("-inf")));
  for (const char* text : {"",
                           " ",
                           "+",
                           "-",
                           "+-5",
                           "-+5",
                           "--5",
                           "++5",
                           "\xE2\x88\x92-5",
                           "0,5",
                           "1,234.5",
                           "1 234",
                           "1'234",
                           "25 kPa",
                           "25%",
                           "0x10",
                           "1e",
                           "1e+",
                           "1D",
                           "D3",
                           "5-3",
                           "5\xE2\x88\x92"
                           "3",
                           "5\xE2\x80\x93",
                           "1.2.3",
                           "5\x1A",
                           "five"})
    EXPECT_FALSE(written_number(text)) << text;
}

TEST(WrittenNumber, HintsSayWhatToWrite) {
  EXPECT_EQ(number_hint("0,5"), "decimals follow a point, not a comma: 0.5");
  EXPECT_EQ(number_hint("-1.234,5"), "decimals follow a point, not a comma: -1234.5");
  EXPECT_EQ(number_hint("1,234.5"), "thousands are not set apart: 1234.5");
  EXPECT_EQ(number_hint("1 234"), "thousands are not set apart: 1234");
  EXPECT_EQ(number_hint("1'234'567"), "thousands are not set apart: 1234567");
  EXPECT_EQ(number_hint("25 kPa"), "the number alone, without a unit: 25");
  EXPECT_EQ(number_hint("25%"), "the number alone, without a unit: 25");
  for (const char* text : {"", "rigid", "5-3", "1.2.3", "--5", "25", "1.5D3"})
    EXPECT_EQ(number_hint(text), "") << text;
}

TEST(WrittenNumber, PaddingBehindTheEndIsNoText) {
  EXPECT_EQ(without_padding(std::string_view("a,b\r\n1,2\r\n\x1A\0\0", 13)), "a,b\r\n1,2\r\n");
  EXPECT_EQ(without_padding(std::string_view("a\n\0\0\0", 5)), "a\n");
  EXPECT_EQ(without_padding("a\n\n"), "a\n\n");
  EXPECT_EQ(without_padding("a\x1A"
                            "b\n"),
            "a\x1A"
            "b\n");  // not at the end: whoever reads it refuses it
  EXPECT_EQ(without_padding(""), "");
}

}  // namespace
}  // namespace cpt::parameters

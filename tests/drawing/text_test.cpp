#include "drawing/text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace cpt::drawing {
namespace {

TEST(Text, EscapesMarkupAndQuotes) {
  EXPECT_EQ(escape("<b a='1'>\"x\" & y</b>"), "&lt;b a=&#39;1&#39;&gt;&quot;x&quot; &amp; y&lt;/b&gt;");
  EXPECT_EQ(escape("σ'ₕ₀ 30°"), "σ&#39;ₕ₀ 30°");
}

TEST(Text, ReplacesWhatXmlForbids) {
  EXPECT_EQ(escape(std::string_view("a\0b", 3)), "a\uFFFDb");
  EXPECT_EQ(escape("\x1b[31m"), "\uFFFD[31m");
  EXPECT_EQ(escape("\xff\xc3"), "\uFFFD\uFFFD");  // broken bytes
  EXPECT_EQ(escape("\xc0\xbc"), "\uFFFD\uFFFD");  // overlong '<'
  EXPECT_EQ(escape("\xe0\x80\xbc"), "\uFFFD");    // and in three bytes
  EXPECT_EQ(escape("\xed\xa0\x80"), "\uFFFD");    // half of a surrogate pair
  EXPECT_EQ(escape("a\nb\tc"), "a\nb\tc");
}

TEST(Text, SubscriptsOfSymbols) {
  EXPECT_EQ(symbolic("φ_cont/φ_cs"), (Rich{{"φ", false}, {"cont", true}, {"/φ", false}, {"cs", true}}));
  EXPECT_EQ(symbolic("σ'ₕ₀"), (Rich{{"σ'", false}, {"h0", true}}));
  EXPECT_EQ(symbolic("q_c (kPa)"), (Rich{{"q", false}, {"c", true}, {" (kPa)", false}}));
  EXPECT_EQ(symbolic("e_cs,0"), (Rich{{"e", false}, {"cs,0", true}}));
  EXPECT_EQ(symbolic("q_c, f_s"), (Rich{{"q", false}, {"c", true}, {", f", false}, {"s", true}}));
  EXPECT_EQ(plain("my_window"), (Rich{{"my_window", false}}));
  EXPECT_EQ(html(symbolic("s_u<")), "s<sub>u&lt;</sub>");
}

TEST(Text, WidthGrowsWithTextAndSizeAndSubscriptsAreSmaller) {
  const double one = width(plain("0"), 10.0);
  EXPECT_GT(one, 4.0);
  EXPECT_LT(one, 8.0);
  EXPECT_NEAR(width(plain("0000"), 10.0), 4.0 * one, 0.2);
  EXPECT_NEAR(width(plain("0"), 20.0), 2.0 * one, 0.2);
  EXPECT_LT(width(symbolic("_0"), 10.0), one);
  EXPECT_GT(width(plain("\xff"), 10.0), 0.0);  // not UTF-8: measured as what is drawn
}

TEST(Text, NumbersKeepTheirDigits) {
  EXPECT_EQ(number(3823.4, 4), "3823");
  EXPECT_EQ(number(264.04, 4), "264.0");
  EXPECT_EQ(number(0.012345, 3), "0.0123");
  EXPECT_EQ(number(-12.0, 3), "−12.0");
  EXPECT_EQ(number(2.2e-16, 2), "2.2e-16");
  EXPECT_EQ(number(0.0, 3), "0");
  EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN(), 3), "–");
  EXPECT_EQ(decimals(-0.0501, 3), "−0.050");
  EXPECT_EQ(decimals(-0.0001, 3), "0.000");
}

}  // namespace
}  // namespace cpt::drawing

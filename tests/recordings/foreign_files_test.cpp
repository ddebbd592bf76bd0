// What programs and systems do to files, in every format: read rightly, or refused with its place. No number
// is cut, and no row lost.
#include "tests/recordings/made_soundings.hpp"

namespace cpt::recordings {
namespace {

class Foreign : public testing::TestWithParam<Format> {
 protected:
  [[nodiscard]] std::string file() const { return file_of(GetParam()); }
  [[nodiscard]] std::string text(const Writing& writing = {}) const { return made(GetParam(), writing); }
  [[nodiscard]] Recording read(const std::string& bytes) const { return recording(bytes, file()); }
  [[nodiscard]] std::string refused(const std::string& bytes) const { return refusal(bytes, file()); }
  /// The place of the third row.
  [[nodiscard]] std::string third() const { return fmt::format("{}:{}:", file(), third_line(GetParam())); }
};

std::string with_commas(std::string text) {
  std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

std::string utf_16(const std::string& ascii, bool big_endian) {
  std::string bytes;
  for (const char c : ascii) bytes += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

TEST_P(Foreign, IsReadAsItIsMade) {
  const Recording r = read(text());
  expect_made(r);
  EXPECT_EQ(r.id, "Made");
}

TEST_P(Foreign, DecimalCommas) {
  const Recording r = read(text({.number = with_commas}));
  expect_made(r);
  EXPECT_EQ(remark(r, "decimal commas").done, "read as decimals");
}

TEST_P(Foreign, ACommaAmongPointsIsRefused) {
  for (const char* number : {"12,5", "1,350"}) {
    const std::string errors = refused(text({.third_q_c = number}));
    expect_has(errors, third());
    expect_has(errors, fmt::format("'{}'", number));
    expect_has(errors, "decimals follow a point");
  }
}

TEST_P(Foreign, CommasThatMaySetThousandsApartAreRefused) {
  // 1,500 12,500 -30,250: nothing tells 1.5 from 1500.
  const std::string errors = refused(text({.number = with_commas, .first_depth = 1.5}));
  expect_has(errors, "'1,500'");
}

TEST_P(Foreign, SeparatorsOfThousandsAreRefused) {
  for (const char* number : {"1.234,5", "1,234.5", "1,234,567", "1'234.5", "1 234.5", "1\u00A0234.5"}) {
    const std::string errors = refused(text({.third_q_c = number}));
    expect_has(errors, third());
    expect_has(errors, number);
  }
  expect_has(refused(text({.number = with_commas, .third_q_c = "1.234,5"})), third());
}

TEST_P(Foreign, SignsAndExponentsOfNumbers) {
  for (const char* number : {"+1.35", "1.35e0", "1.35E+00", "1.35D+00", "135d-2", "+1.35e+000", "01.350"})
    expect_made(read(text({.third_q_c = number})));
  for (const char* number : {"-1.35", "\u22121.35", "-1.35D+00", "\u2212135e\u22122"})
    EXPECT_NEAR(read(text({.third_q_c = number})).readings[2].q_c, -1.35e6, 1e-3) << number;
  for (const char* number : {"+-1.35", "--1.35", "1.35-", "1.35+02", "1.35e", "1.35x", "1.35.0", "\u20131.35",
                             "0x1", "inf", "1.35MPa", "12_5", "1e16"}) {
    const std::string errors = refused(text({.third_q_c = number}));
    expect_has(errors, third());
    expect_has(errors, fmt::format("'{}'", number));
  }
}

TEST_P(Foreign, EndOfFileMarks) {
  for (const char* tail : {"\x1A", "\x1A\x1A\x1A", "\r\n\x1A\r\n", "  \x1A"}) {
    const Recording r = read(text() + tail);
    expect_made(r);
    expect_has(remark(r, "end-of-file mark").done, "the file ends there");
  }
}

TEST_P(Foreign, TextBehindAnEndOfFileMarkIsRefused) {
  const std::string once = text();
  const auto lines = static_cast<int>(std::count(once.begin(), once.end(), '\n'));
  expect_has(refused(once + "\x1A" + once),
             fmt::format("{}:{}:1: error: found an end-of-file mark (0x1A, Ctrl-Z)", file(), lines + 1));
  expect_has(refused(once + "\x1A\n0"), "end-of-file mark");
}

TEST_P(Foreign, PaddingBehindTheEnd) {
  for (const char byte : {'\0', '\xFF'}) {
    const Recording r = read(text() + std::string(100, byte));
    expect_made(r);
    expect_has(remark(r, "100 bytes 0x00 or 0xFF").done, "left out");
  }
  expect_made(read(text() + "\x1A" + std::string(37, '\0')));
  expect_made(read(text() + "   \n \t \n\n"));
}

TEST_P(Foreign, PaddingBehindRows) {
  expect_made(read(text({.row_end = "   \t "})));
  const Recording r = read(text({.row_end = std::string(3, '\0')}));
  expect_made(r);
  // Those of the last row may count as behind the end.
  EXPECT_GE(remark(r, "zero bytes at the ends of lines").lines.rows, made_rows - 1);
}

TEST_P(Foreign, ZerosAmidTheTextAreRefused) {
  expect_has(refused(text({.third_q_c = std::string("1.3\0005", 5)})), third());
  expect_has(refused(text({.third_q_c = std::string("\0\0\0\0", 4)})), "zero bytes (0x00)");
  expect_has(refused(std::string(8, '\0') + text()), file() + ":1:1: error");
}

TEST_P(Foreign, LineEnds) {
  for (const char* end : {"\n", "\r\n", "\r", "\n\n", "\r\r\n"}) expect_made(read(text({.end = end})));
}

TEST_P(Foreign, ByteOrderMarkAndUtf16) {
  expect_made(read("\xEF\xBB\xBF" + text()));
  for (const bool big : {false, true}) {
    expect_made(read(utf_16(text(), big)));
    const std::string mark = big ? "\xFE\xFF" : "\xFF\xFE";
    const Recording r = read(mark + utf_16(text({.end = "\r\n"}), big));
    expect_made(r);
    EXPECT_EQ(remark(r, "UTF-16").done, "read as such");
    expect_made(read(mark + utf_16(text(), big) + "\x1A"));
  }
  const std::string cut = "\xFF\xFE" + utf_16(text(), false) + "5";
  expect_has(refused(cut), "half a character of UTF-16");
}

TEST_P(Foreign, Windows1252) {
  const Recording r = read(text({.name = "Kr\xFCger \x96 \x80 \x92"}));
  expect_made(r);
  EXPECT_EQ(r.id, "Kr\u00FCger \u2013 \u20AC \u2019");
  EXPECT_EQ(remark(r, "bytes that are not UTF-8").done, "read as windows-1252");
  EXPECT_EQ(read(text({.name = "Kr\u00FCger \u2013 \u20AC \u2019"})).id, r.id);
  EXPECT_EQ(read(text({.name = "x\x81"})).id, "x\uFFFD") << "windows-1252 has no 0x81";
}

TEST_P(Foreign, AColumnWithoutAName) {
  if (GetParam() == Format::geotech) {
    // Geotech has no columns, but keys: a number without one is refused.
    expect_has(refused(with(text(), "D=0.540", "2,D=0.540")),
               third() + "1: error: found '2', expected KEY=number");
    return;
  }
  const Recording r = read(text({.index = true}));
  expect_made(r);
  if (GetParam() != Format::ags4) {
    EXPECT_EQ(remark(r, "columns: ").done, "not read");
  }
}

INSTANTIATE_TEST_SUITE_P(, Foreign, testing::Values(Format::gef, Format::ags4, Format::geotech, Format::csv),
                         [](const auto& format) {
                           const std::string name(name_of(format.param));
                           return name.substr(0, name.find_first_of("- "));
                         });

// Units are written in the file in GEF, AGS4 and CSV; Geotech prescribes them.
TEST(ForeignUnits, OtherSpellings) {
  for (const char* label :
       {"MPa", "mpa", "MPA ", "MPa (megaPascal)", "[MPa]", "MN/m2", "MN/m\u00B2", "MN/m^2", "MN / m2",
        "N/mm2", "MN m-2", "MN\u00B7m\u207B\u00B2", "megapascal", "(MPa)"})
    for (const Format format : {Format::gef, Format::ags4})
      expect_made(recording(made(format, {.pressure = label}), file_of(format)));
  for (const char* name : {"q_c_MPa", "q_c_mpa", "q_c_MN/m2", "q_c_MN/m\u00B2", "q_c_N/mm^2"})
    expect_made(recording(made(Format::csv, {.csv_q_c = name}), "a.csv"));
  for (const auto& [label, pascal] :
       {std::pair{"kN/m\u00B2", 1e3}, std::pair{"kPa ", 1e3}, std::pair{"Bar", 1e5},
        std::pair{"kgf/cm2", 98066.5}, std::pair{"psi", 6894.757293168}})
    for (const Format format : {Format::gef, Format::ags4}) {
      const Recording r = recording(made(format, {.pressure = label}), file_of(format));
      EXPECT_NEAR(r.readings[0].q_c, 1.25 * pascal, 1e-6 * pascal) << label;
      expect_has(remark(r, "unit of ").done, "as the label says");
    }
}

TEST(ForeignUnits, NoneIsTheFormatsOwn) {
  for (const char* label : {"", "-", "geen"})
    expect_made(recording(made(Format::gef, {.pressure = label}), "a.gef"));
  expect_made(recording(made(Format::ags4, {.pressure = ""}), "a.ags"));
}

TEST(ForeignUnits, WhatIsNoUnitIsRefusedWithItsPlace) {
  for (const char* label : {"ksc", "m", "%", "kPa (megaPascal)", "MPa/m"}) {
    const std::string gef = refusal(made(Format::gef, {.pressure = label}), "a.gef");
    expect_has(gef, fmt::format("a.gef:5:17: error: found '{}', expected the unit of q_c: MPa, kPa", label));
    expect_has(refusal(made(Format::ags4, {.pressure = label}), "a.ags"),
               fmt::format("a.ags:8:16: error: found '{}', expected the unit of SCPT_RES", label));
  }
  expect_has(refusal(made(Format::csv, {.csv_q_c = "q_c_ksc"}), "a.csv"),
             "a.csv:2:1: error: found no column for q_c, and no unit of it in 'q_c_ksc'");
}

TEST(ForeignUnits, AnAngleOrTimeOfUnknownUnitIsLeftOut) {
  const std::string text = with(corpus("plain.gef"), "4, degrees,", "4, gon,");
  const Recording r = recording(text, "a.gef");
  EXPECT_EQ(r.readings.size(), 5U);
  EXPECT_EQ(r.depth_rule, DepthRule::length);
  expect_has(remark(r, "unit 'gon'").done, "not read");
}

// What stands twice.
TEST(ForeignRepeats, AGefHeaderAmongTheRowsIsRefusedOnce) {
  const std::string text = made(Format::gef);
  const std::string errors = refusal(text + text, "a.gef");
  expect_has(errors, "a.gef:19:1: error: found '#GEFID= 1, 1, 0' among the rows");
  EXPECT_EQ(errors.find("error", errors.find("error") + 5), std::string::npos) << errors;
}

TEST(ForeignRepeats, GefEntriesThatContradictEachOther) {
  const std::string text = made(Format::gef);
  expect_has(
      refusal(with(text, "#COLUMNINFO= 3", "#COLUMNINFO= 2, kPa, cone, 2\n#COLUMNINFO= 3"), "a.gef"),
      "a.gef:6:14: error: found '2, kPa, cone, 2', expected column 2 once: line 5 says something else");
  expect_made(
      recording(with(text, "#COLUMNINFO= 3", "#COLUMNINFO= 2, MPa, cone, 2\n#COLUMNINFO= 3"), "a.gef"));
  expect_has(refusal(with(text, "#COLUMNVOID", "#COLUMN= 3\n#COLUMNVOID"), "a.gef"),
             "4 columns, as #COLUMN said");
  const Recording r = recording(
      with(text, "#EOH", "#MEASUREMENTVAR= 13, 0.1, m, x\n#MEASUREMENTVAR= 13, 0.2, m, x\n#EOH"), "a.gef");
  EXPECT_EQ(r.predrilled_depth, 0.2);
  EXPECT_EQ(remark(r, "second measurementvar").done, "the last one counts");
  const Recording voids =
      recording(with(with(text, "1.300", "-999"), "#COLUMNSEP", "#COLUMNVOID= 2, -999\n#COLUMNSEP"), "a.gef");
  EXPECT_TRUE(std::isnan(voids.readings[1].q_c)) << "both voids count";
}

TEST(ForeignRepeats, GeotechRowsBehindTheEndAreSetAside) {
  const std::string text = made(Format::geotech);
  const std::string row = "D=0.700,QC=1.0\n";
  for (const std::string& more : {row, "#\n" + row, text, std::string("$\nHK=2\n#\nQC=1,D=0.7\n")}) {
    const Recording r = recording(text + more, "a.cpt");
    EXPECT_EQ(r.readings.size(), 6U) << more;
    ASSERT_EQ(r.set_aside.size(), 1U) << more;
    EXPECT_EQ(r.rows_read, 6 + r.set_aside[0].lines.rows) << more;
  }
  expect_made(recording(with(text, "D=0.540", "#\nD=0.540"), "a.cpt"));
}

TEST(ForeignRepeats, AGeotechKeyTwiceInARowIsRefused) {
  expect_has(refusal(with(made(Format::geotech), "QC=1.350", "QC=1.350,QC=1.5"), "a.cpt"),
             "a.cpt:6:18: error: found a second 'QC'");
}

TEST(ForeignRepeats, NamesOfACsvAgainAreRefused) {
  const std::string text = made(Format::csv);
  expect_has(refusal(text + text, "a.csv"), "a.csv:10:1: error: found the line of names again");
  expect_has(refusal(with(text, "f_s_kPa", "q_c_MPa"), "a.csv"), "2 columns named 'q_c_MPa'");
}

TEST(ForeignTables, CommasBetweenFieldsAndInThem) {
  const std::string names = "depth_m,q_c_MPa\n";
  // Quoted, as spreadsheets write them.
  const Recording r = recording(names + "\"0,50\",\"12,5\"\n\"0,52\",\"13,5\"\n", "a.csv");
  EXPECT_NEAR(r.readings[0].q_c, 12.5e6, 1e-3);
  expect_has(refusal(names + "0,50,12,5\n", "a.csv"), "a.csv:2:1: error: found 4 fields");
  expect_has(refusal(names + "0,12,5\n", "a.csv"), "decimal commas");
  expect_has(refusal(names + "12,5,\n", "a.csv"), "a.csv:2:1: error: found 3 fields");
  // Names of rows, as R writes them, have no name of their own.
  expect_has(refusal("depth_m,q_c_MPa\n\"1\",0.5,1.2\n", "a.csv"), "rows names without a column name?");
  EXPECT_EQ(recording("sep=;\ndepth_m;q_c_MPa;;\n0.5;1.2;;\n", "a.csv").readings.size(), 1U);
  const Recording index = recording(",depth_m,q_c_MPa\n0,0.5,1.2\n1,0.6,1.3\n", "a.csv");
  EXPECT_NEAR(index.readings[1].q_c, 1.3e6, 1e-3);
  EXPECT_EQ(remark(index, "one without a name").done, "not read");
}

TEST(ForeignTables, HugeAndWordedVoids) {
  const ReadOptions huge{.format = {}, .columns = {}, .voids = {1e30, -9999.0}, .push = {}};
  const Recording r = recording(
      "depth_m,q_c_MPa,f_s_kPa\n1,1e30,5\n2,1.2,1.0E+030\n3,1.3,NULL\n4,1.4,-9999.0\n", "a.csv", huge);
  EXPECT_TRUE(std::isnan(r.readings[0].q_c));
  EXPECT_EQ(remark(r, "f_s is void").lines.rows, 3);
  expect_has(refusal("depth_m,q_c_MPa\n1,1e30\n", "a.csv"), "perhaps a void that is not declared");
}

TEST(ForeignFacts, WhatIsNotKnownIsOneRemark) {
  const Recording csv = recording("# predrilled_m = -\n# elevation_m = 1,25\n" + made(Format::csv), "a.csv");
  expect_made(csv);
  EXPECT_EQ(csv.elevation, 1.25);
  expect_has(remark(csv, "no number where the header").found, "predrilled_m '-'");
  const Recording geotech = recording(with(made(Format::geotech), "MA=0.8", "MA=0,85,HO=-,MC=?"), "a.cpt");
  expect_made(geotech);
  EXPECT_EQ(geotech.area_quotient, 0.85);
  EXPECT_TRUE(std::isnan(geotech.predrilled_depth));
  expect_has(remark(geotech, "no number where the header").found, "HO '-', MC '?'");
}

}  // namespace
}  // namespace cpt::recordings

// Formats are found by content first, then by ending; what is of no format is told. Data sets.
#include "recordings/data_set.hpp"
#include "tests/recordings/files.hpp"

namespace cpt::recordings {
namespace {

TEST(ReadRecording, ContentGoesBeforeEnding) {
  const Recording r = recording(corpus("plain.gef"), "a.cpt");
  EXPECT_EQ(r.format, "GEF-CPT");
  expect_has(remark(r, "the ending .cpt").done, "GEF-CPT");
  EXPECT_EQ(recording(corpus("stops.cpt"), "no_ending").format, "Geotech CPT");
}

TEST(ReadRecording, AllLineEndsAndAByteOrderMarkAreFine) {
  std::string text = corpus("plain.gef");
  for (const char* end : {"\r\n", "\r"}) {
    std::string other = "\xEF\xBB\xBF";
    for (const char c : text) other += c == '\n' ? std::string(end) : std::string(1, c);
    EXPECT_EQ(recording(other, "a.gef").readings[4].line, 27);
  }
}

TEST(ReadRecording, WhatCannotBeReadIsTold) {
  expect_has(refusal("hello\n", "a.doc"), "a file of unknown format");
  expect_has(refusal(std::string("\xFF\xFE\0\0#\0\0\0", 8), "a.gef"), "UTF-32");
}

TEST(ReadRecording, ErrorsAreToldUpToALimit) {
  std::string text = "depth_m,q_c_MPa\n";
  for (int i = 0; i < 100; ++i) text += "x,y\n";
  const auto read = parse_recording(text, "a.csv");
  EXPECT_EQ(std::get<1>(read).size(), Problems::at_most);
}

TEST(Spread, IgnoresVoids) {
  const Spread s = spread({3.0, not_given, 1.0, 2.0, 10.0});
  EXPECT_EQ(s.values, 4);
  EXPECT_EQ(s.min, 1.0);
  EXPECT_EQ(s.median, 2.5);
  EXPECT_EQ(s.max, 10.0);
  EXPECT_EQ(spread({not_given}).values, 0);
}

TEST(DataSet, EveryProblemIsNamedWithItsSounding) {
  Sounding sound{.recording = from_corpus("plain.gef"),
                 .sigma_v0 = 50e3,
                 .sigma_h0 = 25e3,
                 .D_r = 0.35,
                 .x = 0.0,
                 .y = 0.0,
                 .push_order = 1};
  EXPECT_TRUE(problems({"one", {sound}}).empty());
  EXPECT_EQ(problems({"none", {}}).size(), 1U);
  Sounding bad = sound;
  bad.sigma_v0 = not_given;
  bad.D_r = 35.0;
  bad.push_order = 0;
  const std::vector<std::string> found = problems({"two", {sound, bad}});
  ASSERT_EQ(found.size(), 3U);
  expect_has(found[0], "sounding 2 (A1): sigma_v0 is nan kPa, must be 0 to");
  expect_has(found[1], "D_r is 3500 %");
  expect_has(found[2], "push order is 0");
  EXPECT_EQ(problems({"twice", {sound, sound}}).size(), 1U);
}

}  // namespace
}  // namespace cpt::recordings

// Recordings that others have published, read from the folder that CPT_RECORDINGS names: what their authors
// and their headers say of them must come out. Where to get them: docs/recordings.md.
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "recordings/inclination.hpp"
#include "recordings/interpretation.hpp"
#include "tests/recordings/files.hpp"

namespace cpt::recordings {
namespace {

int odd_readings(const Interpretation& it) {
  int readings = 0;
  for (const OddSpeed& run : it.odd_speeds) readings += run.readings;
  return readings;
}

class PublishedRecording : public testing::Test {
 protected:
  // Skips the test where the file is not at hand.
  void read(const std::string& name, const ReadOptions& options = {}) {
    const char* folder = std::getenv("CPT_RECORDINGS");
    if (folder == nullptr) GTEST_SKIP() << "CPT_RECORDINGS does not name a folder of recordings";
    const std::filesystem::path file = std::filesystem::path(folder) / name;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "CPT_RECORDINGS has no " << name;
    const RecordingOrErrors result = parse_recording(bytes_of(file), file, options);
    ASSERT_EQ(result.index(), 0U) << format(std::get<1>(result));
    r = std::get<Recording>(result);
    ASSERT_EQ(static_cast<std::size_t>(r.rows_read), r.readings.size()) << "nothing to set aside";
  }
  [[nodiscard]] Spread of(double Reading::*quantity) const { return spread(column(r, quantity)); }
  [[nodiscard]] long stops() const {
    return std::count_if(r.readings.begin(), r.readings.end(),
                         [](const Reading& reading) { return reading.after_stop; });
  }
  Recording r;
};

TEST_F(PublishedRecording, DeLangeChamberWithClayLayers) {
  read("delange_layers80mm_CPT40True.csv", {.format = {},
                                            .columns = {{"depth_m", "z_m"}, {"q_c_MPa", "qc_measured_MPa"}},
                                            .voids = {},
                                            .push = {}});
  if (IsSkipped()) return;
  ASSERT_EQ(r.readings.size(), 689U);
  EXPECT_NEAR(r.readings.front().depth, 0.011, 1e-12);
  EXPECT_NEAR(r.readings.back().depth, 0.699, 1e-12);
  for (std::size_t i = 1; i < r.readings.size(); ++i)
    EXPECT_NEAR(r.readings[i].depth - r.readings[i - 1].depth, 0.001, 1e-9);
  EXPECT_LT(of(&Reading::q_c).max, 4.13e6);  // of homogeneous sand: never reached between the layers
  // Resistance is less in each clay layer than in the sand above it.
  const auto mean = [&](double from, double to) {
    double sum = 0.0;
    int count = 0;
    for (const Reading& reading : r.readings)
      if (reading.depth >= from && reading.depth <= to) sum += reading.q_c, ++count;
    return sum / count;
  };
  EXPECT_LT(mean(0.20, 0.24), mean(0.12, 0.16));
  EXPECT_LT(mean(0.36, 0.40), mean(0.29, 0.31));
  EXPECT_LT(mean(0.52, 0.56), mean(0.45, 0.47));
  EXPECT_EQ(remark(r, "median q_c").lines.rows, -1);
}

TEST_F(PublishedRecording, GefWithNegativeCorrectedDepth) {
  read("pygef_example.gef");
  if (IsSkipped()) return;
  EXPECT_EQ(r.id, "S04");
  EXPECT_EQ(r.rows_read, 1484);
  EXPECT_EQ(r.predrilled_depth, 6.0);
  EXPECT_NEAR(r.q_c_zero.before, 17.607315e6, 1.0);
  EXPECT_NEAR(r.q_c_zero.after, 17.520407e6, 1.0);
  EXPECT_EQ(remark(r, "depth is negative").lines.rows, 1183);
  EXPECT_EQ(remark(r, "q_c is void").lines.rows, 301);
  EXPECT_EQ(remark(r, "predrilled").lines.rows, 300);
  EXPECT_EQ(remark(r, "promises 1526 rows").lines.rows, 0);
  EXPECT_EQ(remark(r, "unit of f_s").done, "read as MPa");
  EXPECT_NEAR(r.readings.back().depth, 29.481, 1e-9);
  EXPECT_NEAR(r.readings.back().length, 29.66, 1e-9);
  EXPECT_GE(stops(), 25) << "a rod each metre";
  EXPECT_EQ(of(&Reading::u_2).values, 0);
  // A clock of whole seconds, steps of 10 and 20 mm.
  const Interpretation it = interpret(r);
  EXPECT_EQ(it.speed.source, SpeedSource::from_time);
  EXPECT_NEAR(spread(it.speed.speed).median, 0.024, 0.001);
  EXPECT_EQ(it.why_not_corrected, "the recording has no u_2");
}

TEST_F(PublishedRecording, GefInclinedBySeventeenDegrees) {
  read("pygef_cpt_class_high.gef");
  if (IsSkipped()) return;
  EXPECT_EQ(r.depth_rule, DepthRule::stated);
  EXPECT_NEAR(r.readings.back().length, 30.30, 1e-9);
  EXPECT_NEAR(r.readings.back().depth, 29.817, 1e-9);
  EXPECT_NEAR(of(&Reading::inclination).max, 16.96 * std::numbers::pi / 180.0, 1e-9);
  EXPECT_EQ(remark(r, "f_s is void").lines.rows, 5);
  // Had the file no corrected depth, ours would come to within 5 mm of it.
  const std::string text =
      bytes_of(std::filesystem::path(std::getenv("CPT_RECORDINGS")) / "pygef_cpt_class_high.gef");
  const Recording own = recording(with(text, "diepte, 11", "diepte, 999"), "own.gef");
  EXPECT_EQ(own.depth_rule, DepthRule::from_inclination);
  for (std::size_t i = 0; i < own.readings.size(); ++i)
    EXPECT_NEAR(own.readings[i].depth, r.readings[i].depth, 5e-3);
}

TEST_F(PublishedRecording, GefWithRowsAboveThePredrilledDepth) {
  read("pygef_cpt2.gef");
  if (IsSkipped()) return;
  EXPECT_EQ(r.rows_read, 1039);
  const Remark predrilled = remark(r, "predrilled depth of 2 m");
  EXPECT_NEAR(predrilled.lines.rows, 200, 1);
  expect_has(predrilled.why, "hold a q_c");
  EXPECT_EQ(r.readings[0].depth, 0.0);
  EXPECT_NEAR(remark(r, "lets the push end at 10.46 m").lines.rows, 0, 0);
  EXPECT_NEAR(r.q_c_zero.drift, -8860.0, 1.0);
}

TEST_F(PublishedRecording, TillerClayWithRodChanges) {
  read("tiller_TILC57.cpt");
  if (IsSkipped()) return;
  EXPECT_EQ(r.predrilled_depth, 4.0);
  EXPECT_EQ(r.rows_read, 802);
  EXPECT_NEAR(of(&Reading::speed).median, 0.020, 0.0015);
  expect_has(remark(r, "stood still").found, "9 times");
  expect_has(remark(r, "stood still").found, "5.74, 7.74, 9.74");
  EXPECT_EQ(of(&Reading::u_2).values, 802);
  EXPECT_NEAR(r.q_c_zero.drift, 5400.0, 1.0);
  // Clay below a crust of sand, pushed at standard speed.
  const Interpretation it = interpret(r);
  EXPECT_TRUE(it.corrected);
  EXPECT_EQ(it.intervals.front().zone, 6);
  EXPECT_EQ(it.intervals.back().zone, 3);
  EXPECT_GT(it.intervals.back().to - it.intervals.back().from, 10.0);
  EXPECT_LT(odd_readings(it), 10);
}

TEST_F(PublishedRecording, HalsenSiltWithItsDates) {
  read("halsen_HALS12.cpt");
  if (IsSkipped()) return;
  EXPECT_EQ(r.rows_read, 1680);
  EXPECT_NEAR(of(&Reading::speed).median, 0.010, 0.001);
  // 11:11:54.002 to 11:49:15.748 of one day
  EXPECT_NEAR(of(&Reading::time).max - of(&Reading::time).min, 2241.746, 1e-3);
  EXPECT_NEAR(r.u_2_zero.drift, -86.6e3, 1.0);
  // Pushed at half the standard speed on purpose.
  const Interpretation it = interpret(r);
  EXPECT_GT(odd_readings(it), 1600);
  EXPECT_TRUE(std::any_of(it.spikes.begin(), it.spikes.end(), [&](const Spike& spike) {
    return spike.quantity == "u_2" && r.readings[spike.reading].line == 1377;
  })) << "1788.9 kPa between 311 and 311";
}

TEST_F(PublishedRecording, OysandSand) {
  read("oysand_OYSC64_1.cpt");
  if (IsSkipped()) return;
  EXPECT_EQ(r.id,
            "\u00F8"
            "64");
  EXPECT_EQ(r.predrilled_depth, 8.0);
  EXPECT_EQ(r.rows_read, 282);
  EXPECT_EQ(
      std::count_if(r.readings.begin(), r.readings.end(), [](const Reading& x) { return x.predrilled; }), 0);
}

}  // namespace
}  // namespace cpt::recordings

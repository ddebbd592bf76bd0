// Tables of samples made elsewhere.
#include "parameters/read_samples.hpp"

#include <cmath>
#include <random>

#include "recordings/delimited.hpp"
#include "tests/fuzz/mutation.hpp"
#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

const std::string text =
    "profile = \"homogeneous_sand\"\npreset = \"quick\"\n"
    "[parameters]\n\"sand.H\" = { baseline = 25, upper = 75 }\n"
    "[[windows]]\nname = \"deep\"\nfrom_m = 0.5054\nto_m = 0.5255\n"
    "[[windows]]\nname = \"top\"\ncentre = \"baseline_peak\"\nbetween_m = [0.1, 0.2]\nwidth_m = 0.01\n";

FieldTable table_of(const std::string& csv) {
  recordings::Problems problems("a.csv");
  const recordings::DelimitedTable read = recordings::read_delimited(csv, problems);
  EXPECT_FALSE(problems.any()) << recordings::format(problems.errors());
  FieldTable table{"a.csv", "a", {}, {}};
  for (const auto& field : read.names) table.names.push_back({field.text, {field.line, field.column}});
  for (const auto& row : read.rows) {
    auto& fields = table.rows.emplace_back();
    for (const auto& field : row) fields.push_back({field.text, {field.line, field.column}});
  }
  return table;
}

std::vector<Sample> samples_of(const std::string& csv, const SampleColumns& columns = {}) {
  const SamplesOrErrors read = read_samples(table_of(csv), study_of(text), columns);
  if (const auto* errors = std::get_if<1>(&read)) {
    ADD_FAILURE() << format(*errors);
    return {};
  }
  return std::get<0>(read);
}

std::string refusal(const std::string& csv, const SampleColumns& columns = {}) {
  const SamplesOrErrors read = read_samples(table_of(csv), study_of(text), columns);
  if (const auto* errors = std::get_if<1>(&read)) return format(*errors);
  ADD_FAILURE() << csv << " was read";
  return {};
}

void expect_has(const std::string& all, const std::string& part) {
  EXPECT_NE(all.find(part), std::string::npos) << "'" << part << "' is not in:\n" << all;
}

TEST(ReadSamples, InputsAveragesAndNames) {
  const auto samples = samples_of(
      "name,sand.H,chamber.wall,deep.q_c_mean_kPa,deep.q_c_max_kPa,reason\n"
      "a,30,rigid,1234.5,1300,\nb,+4e1,flexible,,,it broke\n");
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].name, "a");
  ASSERT_EQ(samples[0].changes.size(), 2U);
  EXPECT_EQ(samples[0].changes[0].quantity->name, "sand.H");
  EXPECT_EQ(samples[0].changes[0].value, 30.0);
  EXPECT_EQ(samples[0].changes[1].quantity->format(samples[0].changes[1].value), "rigid");
  EXPECT_EQ(samples[0].status, "completed");
  EXPECT_EQ(samples[0].responses[0].mean, 1234.5);
  EXPECT_EQ(samples[0].responses[0].max, 1300.0);
  EXPECT_TRUE(std::isnan(samples[0].responses[0].min));
  EXPECT_TRUE(std::isnan(samples[0].responses[1].mean));
  EXPECT_EQ(samples[1].changes[0].value, 40.0);
  EXPECT_EQ(samples[1].status, "crashed");
  EXPECT_EQ(samples[1].reason, "it broke");
}

TEST(ReadSamples, DakotasTableWithItsOwnNames) {
  SampleColumns columns;
  columns.names = {{"sand.H", "x1"}, {"deep.q_c_mean_kPa", "y1"}};
  columns.ignored = {"y2"};
  const auto samples =
      samples_of("%eval_id interface x1 y1 y2\n1 NO_ID 30 1234.5 7\n5 NO_ID 35 NaN NaN\n", columns);
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].name, "eval 1");
  EXPECT_EQ(samples[0].responses[0].mean, 1234.5);
  EXPECT_EQ(samples[1].name, "eval 5");
  EXPECT_EQ(samples[1].status, "crashed");
  EXPECT_FALSE(samples[1].reason.empty());
}

TEST(ReadSamples, OfPointsOnlyInputsAndNamesAreRead) {
  SampleColumns columns;
  columns.responses = false;
  const auto samples = samples_of("sand.H,status,top.q_c_mean_kPa\n30,x,y\n", columns);
  ASSERT_EQ(samples.size(), 1U);
  EXPECT_EQ(samples[0].name, "row 1");
  EXPECT_EQ(samples[0].changes.size(), 1U);
  // A misspelt input must not run as the baseline's.
  expect_has(refusal("sand.N,sand.h\n0.2,30\n", columns), "did you mean sand.H?");
}

TEST(ReadSamples, UnknownColumnsAreToldWithTheNearest) {
  const std::string said = refusal("sand.h_,deep.q_c_mean_kpa,deep.q_c_mean_kPa\n1,2,3\n");
  expect_has(said, "a.csv:1:1: error: sand.h_: is neither a quantity nor an average");
  expect_has(said, "a.csv:1:9: error: deep.q_c_mean_kpa");
  expect_has(said, "did you mean deep.q_c_mean_kPa?");
  expect_has(said, "--ignore deep.q_c_mean_kpa leaves it out");
  expect_has(refusal("sand.h,deep.q_c_mean_kPa\n1,2\n"), "did you mean sand.H?");
}

TEST(ReadSamples, ColumnsMustFit) {
  SampleColumns columns;
  columns.names = {{"sand.H", "x1"}};
  expect_has(refusal("sand.H,x1,deep.q_c_mean_kPa\n1,2,3\n", columns),
             "x1: says the same as the column sand.H");
  expect_has(refusal("sand.H,deep.q_c_mean_kPa\n1,2\n", columns), "x1: there is no such column");
  columns = {};
  columns.ignored = {"x"};
  expect_has(refusal("sand.H,deep.q_c_mean_kPa\n1,2\n", columns), "x: there is no such column to leave out");
  expect_has(refusal("sand.H\n30\n"), "no column is an average of q_c");
  expect_has(refusal("deep.q_c_mean_kPa\n30\n"), "no column is an input");
  expect_has(refusal("sand.H,deep.q_c_mean_kPa\n"), "has no rows");
  expect_has(refusal("sand.H,top.q_c_mean_kPa,deep.q_c_mean_kPa\n30,1,2\n"),
             "placed by the baseline's curve");
}

TEST(ReadSamples, ValuesAreCheckedAsAStudysAre) {
  const auto row = [](const std::string& cells) {
    return refusal("name,sand.D_r_percent,chamber.wall,deep.q_c_mean_kPa\n" + cells + "\n");
  };
  expect_has(row("a,300,rigid,1"), "a.csv:2:3: error: sand.D_r_percent: 300 is outside the valid range");
  expect_has(row("a,nan,rigid,1"), "has no value");
  expect_has(row("a,inf,rigid,1"), "must be a finite number");
  expect_has(row("a,loose,rigid,1"), "sand.D_r_percent: must be a number, not the text \"loose\"");
  expect_has(row("a,30,rigd,1"), "did you mean \"rigid\"?");
  expect_has(row("a,30,rigid,inf"), "a.csv:2:12: error: deep.q_c_mean_kPa: \"inf\" is not a finite number");
  expect_has(row("a,30,rigid,\"1,5\""), "decimals follow a point");
  expect_has(row("a,30,rigid,1\na,31,rigid,1"), "a.csv:3:1: error: name: \"a\" names row 1 already");
  expect_has(refusal("clay.s_u_kPa,deep.q_c_mean_kPa\n30,1\n"), "the profile has no clay");
}

// What tables from elsewhere may hold: read rightly or refused with the place, never in part.
TEST(ReadSamples, NumbersWrittenOtherwiseAreReadOrRefused) {
  const auto read = [](const std::string& H, const std::string& q_c) {
    const auto samples = samples_of("sand.H;deep.q_c_mean_kPa\n" + H + ";" + q_c + "\n");
    return samples.empty() ? std::pair(0.0, 0.0)
                           : std::pair(samples[0].changes[0].value, samples[0].responses[0].mean);
  };
  for (const char* thirty : {"30", "+30", "30.0", "3e1", "3.0D+01", "0.3d2"}) {
    EXPECT_EQ(read(thirty, "1").first, 30.0) << thirty;
    EXPECT_EQ(read("30", thirty).second, 30.0) << thirty;
  }
  EXPECT_EQ(read("30",
                 "\xE2\x88\x92"
                 "2.5")
                .second,
            -2.5);
  const std::pair<const char*, const char*> refused[] = {
      {"30,5", "decimals follow a point, not a comma: 30.5"},
      {"1 030", "thousands are not set apart: 1030"},
      {"1'030.5", "thousands are not set apart: 1030.5"},
      {"30 kPa", "the number alone, without a unit: 30"},
      {"+-30", ""},
      {"--30", ""},
      {"30-5", ""},
      {"30\x1A", ""},
      {"30\xE2\x80\x93"
       "5",
       ""}};
  for (const auto& [written, hint] : refused) {
    const std::string input = refusal("sand.H;deep.q_c_mean_kPa\n25;1\n" + std::string(written) + ";2\n");
    expect_has(input, "a.csv:3:1: error: sand.H: must be a number, not the text");
    expect_has(input, hint);
    const std::string average = refusal("sand.H;deep.q_c_mean_kPa\n25;1\n30;" + std::string(written) + "\n");
    expect_has(average, "a.csv:3:4: error: deep.q_c_mean_kPa: ");
    expect_has(average, hint);
  }
}

TEST(ReadSamples, TheLineOfNamesAgainIsRefused) {
  expect_has(refusal("sand.H,deep.q_c_mean_kPa\n30,1\nsand.H,deep.q_c_mean_kPa\n40,2\n"),
             "a.csv:3:1: error: the line of names stands here again");
}

// As pandas writes its index.
TEST(ReadSamples, AColumnWithoutANameIsRefusedWithItsPlace) {
  recordings::Problems problems("a.csv");
  (void)recordings::read_delimited(",sand.H,deep.q_c_mean_kPa\n0,30,1\n", problems);
  ASSERT_TRUE(problems.any());
  expect_has(recordings::format(problems.errors()), "a.csv:1:1: error: found a column without a name");
  expect_has(refusal("Unnamed: 0,sand.H,deep.q_c_mean_kPa\n0,30,1\n"), "--ignore Unnamed: 0 leaves it out");
}

TEST(ReadSamples, AUnitWrittenInAnotherWayIsAnotherColumn) {
  expect_has(refusal("sand.D_r (%),deep.q_c_mean_kPa\n30,1\n"), "did you mean sand.D_r_percent?");
  expect_has(refusal("initial.sigma_v0_MPa,deep.q_c_mean_kPa\n30,1\n"), "did you mean initial.sigma_v0_kPa?");
  expect_has(refusal("sand.H,deep.q_c_mean_MPa\n30,1\n"), "did you mean deep.q_c_mean_kPa?");
}

TEST(ReadSamples, StatusAndAveragesMustAgree) {
  const auto row = [](const std::string& cells) {
    return refusal("sand.H,status,deep.q_c_mean_kPa,deep.q_c_min_kPa\n" + cells + "\n");
  };
  expect_has(row("30,crashed,5,"), "only a completed one has");
  expect_has(row("30,complete,5,"), "did you mean \"completed\"?");
  expect_has(row("30,completed,5,6"), "does not lie between");
  expect_has(row("30,completed,,6"), "does not lie between");
  EXPECT_EQ(samples_of("sand.H,status,deep.q_c_mean_kPa\n30,running,\n").front().status, "pending");
}

TEST(ReadSamples, PointsOfAStudyRunThem) {
  const auto samples = samples_of(
      "name,sand.H,chamber.wall,deep.q_c_mean_kPa\n\"a \"\"b\"\"\",30.1,flexible,1\nc,1e1,rigid,2\n");
  const Study study = study_of(with_points(text, samples));
  ASSERT_EQ(study.points.size(), 2U);
  EXPECT_EQ(study.points[0].name, "a \"b\"");
  EXPECT_EQ(study.points[0].changes[0].value, 30.1);
  EXPECT_EQ(study.points[1].changes[1].quantity->format(study.points[1].changes[1].value), "rigid");
}

const std::vector<std::string> fragments = {"\n",     ",",           "\"",    "\"\"",
                                            "nan",    "-inf",        "1e308", "-0",
                                            "1e-320", "\xff",        "\r",    "#",
                                            " ",      "\t",          ";",     "%eval_id ",
                                            "sand.H", "crashed",     "name",  "99999999999999999999",
                                            "rigid",  "\xEF\xBB\xBF"};

TEST(ReadSamples, DamagedTablesAreReadOrRefusedWithAReason) {
  const Study study = study_of(text);
  std::mt19937 random(20240513);
  int sound = 0, refused = 0;
  for (const std::string original :
       {"name,sand.H,chamber.wall,deep.q_c_mean_kPa,status,reason\na,30,rigid,1234.5,completed,\n"
        "\"b \"\"x\"\"\",40,flexible,,crashed,\"it, broke\"\nc,50,rigid,2000.25,,\n",
        "%eval_id interface sand.H deep.q_c_mean_kPa\n1 NO_ID 30 1000\n2 NO_ID 40 NaN\n3 NO_ID 50 3000\n"})
    for (int i = 0; i < 1500; ++i) {
      const std::string damaged = fuzz::mutated(original, fragments, random);
      recordings::Problems problems("a.csv");
      const auto content = recordings::decoded(damaged);
      const recordings::DelimitedTable read = recordings::read_delimited(content.text, problems);
      if (problems.any()) continue;
      FieldTable table{"a.csv", "a", {}, {}};
      for (const auto& field : read.names) table.names.push_back({field.text, {field.line, field.column}});
      for (const auto& row : read.rows) {
        auto& fields = table.rows.emplace_back();
        for (const auto& field : row) fields.push_back({field.text, {field.line, field.column}});
      }
      const SamplesOrErrors result = read_samples(table, study, {});
      if (const auto* samples = std::get_if<0>(&result)) {
        ++sound;
        EXPECT_EQ(samples->size(), table.rows.size());
        for (const Sample& sample : *samples) {
          EXPECT_FALSE(sample.name.empty());
          EXPECT_FALSE(sample.status.empty());
          for (const Change& change : sample.changes) {
            EXPECT_GE(change.value, change.quantity->choices.empty() ? change.quantity->min : 0.0);
            EXPECT_TRUE(std::isfinite(change.value));
          }
          EXPECT_FALSE(std::isinf(sample.responses[0].mean));
        }
        (void)parse_study(with_points(text, *samples), "/studies/a.toml");
      } else {
        ++refused;
        EXPECT_FALSE(std::get<1>(result).empty());
      }
      ASSERT_FALSE(HasFailure()) << "mutation " << i << ":\n" << damaged;
    }
  EXPECT_GT(sound, 150);
  EXPECT_GT(refused, 150);
}

}  // namespace
}  // namespace cpt::parameters

#include "diagnosis/read_request.hpp"

#include <fstream>
#include <iterator>

#include "tests/diagnosis/request_fixture.hpp"

namespace cpt::diagnosis {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

recordings::RecordingOrErrors recording_of(const SoundingRequest& sounding) {
  return recordings::parse_recording(text_of(sounding.recording), sounding.recording, sounding.options);
}

TEST(ReadRequest, DefaultsAndWhatIsWritten) {
  const Request plain = request_of("study = \"sand.toml\"\n" + sounding);
  EXPECT_EQ(plain.name, "d");
  EXPECT_EQ(plain.database, "/requests/d.sqlite");
  EXPECT_GE(plain.mechanisms.size(), 9U);  // all of sand
  ASSERT_EQ(plain.soundings.size(), 1U);
  EXPECT_EQ(plain.soundings[0].recording, "/requests/first.csv");
  EXPECT_EQ(plain.soundings[0].name, "first");

  const Request full = request_of(
      "title = \"T\"\nstudy = \"sand.toml\"\nmechanisms = [\"density_lens\", \"worn_cone\"]\n"
      "[noise]\nmeasurement_percent = 2\ncorrelation_mm = 20\nsimulated = true\n[options]\ncell_mm = "
      "4\nrepeats = 5\n" +
      sounding +
      "name = \"one\"\ncolumns = { depth_m = \"z\", q_c_MPa = \"q\" }\nfixed = { \"initial.sigma_v0_kPa\" = "
      "60 }\n");
  EXPECT_EQ(full.title, "T");
  ASSERT_EQ(full.mechanisms.size(), 2U);
  EXPECT_EQ(full.mechanisms[1].name, "worn_cone");
  EXPECT_DOUBLE_EQ(full.measurement, 0.02);
  EXPECT_DOUBLE_EQ(full.correlation, 0.02);
  EXPECT_TRUE(full.simulated);
  EXPECT_DOUBLE_EQ(full.cell_height, 0.004);
  EXPECT_EQ(full.repeats, 5);
  EXPECT_EQ(full.soundings[0].options.columns.size(), 2U);
  ASSERT_EQ(full.soundings[0].changes.size(), 1U);
  EXPECT_EQ(full.soundings[0].changes[0].value, 60.0);
}

// Between the soundings' depths, 40 and 280 mm, whatever the catalogue's range is.
TEST(ReadRequest, ALensIsLookedForAtTheDepthsCompared) {
  const Request request =
      request_of("study = \"sand.toml\"\nmechanisms = [\"density_lens\", \"worn_cone\"]\n" + sounding);
  ASSERT_EQ(request.mechanisms.size(), 2U);
  int places = 0;
  for (const solver::MechanismParameter& parameter : request.mechanisms[0].parameters) {
    if (parameter.prior != solver::Prior::depth) continue;
    ++places;
    EXPECT_DOUBLE_EQ(parameter.prior_lower, 40.0);
    EXPECT_DOUBLE_EQ(parameter.prior_upper, 280.0);
  }
  EXPECT_EQ(places, 1);
}

// 35 kPa instead of class 2's 100.
TEST(ReadRequest, ConesOfAnotherClassHaveOtherFaults) {
  const std::string text =
      "study = \"sand.toml\"\nmechanisms = [\"zero_offset\", \"gain_drift\"]\n" + sounding;
  const Request plain = request_of(text), precise = request_of(text + "[noise]\ncone_class = 1\n");
  EXPECT_DOUBLE_EQ(plain.mechanisms[0].parameters[0].prior_upper, 400.0);
  EXPECT_DOUBLE_EQ(precise.mechanisms[0].parameters[0].prior_upper, 140.0);
  EXPECT_DOUBLE_EQ(precise.mechanisms[0].parameters[0].prior_lower, -140.0);
  EXPECT_EQ(precise.mechanisms[1].parameters[0].prior_upper, plain.mechanisms[1].parameters[0].prior_upper);
  for (const std::string wrong : {"0", "5", "1.5", "\"two\""}) {
    const auto errors = errors_of(text + "[noise]\ncone_class = " + wrong + "\n");
    ASSERT_EQ(errors.size(), 1U) << wrong;
    EXPECT_EQ(errors[0].key, "noise.cone_class") << wrong;
  }
}

TEST(ReadRequest, CandidatesAreSoundingsWithoutRecording) {
  const std::string study = "study = \"sand.toml\"\n" + sounding;
  const std::string candidate =
      "[[candidates]]\nname = \"deeper\"\nfrom_m = 0.04\nto_m = 0.25\nfixed = { \"initial.sigma_v0_kPa\" = "
      "90 }\n";
  const Request request = request_of(study + candidate);
  ASSERT_EQ(request.candidates.size(), 1U);
  EXPECT_EQ(request.candidates[0].name, "deeper");
  EXPECT_EQ(request.candidates[0].changes.size(), 1U);
  EXPECT_EQ(request.soundings.size(), 1U);
  const auto errors = errors_of(study + candidate + "recording = \"a.csv\"\n");
  ASSERT_FALSE(errors.empty());
  EXPECT_EQ(errors.front().key, "candidates.recording");
}

TEST(ReadRequest, NamesTheStudyBesideItself) {
  EXPECT_EQ(study_of_request("study = \"../s/sand.toml\"\n", "/requests/a/d.toml"), "/requests/s/sand.toml");
  EXPECT_TRUE(study_of_request("title = \"no study\"\n", "/d.toml").empty());
  EXPECT_TRUE(study_of_request("not toml at all [", "/d.toml").empty());
}

// 0.088 - 0.038 and its like fall short of 10 times 0.005 by rounding.
TEST(ReadRequest, AnIntervalOfTenCellsIsTenCellsWhateverTheRounding) {
  int rounded_down = 0;
  for (int from = 30; from <= 240; ++from) {
    const int to = from + 50;
    rounded_down += to / 1000.0 - from / 1000.0 < 10.0 * 0.005 ? 1 : 0;
    const std::string toml = "study = \"sand.toml\"\n[[soundings]]\nrecording = \"a.csv\"\nfrom_m = 0." +
                             std::string(from < 100 ? "0" : "") + std::to_string(from) + "\nto_m = 0." +
                             std::string(to < 100 ? "0" : "") + std::to_string(to) + "\n";
    EXPECT_TRUE(errors_of(toml).empty()) << toml;
  }
  EXPECT_GT(rounded_down, 20);  // so that this would fail without the tolerance
  EXPECT_EQ(errors_of("study = \"sand.toml\"\n[[soundings]]\nrecording = \"a.csv\"\nfrom_m = 0.04\nto_m = "
                      "0.08999\n")
                .size(),
            1U);
}

// What is wrong with a request is told even where its study cannot be read.
TEST(ReadRequest, WhatDoesNotHangOnTheStudyIsToldWithoutIt) {
  const auto problems = [](const std::string& toml) {
    return request_problems(toml, "/requests/d.toml", Recordings::given);
  };
  EXPECT_TRUE(
      problems("study = \"none.toml\"\nmechanisms = [\"strain_softening\"]\n[[soundings]]\nrecording = "
               "\"a.csv\"\nfrom_m = 0.04\nto_m = 2.5\nfixed = { \"clay.s_u_kPa\" = 20 }\n")
          .empty());  // all of it may be right for that study
  const auto found = problems(
      "study = \"none.toml\"\ndepth = 3\nmechanisms = [\"lens\"]\n[options]\nrepeats = "
      "1\nseed = 1.5\n[[soundings]]\nrecording = \"a.csv\"\nfrom_m = 0.01\nto_m = 0.2\n");
  std::vector<std::string> keys;
  for (const parameters::StudyError& error : found) keys.push_back(error.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"depth", "mechanisms", "options.repeats", "options.seed",
                                            "soundings.from_m"}))
      << format(found);
  EXPECT_EQ(problems("study = \"none.toml\"\ncell = 0,5\n").size(), 1U);
  // Which soils a study has that cannot be read is not known.
  EXPECT_EQ(problems("study = \"none.toml\"\n" + sounding + "[soundings.fixed]\n\"loose.H\" = 30\n").size(),
            problems("study = \"none.toml\"\n" + sounding).size());
}

TEST(ReadRequest, ErrorsSayWhereWhatAndWhatInstead) {
  const std::string study = "study = \"sand.toml\"\n";
  struct Case {
    std::string toml, key, text;
  };
  const std::string head = "[[soundings]]\nrecording = \"a.csv\"\n";
  for (const Case& bad :
       {Case{sounding, "study", "missing"}, Case{study, "soundings", "at least one recording"},
        Case{study + "mechanisms = [\"surface_compacton\"]\n" + sounding, "mechanisms",
             "did you mean \"surface_compaction\""},
        Case{study + "mechanisms = [\"strain_softening\"]\n" + sounding, "mechanisms", "acts on nothing"},
        Case{study + "mechanisms = []\n" + sounding, "mechanisms", "is empty"},
        Case{study + "depth = 3\n" + sounding, "depth", "unknown"},
        Case{study + head + "from_m = 0.04\nto_m = 0.31\n", "soundings.to_m", "final_depth"},
        Case{study + head + "from_m = 0.04\nto_m = 0.06\n", "soundings.to_m", "10 cells"},
        Case{study + head + "from_m = 0.01\nto_m = 0.20\n", "soundings.from_m", "wished in place"},
        Case{study + head + "from_m = 0.04\nto_m = 280\n", "soundings.to_m", "below the end"},
        Case{study + sounding + "columns = { q_t_MPa = \"q\" }\n", "soundings.columns.q_t_MPa", "q_c_MPa"},
        Case{study + sounding + "fixed = { \"sand.H\" = -1 }\n", "soundings.fixed.sand.H",
             "outside the valid range"},
        // K_0 far beyond what the sand bears: known to all runs of the sounding, so told before the first.
        Case{study + sounding + "fixed = { \"initial.sigma_h0_kPa\" = 400 }\n", "soundings.fixed",
             "impossible with the study's"},
        Case{study + "[noise]\nmeasurement_percent = -1\n" + sounding, "noise.measurement_percent",
             "above 0"},
        Case{study + "[options]\nrepeats = 1\n" + sounding, "options.repeats", "from 3 to 1000"}}) {
    const auto errors = errors_of(bad.toml);
    ASSERT_EQ(errors.size(), 1U) << bad.toml << format(errors);
    EXPECT_EQ(errors.front().key, bad.key) << format(errors);
    EXPECT_NE(format(errors).find(bad.text), std::string::npos) << format(errors);
  }
}

// The request of examples/diagnosis asks for all mechanisms of sand, and its truth is one of them.
TEST(ReadRequest, TheExampleIsSound) {
  const std::filesystem::path folder = CPT_EXAMPLES "/diagnosis";
  const std::string text = text_of(folder / "compacted.toml");
  auto study = parameters::read_study(study_of_request(text, folder / "compacted.toml"));
  ASSERT_TRUE(std::holds_alternative<parameters::Study>(study));
  const auto parsed = parse_request(text, folder / "compacted.toml", std::get<parameters::Study>(study));
  ASSERT_TRUE(std::holds_alternative<Request>(parsed));
  const Request& request = std::get<Request>(parsed);
  EXPECT_GE(request.mechanisms.size(), 9U);
  const auto recording = recording_of(request.soundings[0]);
  ASSERT_TRUE(std::holds_alternative<recordings::Recording>(recording));
  EXPECT_GT(std::get<recordings::Recording>(recording).readings.size(), 500U);
  EXPECT_TRUE(
      std::holds_alternative<parameters::Study>(parameters::read_study(folder / "compacted_truth.toml")));
}

TEST(ReadRequest, TheExampleWithTwoSoundingsIsSound) {
  const std::filesystem::path file = CPT_EXAMPLES "/diagnosis/compacted_two.toml";
  const std::string text = text_of(file);
  auto study = parameters::read_study(study_of_request(text, file));
  ASSERT_TRUE(std::holds_alternative<parameters::Study>(study));
  const auto parsed = parse_request(text, file, std::get<parameters::Study>(study));
  ASSERT_TRUE(std::holds_alternative<Request>(parsed));
  const Request& request = std::get<Request>(parsed);
  ASSERT_EQ(request.soundings.size(), 2U);
  EXPECT_EQ(request.soundings[1].changes.size(), 2U);
  for (const SoundingRequest& sounding : request.soundings) {
    const auto recording = recording_of(sounding);
    ASSERT_TRUE(std::holds_alternative<recordings::Recording>(recording));
    EXPECT_GT(std::get<recordings::Recording>(recording).readings.size(), 500U);
  }
}

}  // namespace
}  // namespace cpt::diagnosis

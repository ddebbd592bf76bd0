// Damaged files of every format are read with sound values or refused with a reason; never a crash or a hang.
#include <cmath>
#include <random>
#include <vector>

#include "tests/recordings/files.hpp"

namespace cpt::recordings {
namespace {

constexpr int mutations = 6000;  // of each file

// Bytes overwritten, inserted and erased, lines repeated and dropped, the end cut off, fragments put in.
std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> fragments = {"\n",
                                                     ",",
                                                     ";",
                                                     "!",
                                                     "\"",
                                                     "\"\"",
                                                     "#",
                                                     "#EOH=\n",
                                                     "$\n",
                                                     "#$\n",
                                                     "=",
                                                     "nan",
                                                     "-inf",
                                                     "1e308",
                                                     "-1e14",
                                                     "-0",
                                                     "1e-320",
                                                     "9999",
                                                     "\xff",
                                                     "\xc3",
                                                     "\r",
                                                     " ",
                                                     "\t",
                                                     "D=",
                                                     ",F=13",
                                                     "%2",
                                                     "99999999999999999999",
                                                     "#COLUMN=500\n",
                                                     "#COLUMNSEPARATOR= !\n",
                                                     "#RECORDSEPARATOR= ;\n",
                                                     "#COLUMNINFO= 499, kPa, x, 2\n",
                                                     "#COLUMNVOID= 1, 1\n",
                                                     "\"GROUP\",\"SCPT\"\n",
                                                     "\"DATA\"\n",
                                                     "\"HEADING\",\"SCPT_RES\"\n",
                                                     "\xEF\xBB\xBF"};
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  for (std::size_t edits = 1 + below(5); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = below(text.size());
    const std::size_t line = text.rfind('\n', at) + 1;  // npos + 1 is 0
    const std::size_t end = text.find('\n', at);
    const std::size_t length = end == std::string::npos ? std::string::npos : end + 1 - line;
    switch (below(8)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, 1 + below(20));
        break;
      case 2:
      case 3:
        text.insert(at, fragments[below(fragments.size())]);
        break;
      case 4:
        text.insert(std::min(line, text.size()), text.substr(std::min(line, text.size()), length));
        break;
      case 5:
        text.erase(std::min(line, text.size()), length);
        break;
      case 6:
        if (below(4) == 0) text.resize(at);
        break;
      default:
        text.insert(at, 1, static_cast<char>('0' + below(10)));
    }
  }
  return text;
}

// What every recording promises (recording.hpp).
void expect_sound(const Recording& r) {
  std::size_t rows = r.readings.size();
  for (const SetAside& set : r.set_aside) {
    EXPECT_GT(set.lines.rows, 0);
    EXPECT_FALSE(set.reason.empty());
    rows += static_cast<std::size_t>(set.lines.rows);
  }
  EXPECT_EQ(static_cast<std::size_t>(r.rows_read), rows);
  ASSERT_FALSE(r.readings.empty());
  double depth = -1e300;
  bool measured = false;
  for (const Reading& reading : r.readings) {
    EXPECT_TRUE(std::isfinite(reading.depth));
    EXPECT_GE(reading.depth, depth);
    EXPECT_GT(reading.line, 0);
    depth = reading.depth;
    measured = measured || !std::isnan(reading.q_c);
    for (const double value : {reading.length, reading.q_c, reading.f_s, reading.u_2, reading.inclination,
                               reading.speed, reading.time})
      EXPECT_FALSE(std::isinf(value));
  }
  EXPECT_TRUE(measured);
  for (const Remark& remark : r.remarks)
    EXPECT_FALSE(remark.found.empty() || remark.done.empty() || remark.why.empty());
}

struct Original {
  const char* name;
  ReadOptions options;
};

class MutatedRecording : public testing::TestWithParam<Original> {};

TEST_P(MutatedRecording, IsReadOrRefusedWithAReason) {
  const std::string original = corpus(GetParam().name);
  expect_sound(recording(original, GetParam().name, GetParam().options));
  std::mt19937 random(20240506);
  int read = 0;
  for (int i = 0; i < mutations; ++i) {
    const std::string text = mutated(original, random);
    const RecordingOrErrors result = parse_recording(text, GetParam().name, GetParam().options);
    if (const auto* sound = std::get_if<Recording>(&result)) {
      ++read;
      expect_sound(*sound);
    } else {
      const auto& errors = std::get<1>(result);
      EXPECT_FALSE(errors.empty());
      for (const RecordingError& error : errors) {
        EXPECT_FALSE(error.file.empty() || error.found.empty() || error.expected.empty());
        EXPECT_EQ(error.line > 0, error.column > 0);
      }
    }
    ASSERT_FALSE(HasFailure()) << "mutation " << i << ":\n" << text;
  }
  EXPECT_GT(read, mutations / 50);
  EXPECT_LT(read, mutations - mutations / 50);
}

// The second push's rows damage nothing, so a push is chosen that is there once.
INSTANTIATE_TEST_SUITE_P(
    Corpus, MutatedRecording,
    testing::Values(Original{"plain.gef", {}}, Original{"odd.gef", {}},
                    Original{"two_pushes.ags", {.format = {}, .columns = {}, .voids = {}, .push = "CPT1/1"}},
                    Original{"stops.cpt", {}}, Original{"chamber.csv", chamber()}),
    [](const auto& name) {
      std::string text = name.param.name;
      std::replace(text.begin(), text.end(), '.', '_');
      return text;
    });

TEST(MutatedRecording, BytesWithoutMeaningAreRefused) {
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string text(random() % 400, '\0');
    for (char& c : text) c = static_cast<char>(random() % 256);
    for (const char* name : {"a.gef", "a.ags", "a.cpt", "a.csv", "a"})
      EXPECT_EQ(parse_recording(text, name).index(), 1U) << name;
  }
}

}  // namespace
}  // namespace cpt::recordings

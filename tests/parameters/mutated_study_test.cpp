// Damaged study files are told, never a crash or an exception.
#include <random>

#include "parameters/designs/one_at_a_time.hpp"
#include "tests/parameters/studies.hpp"

namespace cpt::parameters {
namespace {

// Bytes overwritten, inserted and erased, lines repeated and dropped, fragments of TOML put in.
std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> fragments = {"=",
                                                     "\"",
                                                     "[",
                                                     "]]",
                                                     "{",
                                                     "}",
                                                     "\n",
                                                     "nan",
                                                     "-inf",
                                                     "1e999",
                                                     "-0",
                                                     "true",
                                                     "1979-05-27",
                                                     "\xff",
                                                     "[[windows]]\n",
                                                     "[[layers]]\n",
                                                     "[fixed]\n",
                                                     "9223372036854775807",
                                                     "'''",
                                                     "#",
                                                     ".",
                                                     "sand.H = ",
                                                     "[[zones]]\ncolumns = 1e9\n"};
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  for (std::size_t edits = 1 + below(4); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = below(text.size());
    const std::size_t line = text.rfind('\n', at) + 1;  // npos + 1 is 0
    const std::size_t length =
        text.find('\n', at) == std::string::npos ? std::string::npos : text.find('\n', at) + 1 - line;
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, 1 + below(20));
        break;
      case 2:
        text.insert(at, fragments[below(fragments.size())]);
        break;
      case 3:
        text.insert(line, text.substr(line, length));
        break;
      case 4:
        text.erase(line, length);
        break;
      default:
        text.insert(at, 1, static_cast<char>('0' + below(10)));
    }
  }
  return text;
}

TEST(MutatedStudy, IsReadOrRefusedWithAPlace) {
  std::mt19937 random(20230507);
  int sound = 0, refused = 0;
  for (const char* name : {"sens.toml", "paper/layered.toml"}) {
    const std::string original = text_of(std::filesystem::path(CPT_EXAMPLES) / name);
    ASSERT_FALSE(original.empty());
    for (int i = 0; i < 500; ++i) {
      const std::string text = mutated(original, random);
      const StudyOrErrors result = parse_study(text, "/studies/mutated.toml");
      if (const auto* study = std::get_if<Study>(&result)) {
        ++sound;
        for (const Realization& realization : one_at_a_time(*study))
          ASSERT_TRUE(solver::problems(make_setup(*study, realization)).empty()) << text;
      } else {
        ++refused;
        const auto& errors = std::get<std::vector<StudyError>>(result);
        ASSERT_FALSE(errors.empty()) << text;
        for (const StudyError& error : errors) ASSERT_FALSE(error.message.empty()) << text;
      }
    }
  }
  EXPECT_GT(sound, 50);  // edits of comments and of values within their range
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace cpt::parameters

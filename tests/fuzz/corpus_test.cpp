// Every input of every corpus, and damaged ones, are read with sound values or refused with a reason.
#include <gtest/gtest.h>

#include <ostream>

#include "tests/fuzz/mutation.hpp"
#include "tests/fuzz/targets.hpp"

namespace cpt::fuzz {

void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, KeepsThePromises) {
  int sound = 0;
  for (const auto& file : corpus(GetParam()))
    EXPECT_NO_THROW(sound += GetParam().read(bytes_of(file)) == Fate::sound) << file;
  EXPECT_GT(sound, 0) << "nothing in the corpus can be read";
}

TEST_P(Corpus, KeepsThePromisesWhenDamaged) {
  std::vector<std::string> originals;
  for (const auto& file : corpus(GetParam())) originals.push_back(bytes_of(file));
  const std::vector<std::string> words = dictionary(GetParam());
  std::mt19937 random(20230507);
  int refused = 0;
  for (int i = 0; i < GetParam().mutations; ++i) {
    const std::string bytes = mutated(originals[i % originals.size()], words, random);
    ASSERT_NO_THROW(refused += GetParam().read(bytes) == Fate::refused) << "mutation " << i << ":\n" << bytes;
  }
  EXPECT_GT(refused, GetParam().mutations / 50) << "the damage does not reach the reader";
}

TEST_P(Corpus, BytesWithoutMeaningAreRefused) {
  std::mt19937 random(7);
  for (int i = 0; i < GetParam().mutations / 5; ++i) {
    std::string bytes(1 + random() % 400, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() % 256);
    EXPECT_EQ(GetParam().read(bytes), Fate::refused) << bytes;
  }
}

INSTANTIATE_TEST_SUITE_P(, Corpus, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace cpt::fuzz

#include "diagnosis/verdict.hpp"

#include <gtest/gtest.h>

namespace cpt::diagnosis {
namespace {

const Explanation nothing = Explanation::nothing(), unknown = Explanation::unknown();

Verdict verdict() {
  Verdict v;
  v.hypotheses = {{0, "a", 0.2, -3.0, 0.1},
                  {1, "b", 0.2, -1.0, 0.6},
                  {nothing, nothing_is_missing, 0.4, -4.0, 0.1},
                  {unknown, none_of_these, 0.2, -2.0, 0.2}};
  v.winner = v.answer = 1;
  v.set = {1, unknown, 0};
  return v;
}

TEST(Explanation, IsOneOfThree) {
  const Explanation second = 1;
  EXPECT_TRUE(second.is_mechanism() && !second.is_nothing() && !second.is_unknown());
  EXPECT_TRUE(nothing.is_nothing() && !nothing.is_mechanism() && !nothing.is_unknown());
  EXPECT_TRUE(unknown.is_unknown() && !unknown.is_mechanism() && !unknown.is_nothing());
  EXPECT_EQ(second.mechanism(), 1U);
  EXPECT_THROW((void)nothing.mechanism(), std::logic_error);
  EXPECT_TRUE(second == 1 && second != 0 && nothing != unknown);
}

TEST(Verdict, SortsAndFindsWhatWasWeighed) {
  Verdict v = verdict();
  // Equally probable ones stay in their order.
  EXPECT_EQ(v.by_probability(), (std::vector<Explanation>{1, unknown, 0, nothing}));
  EXPECT_EQ(v.mechanisms_by_probability(), (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(v.mechanisms_in_set(), (std::vector<std::size_t>{1, 0}));
  EXPECT_TRUE(v.in_set(unknown));
  EXPECT_FALSE(v.in_set(nothing));
  EXPECT_EQ(v.of(unknown).name, none_of_these);
  EXPECT_EQ(v.of(v.answer).name, "b");
  EXPECT_THROW((void)v.of(2), std::out_of_range);
  EXPECT_FALSE(v.gate_failed());
  v.answer = unknown;
  EXPECT_TRUE(v.gate_failed());
}

}  // namespace
}  // namespace cpt::diagnosis

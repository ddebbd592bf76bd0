// Every fault a few times; scripts/fault-injection does each many times and writes docs/reliability.md.
#include "tests/faults/faults.hpp"

#include <gtest/gtest.h>

namespace cpt::tests {
namespace {

class Faults : public testing::TestWithParam<Fault> {};

TEST_P(Faults, LoseNothingAndAreTold) {
  if (std::string(CPT_SANITIZE) != "" && std::string(GetParam().name) == "memory_limit")
    GTEST_SKIP() << "sanitizers reserve terabytes";
  const Finding finding = GetParam().inject(GetParam().few, 1);
  for (const std::string& problem : finding.problems) {
    if (problem.find("not tried") != std::string::npos) GTEST_SKIP() << problem;
    ADD_FAILURE() << problem;
  }
  EXPECT_EQ(finding.trials, GetParam().few);
  EXPECT_EQ(finding.lost, 0);
  EXPECT_EQ(finding.twice, 0);
  EXPECT_EQ(finding.unopened, 0);
  EXPECT_FALSE(finding.told.empty());
}

INSTANTIATE_TEST_SUITE_P(All, Faults, testing::ValuesIn(all_faults()),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace cpt::tests

#include "campaign/pace.hpp"

#include <gtest/gtest.h>

namespace cpt::campaign {
namespace {

TEST(Pace, WaitsForNewsAndThenForItsShareOfTheTime) {
  Pace pace(0.01, 0.001);
  EXPECT_FALSE(pace.due(1000.0, 5));  // nothing new
  pace.news();
  EXPECT_TRUE(pace.due(1000.0, 5));
  pace.wrote(1000.0, 1000.5, 5);  // 0.1 s a realization
  EXPECT_FALSE(pace.stale());
  pace.news();
  EXPECT_FALSE(pace.due(1000.5 + 0.99 * 60.0, 6));  // 0.6 s are a hundredth of a minute
  EXPECT_TRUE(pace.due(1000.5 + 1.01 * 60.0, 6));
}

TEST(Pace, DistancesGrowWithTheCampaign) {
  Pace pace(0.01, 0.001);
  pace.wrote(0.0, 1.0, 10);
  pace.news();
  EXPECT_TRUE(pace.due(1.0 + 110.0, 10));
  EXPECT_FALSE(pace.due(1.0 + 110.0, 20));
  EXPECT_TRUE(pace.due(1.0 + 210.0, 20));
}

}  // namespace
}  // namespace cpt::campaign

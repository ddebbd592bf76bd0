#include "results/push/radial_profile.hpp"

#include <gtest/gtest.h>

#include "tests/results/push_recording.hpp"

namespace cpt::results {
namespace {

double number(const Table& table, std::size_t row, std::size_t column) {
  return std::get<double>(table.rows.at(row).at(column));
}

TEST(RadialProfile, AveragesRingsByVolumeBetweenTheDepths) {
  // Rings of 0.1 m: two points in the first, one in the third, one too shallow, one in the surcharge.
  std::vector<solver::PointState> start = {point(1, 0.05, 0.3, 0.7), point(2, 0.08, 0.3, 0.7),
                                           point(3, 0.25, 0.3, 0.7), point(4, 0.25, 0.1, 0.7),
                                           point(5, 0.25, -0.3, 0.7)};
  start[4].material = 2;
  start[4].surcharge = true;
  std::vector<solver::PointState> now = start;
  now[0].volume = 1.0;
  now[0].e = 0.8;
  now[1].volume = 3.0;
  now[1].e = 0.6;
  now[3].e = 0.2;
  const Table table = ring_table(radial_profile(soil_at_end(start, now), {0.2, 0.4}, 0.1));
  ASSERT_EQ(table.rows.size(), 2U);
  ASSERT_EQ(table.columns[4], "void_ratio_change");
  EXPECT_EQ(std::get<std::int64_t>(table.rows[0][1]), 2);
  EXPECT_NEAR(number(table, 0, 0), 0.25 * 0.05 + 0.75 * 0.08, 1e-15);
  EXPECT_NEAR(number(table, 0, 2), 0.7, 1e-15);
  EXPECT_NEAR(number(table, 0, 3), 0.65, 1e-15);
  EXPECT_NEAR(number(table, 0, 4), -0.05, 1e-15);
  EXPECT_EQ(number(table, 0, 5), 0.6);
  EXPECT_EQ(number(table, 0, 6), 0.8);
  EXPECT_NEAR(number(table, 1, 0), 0.25, 1e-15);
  EXPECT_NEAR(number(table, 1, 4), 0.0, 1e-15);
}

}  // namespace
}  // namespace cpt::results

// The bucket store: nothing is lost or doubled however points move.
#include "solver/material_points.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace cpt::solver {
namespace {

TEST(MaterialPoints, KeepsEveryPointThroughManyMoves) {
  const std::int32_t cells = 20, materials = 3;
  std::vector<Point> points;
  std::vector<std::int32_t> bucket_of;
  for (std::uint32_t i = 0; i < 300; ++i) {
    PointValues values;
    for (int f = 0; f < field_count; ++f) values[static_cast<std::size_t>(f)] = i * 100.0 + f;
    auto p = std::bit_cast<Point>(values);
    p.id = i;
    points.push_back(p);
    bucket_of.push_back(static_cast<std::int32_t>(i % 7) * materials + static_cast<std::int32_t>(i % 3));
  }
  MaterialPoints store(points, bucket_of, cells, materials);
  std::mt19937 random(3);
  for (int move = 0; move < 5000; ++move) {
    const auto from = static_cast<std::int32_t>(random() % (cells * materials));
    if (store.bucket(from).count == 0) continue;
    const auto slot = static_cast<std::int32_t>(random() % static_cast<unsigned>(store.bucket(from).count));
    auto to = static_cast<std::int32_t>(random() % (cells * materials));
    if (to == from) continue;
    store.move(from, slot, to);
  }
  std::map<std::uint32_t, int> seen;
  for (std::int32_t b = 0; b < store.bucket_count(); ++b) {
    const Bucket& bucket = store.bucket(b);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bucket.data) % 64, 0U);
    EXPECT_LE(bucket.capacity, store.largest_capacity());
    EXPECT_LE(bucket.count, bucket.capacity);
    const PointFields p = store.fields(bucket);
    for (std::int32_t k = 0; k < bucket.count; ++k) {
      const std::uint32_t id = static_cast<std::uint32_t>(p.id[k]);
      ++seen[id];
      EXPECT_EQ(p.r[k], id * 100.0);
      EXPECT_EQ(p.load[k], id * 100.0 + 14);
    }
    for (std::size_t k = static_cast<std::size_t>(bucket.count); k < bucket.padded(); ++k) {
      EXPECT_EQ(p.mass[k], 0.0);
      EXPECT_EQ(p.volume[k], 0.0);
    }
  }
  EXPECT_EQ(seen.size(), 300U);
  for (const auto& [id, count] : seen) EXPECT_EQ(count, 1) << id;
}

}  // namespace
}  // namespace cpt::solver

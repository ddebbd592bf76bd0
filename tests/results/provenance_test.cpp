#include "results/ledger/provenance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/presets.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::results {
namespace {

// Test vectors of FIPS 180-4.
TEST(Provenance, Sha256OfKnownTexts) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Provenance, SettingsHashSeesTheLastBitOfAnInput) {
  const auto setup = solver::make_setup(solver::Profile::homogeneous_clay, solver::Preset::quick);
  auto other = setup;
  EXPECT_EQ(settings_hash(setup), settings_hash(other));
  solver::clay_of(other).s_u = std::nextafter(solver::clay_of(other).s_u, 1.0e9);
  EXPECT_NE(settings_hash(setup), settings_hash(other));
}

TEST(Provenance, FirstDifferenceComparesBits) {
  const solver::DepthProfile a{{1, 2, 3}, {4, 5, std::numeric_limits<double>::quiet_NaN()}, {0.0, 7, 8}};
  EXPECT_FALSE(first_difference(a, a));
  auto b = a;
  b.f_s[0] = -0.0;
  EXPECT_EQ(first_difference(a, b), 0u);
  b = a;
  b.q_c[1] = std::nextafter(5.0, 6.0);
  EXPECT_EQ(first_difference(a, b), 1u);
  b = a;
  for (auto* values : {&b.depth, &b.q_c, &b.f_s}) values->pop_back();
  EXPECT_EQ(first_difference(a, b), 2u);
}

TEST(Provenance, ClockIsIso8601InUtc) {
  const std::string now = utc_now();
  ASSERT_EQ(now.size(), 24u);
  EXPECT_EQ(now[10], 'T');
  EXPECT_EQ(now.back(), 'Z');
  EXPECT_LE(now, utc_now());  // sorts as text
}

}  // namespace
}  // namespace cpt::results

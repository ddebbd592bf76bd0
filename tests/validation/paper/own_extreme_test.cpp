#include "validation/paper/own_extreme.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::validation::paper {
namespace {

// q_c [Pa] of height `top` about a peak at `at` [m], in bins of 1 mm.
solver::DepthProfile peaked(double at, double top) {
  solver::DepthProfile profile;
  for (int i = 0; i < 100; ++i) {
    const double depth = 0.2 + 0.001 * i;
    profile.depth.push_back(depth);
    profile.q_c.push_back(top * (1.0 - 100.0 * std::pow(depth - at, 2)));
  }
  return profile;
}

struct Campaign {
  results::Snapshot snapshot;
  results::WindowRow peak{"w", "peak", 0.249, 0.251, "", 1, 0.22, 0.28, 0.002};

  void add(const char* parameter, const char* side, double at, double top) {
    results::RealizationRow run{};
    run.id = static_cast<int>(snapshot.realizations.size()) + 1;
    run.parameter = parameter;
    run.side = side;
    run.status = "completed";
    snapshot.realizations.push_back(run);
    snapshot.curves.push_back({run.id, peaked(at, top)});
  }
};

// The window that the baseline places reads a peak elsewhere on its slope; each run's own does not.
TEST(OwnExtremes, AreReadWhereEachRunHasThem) {
  Campaign made;
  made.add("", "baseline", 0.250, 1.0e6);
  made.add("sand.H", "upper", 0.256, 1.25e6);
  const auto own = own_extremes(made.snapshot, made.peak, "sand.H");
  ASSERT_TRUE(own);
  EXPECT_NEAR(own->at_lower, 0.250, 1e-9);  // its lower bound is the baseline
  EXPECT_NEAR(own->at_upper, 0.256, 1e-9);
  EXPECT_NEAR(own->si, 0.2, 1e-9);
}

TEST(OwnExtremes, NeedAnExtremeInEveryRun) {
  Campaign made;
  made.add("", "baseline", 0.250, 1.0e6);
  made.add("sand.H", "upper", 0.290, 1.0e6);  // rises through the range
  EXPECT_FALSE(own_extremes(made.snapshot, made.peak, "sand.H"));
  made.snapshot.realizations[1].status = "pending";
  EXPECT_FALSE(own_extremes(made.snapshot, made.peak, "sand.H"));
  made.peak.kind = "fixed";
  EXPECT_FALSE(own_extremes(made.snapshot, made.peak, "sand.nu"));
}

TEST(OwnExtremes, FindTroughsToo) {
  Campaign made;
  made.add("", "baseline", 0.250, -1.0e6);
  made.add("clay.s_u_kPa", "lower", 0.240, -2.0e6);
  made.peak.kind = "trough";
  const auto own = own_extremes(made.snapshot, made.peak, "clay.s_u_kPa");
  ASSERT_TRUE(own);
  EXPECT_NEAR(own->at_lower, 0.240, 1e-9);
  EXPECT_NEAR(own->at_upper, 0.250, 1e-9);
}

}  // namespace
}  // namespace cpt::validation::paper

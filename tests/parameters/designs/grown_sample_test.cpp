// A Latin hypercube that grows keeps its runs, fills its gaps, and is read as a fresh one is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "parameters/designs/discrepancy.hpp"
#include "parameters/designs/latin_hypercube.hpp"
#include "parameters/designs/polynomial_chaos.hpp"
#include "tests/parameters/designs/functions.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

TEST(GrownSample, KeepsItsRunsInOneStepAndInTwo) {
  const MatrixXd first = latin_hypercube_places(5, 24, 3);
  const MatrixXd grown = grown_latin_hypercube_places(5, 24, 30, 3);
  EXPECT_EQ(grown.topRows(24), first);
  EXPECT_EQ(grown_latin_hypercube_places(5, 24, 48, 3).topRows(30), grown);
  EXPECT_EQ(grown_latin_hypercube_places(5, 24, 24, 3), first);
  EXPECT_EQ(grown_latin_hypercube_places(5, 24, 30, 3), grown);
  EXPECT_NE(grown_latin_hypercube_places(5, 24, 30, 4), grown);
}

TEST(GrownSample, EachNewRunGoesToEmptyIntervalsOfEveryParameter) {
  const MatrixXd places = grown_latin_hypercube_places(4, 10, 40, 7);
  EXPECT_GE(places.minCoeff(), 0.0);
  EXPECT_LT(places.maxCoeff(), 1.0);
  for (Index run = 10; run < 40; ++run)
    for (Index j = 0; j < 4; ++j) {
      const auto interval = [&](Index k) {
        return static_cast<Index>(places(k, j) * static_cast<double>(run + 1));
      };
      for (Index k = 0; k < run; ++k) EXPECT_NE(interval(k), interval(run)) << run << ' ' << k << ' ' << j;
    }
}

// Hickernell (1998), eq. 5.3, where it is known in closed form.
TEST(Discrepancy, MeetsWhatIsKnown) {
  for (const int parameters : {1, 3, 6})
    EXPECT_NEAR(centred_discrepancy(MatrixXd::Constant(1, parameters, 0.5)),
                std::sqrt(std::pow(13.0 / 12.0, parameters) - 1.0), 1e-12);
  for (const int runs : {2, 5, 16}) {
    MatrixXd midpoints(runs, 1);
    for (int i = 0; i < runs; ++i) midpoints(i, 0) = (i + 0.5) / runs;
    EXPECT_NEAR(centred_discrepancy(midpoints), 1.0 / std::sqrt(12.0) / runs, 1e-12);
  }
}

TEST(Discrepancy, DoesNotCareForOrderAndMirrors) {
  const MatrixXd places = latin_hypercube_places(3, 17, 2);
  MatrixXd other = places.colwise().reverse();
  EXPECT_NEAR(centred_discrepancy(other), centred_discrepancy(places), 1e-12);
  other.col(1) = 1.0 - other.col(1).array();
  EXPECT_NEAR(centred_discrepancy(other), centred_discrepancy(places), 1e-12);
}

// Up to a term that all places share, and the share of a run that is one of more.
TEST(Discrepancy, OfOneMorePlaceOrdersPlacesAsTheWholeDoes) {
  const MatrixXd places = latin_hypercube_places(3, 12, 5), more = latin_hypercube_places(3, 40, 6);
  const auto whole = [&](const Eigen::RowVectorXd& place) {
    MatrixXd all(13, 3);
    all << places, place;
    return std::pow(centred_discrepancy(all), 2);
  };
  const double shared = whole(more.row(0)) - added_discrepancy(places, more.row(0));
  for (Index k = 1; k < more.rows(); ++k)
    EXPECT_NEAR(whole(more.row(k)) - added_discrepancy(places, more.row(k)), shared, 1e-12);
}

TEST(GrownSample, IsAsEvenAsAFreshOne) {
  for (const int runs : {30, 48}) {
    double grown = 0.0, fresh = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      grown += centred_discrepancy(grown_latin_hypercube_places(3, 24, runs, seed)) / 20.0;
      fresh += centred_discrepancy(latin_hypercube_places(3, runs, seed)) / 20.0;
    }
    EXPECT_LT(grown, fresh) << runs;
    RecordProperty("grown_" + std::to_string(runs), std::to_string(grown));
    RecordProperty("fresh_" + std::to_string(runs), std::to_string(fresh));
  }
}

// The polynomial of a grown sample misses no more than that of a fresh one, and holds the exact indices.
TEST(GrownSample, PolynomialChaosReadsIt) {
  const auto exact = ishigami_indices();
  const MatrixXd places = grown_latin_hypercube_places(3, 200, 300, 1);
  const auto fit = polynomial_chaos(places, std::vector<int>(3), results_of(ishigami, places));
  EXPECT_GT(fit.q2, 0.95);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(fit.first[i].value, exact.first(static_cast<Index>(i)), 0.05) << i;
    EXPECT_NEAR(fit.total[i].value, exact.total(static_cast<Index>(i)), 0.05) << i;
  }
}

TEST(GrownSample, BootstrapIntervalsCover) {
  constexpr int trials = 100;
  int held = 0;
  for (int seed = 0; seed < trials; ++seed) {
    const MatrixXd places = grown_latin_hypercube_places(2, 24, 40, static_cast<std::uint64_t>(seed));
    const auto results = results_of(
        [](const auto& u) { return u(0) + 2.0 * u(1) + 0.05 * std::sin(1e4 * (u(0) + u(1))); }, places);
    const auto fit = polynomial_chaos(places, std::vector<int>(2), results);
    held += fit.first[1].lower <= 0.8 && 0.8 <= fit.first[1].upper ? 1 : 0;
  }
  EXPECT_GE(held / static_cast<double>(trials), 0.88);
}

}  // namespace
}  // namespace cpt::parameters

#include "parameters/designs/latin_hypercube.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <limits>
#include <vector>

#include "parameters/designs/discrepancy.hpp"
#include "parameters/designs/permutation.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Bits = boost::random::mt19937_64;

MatrixXd fresh_places(int parameters, int runs, Bits& bits) {
  boost::random::uniform_01<double> within;
  MatrixXd places(runs, parameters);
  for (Index j = 0; j < parameters; ++j) {
    Index run = 0;
    for (const Index interval : permutation(runs, bits))
      places(run++, j) = (static_cast<double>(interval) + within(bits)) / runs;
  }
  return places;
}

// Of as many equal intervals, those without a place.
std::vector<Index> empty_intervals(const Eigen::Ref<const Eigen::VectorXd>& places, Index intervals) {
  std::vector<bool> taken(static_cast<std::size_t>(intervals));
  for (const double place : places)
    taken[static_cast<std::size_t>(
        std::min(intervals - 1, static_cast<Index>(place * static_cast<double>(intervals))))] = true;
  std::vector<Index> empty;
  for (Index i = 0; i < intervals; ++i)
    if (!taken[static_cast<std::size_t>(i)]) empty.push_back(i);
  return empty;
}

// Tried for the run that follows `runs`; fewer where each costs more.
int candidates(Index runs) { return static_cast<int>(std::clamp<Index>(10'000 / runs, 1, 50)); }

}  // namespace

MatrixXd latin_hypercube_places(int parameters, int runs, std::uint64_t seed) {
  Bits bits(seed);
  return fresh_places(parameters, runs, bits);
}

MatrixXd grown_latin_hypercube_places(int parameters, int first_runs, int runs, std::uint64_t seed) {
  Bits bits(seed);
  MatrixXd places(runs, parameters);
  places.topRows(first_runs) = fresh_places(parameters, first_runs, bits);
  boost::random::uniform_01<double> within;
  for (Index run = first_runs; run < runs; ++run) {
    const Index intervals = run + 1;  // one more than places: at least one is empty
    std::vector<std::vector<Index>> empty;
    for (Index j = 0; j < parameters; ++j)
      empty.push_back(empty_intervals(places.col(j).head(run), intervals));
    double least = std::numeric_limits<double>::infinity();
    const int tries = candidates(run);
    for (int k = 0; k < tries; ++k) {
      Eigen::RowVectorXd place(parameters);
      for (Index j = 0; j < parameters; ++j) {
        const std::vector<Index>& free = empty[static_cast<std::size_t>(j)];
        boost::random::uniform_int_distribution<std::size_t> any(0, free.size() - 1);
        const auto interval = static_cast<double>(free[any(bits)]);
        place(j) = (interval + within(bits)) / static_cast<double>(intervals);
      }
      const double added = tries > 1 ? added_discrepancy(places.topRows(run), place) : 0.0;
      if (added >= least) continue;
      least = added;
      places.row(run) = place;
    }
  }
  return places;
}

DesignKind latin_hypercube_design() {
  return {.name = "latin_hypercube",
          // Loeppky, Sacks & Welch (2009), Technometrics 51
          .keys = {{"runs", 0.0, 10.0}, {"first_runs", 0.0}, {"seed", 1.0}},
          .samples = true,
          .run_count = [](const Design& design) { return long{design.runs}; },
          .places =
              [](const Design& design) {
                if (design.first_runs == 0)
                  return latin_hypercube_places(width_of(design), design.runs, design.seed);
                return grown_latin_hypercube_places(width_of(design), design.first_runs, design.runs,
                                                    design.seed);
              },
          .run_name = [](const Design&, Index run) { return fmt::format("latin hypercube {}", run + 1); }};
}

}  // namespace cpt::parameters

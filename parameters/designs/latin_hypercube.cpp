#include "parameters/designs/latin_hypercube.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include "parameters/designs/permutation.hpp"

namespace cpt::parameters {

Eigen::MatrixXd latin_hypercube_places(int parameters, int runs, std::uint64_t seed) {
  boost::random::mt19937_64 bits(seed);
  boost::random::uniform_01<double> within;
  Eigen::MatrixXd places(runs, parameters);
  for (Eigen::Index j = 0; j < parameters; ++j) {
    Eigen::Index run = 0;
    for (const Eigen::Index interval : permutation(runs, bits))
      places(run++, j) = (static_cast<double>(interval) + within(bits)) / runs;
  }
  return places;
}

}  // namespace cpt::parameters

// Random permutations that are the same with every standard library.
#pragma once

#include <Eigen/Core>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <numeric>
#include <utility>
#include <vector>

namespace cpt::parameters {

/// The numbers 0 to count - 1 in random order (Fisher and Yates; std::shuffle leaves its draws open).
[[nodiscard]] inline std::vector<Eigen::Index> permutation(Eigen::Index count,
                                                           boost::random::mt19937_64& bits) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  for (std::size_t k = order.size(); k > 1; --k)
    std::swap(order[k - 1], order[boost::random::uniform_int_distribution<std::size_t>(0, k - 1)(bits)]);
  return order;
}

}  // namespace cpt::parameters

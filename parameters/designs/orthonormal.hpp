// Polynomials that are orthonormal over the places that an input really takes.
#pragma once

#include <Eigen/Core>

namespace cpt::parameters {

/// Over [0, 1], all places equally likely: Legendre's. Over whole numbers: `values` places 0, 1/(values - 1),
/// ..., 1, of which the two at the ends come half as often as each other one, since a uniform place goes to
/// the nearest. A choice is two values, each half of the time: 1 and -1.
class OrthonormalPolynomials {
 public:
  /// values: 0 for all of [0, 1], else 2 or more. Degrees up to `most_degree`, and below `values`.
  OrthonormalPolynomials(int values, int most_degree);

  [[nodiscard]] int most_degree() const { return most_degree_; }
  /// Of degree >= 1 at a place, which is one of the values.
  [[nodiscard]] double operator()(int degree, double place) const;

 private:
  int most_degree_;
  Eigen::MatrixXd at_values_;  // values x degrees from 0; empty for all of [0, 1]
};

}  // namespace cpt::parameters

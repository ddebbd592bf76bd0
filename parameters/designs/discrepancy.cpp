#include "parameters/designs/discrepancy.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::parameters {
namespace {

using Eigen::Index;

// The two products of Hickernell (1998), eq. 5.3: of one place, and of two.
template <class Row>
double alone(const Row& x) {
  const auto z = (x.array() - 0.5).abs();
  return (1.0 + 0.5 * z - 0.5 * z.square()).prod();
}

template <class RowA, class RowB>
double together(const RowA& x, const RowB& y) {
  return (1.0 + 0.5 * (x.array() - 0.5).abs() + 0.5 * (y.array() - 0.5).abs() -
          0.5 * (x.array() - y.array()).abs())
      .prod();
}

}  // namespace

double centred_discrepancy(const Eigen::MatrixXd& places) {
  const auto n = static_cast<double>(places.rows());
  double single = 0.0, pairs = 0.0;
  for (Index i = 0; i < places.rows(); ++i) {
    single += alone(places.row(i));
    for (Index k = 0; k < i; ++k) pairs += 2.0 * together(places.row(i), places.row(k));
    pairs += together(places.row(i), places.row(i));
  }
  const double square =
      std::pow(13.0 / 12.0, static_cast<double>(places.cols())) - 2.0 * single / n + pairs / (n * n);
  return std::sqrt(std::max(square, 0.0));
}

double added_discrepancy(const Eigen::Ref<const Eigen::MatrixXd>& places, const Eigen::RowVectorXd& place) {
  const auto n = static_cast<double>(places.rows() + 1);
  double pairs = together(place, place);
  for (Index i = 0; i < places.rows(); ++i) pairs += 2.0 * together(places.row(i), place);
  return pairs / (n * n) - 2.0 * alone(place) / n;
}

}  // namespace cpt::parameters

#include "parameters/designs/orthonormal.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int most_values = 5000;  // beyond, whole numbers lie as densely as numbers

}  // namespace

OrthonormalPolynomials::OrthonormalPolynomials(int values, int most_degree) : most_degree_(most_degree) {
  if (values < 2 || values > most_values) return;
  most_degree_ = std::min(most_degree, values - 1);
  VectorXd weight = VectorXd::Constant(values, 1.0 / (values - 1));
  weight(0) = weight(values - 1) = 0.5 / (values - 1);
  const VectorXd x = VectorXd::LinSpaced(values, -1.0, 1.0);
  at_values_.resize(values, most_degree_ + 1);
  at_values_.col(0).setOnes();
  for (Index degree = 1; degree <= most_degree_; ++degree) {
    VectorXd p = x.cwiseProduct(at_values_.col(degree - 1));
    for (int pass = 0; pass < 2; ++pass)  // the second removes what rounding left
      for (Index lower = 0; lower < degree; ++lower)
        p -= at_values_.col(lower).cwiseProduct(weight).dot(p) * at_values_.col(lower);
    at_values_.col(degree) = p / std::sqrt(p.cwiseAbs2().dot(weight));
  }
}

double OrthonormalPolynomials::operator()(int degree, double place) const {
  if (at_values_.size() > 0)
    return at_values_(std::lround(place * static_cast<double>(at_values_.rows() - 1)), degree);
  return std::sqrt(2.0 * degree + 1.0) * std::legendre(static_cast<unsigned>(degree), 2.0 * place - 1.0);
}

}  // namespace cpt::parameters

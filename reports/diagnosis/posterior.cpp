#include "reports/diagnosis/posterior.hpp"

#include <cmath>
#include <map>

#include "diagnosis/quadrature.hpp"

namespace cpt::reports::diagnosed {

Marginal marginal(const diagnosis::MechanismEvidence& evidence, Index k) {
  if (evidence.nodes.rows() != evidence.probability.size() || k >= evidence.nodes.cols()) return {};
  std::map<long, double> mass;  // by phi in units of 1e-12: equal nodes differ in their last bits at most
  constexpr double unit = 1e-12;
  for (Index i = 0; i < evidence.nodes.rows(); ++i)
    mass[std::lround(evidence.nodes(i, k) / unit)] += evidence.probability(i);
  const auto points = static_cast<int>(mass.size());
  // A tensor grid has (nodes per direction)^dimensions rows.
  const double rows = std::pow(points, static_cast<double>(evidence.nodes.cols()));
  if (points < 3 || std::lround(rows) != evidence.nodes.rows()) return {};

  const diagnosis::Quadrature rule = diagnosis::gauss_legendre(points);
  const double first = static_cast<double>(mass.begin()->first) * unit;
  const double last = static_cast<double>(mass.rbegin()->first) * unit;
  const double width = (last - first) / std::abs(rule.nodes(points - 1, 0) - rule.nodes(0, 0));
  Marginal result;
  Index i = 0;  // the weights are the same from either end
  for (const auto& [place, probability] : mass) {
    result.phi.push_back(static_cast<double>(place) * unit);
    result.density.push_back(probability / (rule.weights(i++) * width));
  }
  return result;
}

}  // namespace cpt::reports::diagnosed

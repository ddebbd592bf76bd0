#include "diagnosis/prior_range.hpp"

#include <cmath>

namespace cpt::diagnosis {
namespace {

// Stored runs were made with these bits; std::lerp, as in parameters::value_at, has others where the ends are
// of opposite sign.
double between(double lower, double upper, double place) { return lower + place * (upper - lower); }

}  // namespace

std::vector<std::size_t> varied_parameters(const solver::Mechanism& mechanism) {
  std::vector<std::size_t> varied;
  for (std::size_t j = 0; j < mechanism.parameters.size(); ++j)
    if (mechanism.parameters[j].prior_lower < mechanism.parameters[j].prior_upper) varied.push_back(j);
  return varied;
}

double prior_value(const solver::MechanismParameter& parameter, double place) {
  if (parameter.prior == solver::Prior::accuracy) {
    const double even = 2.0 * place - 1.0;
    place = 0.5 * (1.0 + even * even * even);
  }
  return between(parameter.prior_lower, parameter.prior_upper, place);
}

double prior_deviation(const solver::MechanismParameter& parameter, double place, double deviation) {
  return 0.5 * (prior_value(parameter, place + deviation) - prior_value(parameter, place - deviation));
}

double row_value(const parameters::Row& row, double place) {
  if (!row.quantity->choices.empty()) return place < 0.5 ? row.lower : row.upper;
  const double value = between(row.lower, row.upper, place);
  return row.quantity->integer ? std::round(value) : value;
}

}  // namespace cpt::diagnosis

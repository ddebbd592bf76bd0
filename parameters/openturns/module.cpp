// The one file that knows OpenTURNS (Baudin, Dutfoy, Iooss & Popelin 2017, Handbook of Uncertainty
// Quantification). Built as a module that distributions/library.cpp loads.
#include <cmath>
#include <openturns/Beta.hxx>
#include <openturns/LogNormal.hxx>
#include <openturns/Normal.hxx>
#include <openturns/Triangular.hxx>
#include <openturns/TruncatedDistribution.hxx>
#include <openturns/Uniform.hxx>
#include <openturns/UserDefined.hxx>
#include <stdexcept>

#include "parameters/distributions/library.hpp"

namespace cpt::parameters {
namespace {

OT::Sample column(const std::vector<double>& values) {
  OT::Sample sample(values.size(), 1);
  for (std::size_t i = 0; i < values.size(); ++i) sample(i, 0) = values[i];
  return sample;
}

OT::Distribution untruncated(const Distribution& of) {
  const std::vector<double>& p = of.parameters;
  switch (of.family) {
    case Family::normal:
      return OT::Normal(p.at(0), p.at(1));
    case Family::lognormal:
      return OT::LogNormal(p.at(0), p.at(1));
    case Family::uniform:
      return OT::Uniform(p.at(0), p.at(1));
    case Family::triangular:
      return OT::Triangular(p.at(0), p.at(1), p.at(2));
    case Family::beta:
      return OT::Beta(p.at(0), p.at(1), p.at(2), p.at(3));
    case Family::discrete: {
      OT::Point weights(of.weights.size());
      for (std::size_t i = 0; i < of.weights.size(); ++i) weights[i] = of.weights[i];
      return OT::UserDefined(column(of.values), weights);
    }
  }
  throw std::invalid_argument("no such family of distributions");
}

OT::Distribution made(const Distribution& of) {
  const OT::Distribution whole = untruncated(of);
  const bool below = std::isfinite(of.least), above = std::isfinite(of.most);
  if (!below && !above) return whole;
  OT::Interval kept(1);
  kept.setLowerBound(OT::Point(1, below ? of.least : 0.0));
  kept.setUpperBound(OT::Point(1, above ? of.most : 0.0));
  kept.setFiniteLowerBound(OT::Interval::BoolCollection(1, below));
  kept.setFiniteUpperBound(OT::Interval::BoolCollection(1, above));
  return OT::TruncatedDistribution(whole, kept);
}

class OpenTurnsMarginal final : public Marginal {
 public:
  explicit OpenTurnsMarginal(const Distribution& of) : distribution_(made(of)) {}
  [[nodiscard]] double quantile(double probability) const override {
    return distribution_.computeQuantile(probability)[0];
  }
  [[nodiscard]] double probability(double value) const override { return distribution_.computeCDF(value); }
  [[nodiscard]] double mean() const override { return distribution_.getMean()[0]; }
  [[nodiscard]] double standard_deviation() const override { return distribution_.getStandardDeviation()[0]; }

 private:
  OT::Distribution distribution_;
};

std::unique_ptr<const Marginal> make_marginal(const Distribution& distribution) {
  try {
    return std::make_unique<OpenTurnsMarginal>(distribution);
  } catch (const OT::Exception& error) {
    throw std::invalid_argument(error.what());
  }
}

constexpr OpenTurns offered = {.marginal = make_marginal};

}  // namespace
}  // namespace cpt::parameters

extern "C" const cpt::parameters::OpenTurns* cpt_openturns() { return &cpt::parameters::offered; }

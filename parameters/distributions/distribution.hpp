// The distribution of an uncertain input: what it is, as plain data, and what it answers.
#pragma once

#include <limits>
#include <memory>
#include <string_view>
#include <vector>

namespace cpt::parameters {

/// Families, each with its parameters in the order of Distribution::parameters.
enum class Family {
  normal,      ///< mean, standard deviation
  lognormal,   ///< mean and standard deviation of the logarithm
  uniform,     ///< least, most
  triangular,  ///< least, mode, most
  beta,        ///< alpha, beta, least, most
  discrete     ///< none: values with weights; an empirical sample has equal ones
};

/// Plain data: equal data, equal quantiles.
struct Distribution {
  Family family = Family::uniform;
  std::vector<double> parameters = {};
  std::vector<double> values = {};   ///< discrete: in ascending order, each once
  std::vector<double> weights = {};  ///< discrete: probability of each; they add up to one
  /// Cut off outside, and what remains scaled up to one.
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  friend bool operator==(const Distribution&, const Distribution&) = default;
};

/// A distribution that can be asked.
class Marginal {
 public:
  virtual ~Marginal() = default;
  /// The value that is not exceeded with a probability of 0 to 1.
  [[nodiscard]] virtual double quantile(double probability) const = 0;
  /// The probability of a value not above `value`.
  [[nodiscard]] virtual double probability(double value) const = 0;
  [[nodiscard]] virtual double mean() const = 0;
  [[nodiscard]] virtual double standard_deviation() const = 0;
};

/// Throws std::invalid_argument where the parameters are none of the family, and MissingLibrary
/// (distributions/library.hpp) where OpenTURNS is not at hand.
[[nodiscard]] std::unique_ptr<const Marginal> marginal(const Distribution& distribution);

/// "normal"
[[nodiscard]] std::string_view to_string(Family family);

}  // namespace cpt::parameters

// A soil parameter that varies over depth as nature left it: a stationary random field with a Markov
// correlation (Vanmarcke 1983, Random Fields: Analysis and Synthesis, section 5.1).
//
//   normal:     x(z) = mean + deviation g(z)
//   lognormal:  x(z) = mean exp(zeta g(z) - zeta^2 / 2),  zeta^2 = ln(1 + (deviation / mean)^2)
//   g(z): standard normal, correlation of g(z) and g(z + t): exp(-|t| / length)
//
// The scale of fluctuation is twice the length. g is a pure function of seed and depth, exact at every
// millimetre and linear between: from the ends of a long interval inwards, each middle is drawn given both
// ends (Levy's construction for an Ornstein-Uhlenbeck process), so that no mesh and no other depth changes
// it.
#pragma once

#include <cstdint>

namespace cpt::solver {

enum class FieldKind : std::uint8_t { normal, lognormal };

struct RandomField {
  double deviation = 0.0;  // [unit of the parameter] standard deviation; 0: no field
  double length = 0.1;     // [m] correlation length
  FieldKind kind = FieldKind::lognormal;
  double seed = 1.0;  // [-] whole number

  [[nodiscard]] bool on() const { return deviation != 0.0; }
  /// g at a depth [m] of 0 to 65 m.
  [[nodiscard]] double score(double depth) const;
  /// The parameter's value there.
  [[nodiscard]] double at(double mean, double depth) const;
};

}  // namespace cpt::solver

#include "solver/constitutive/varying_tresca.hpp"

#include <algorithm>

#include "solver/constitutive/linear_elastic.hpp"

namespace cpt::solver {

VaryingTresca::VaryingTresca(const TrescaParameters& clay, const StrainSoftening& softening,
                             const RateDependence& rate)
    : constants_{LinearElastic::constants(clay.G, clay.nu), softening.loss, 1.0 / softening.xi_95, rate.mu,
                 1.0 / rate.reference_rate},
      kernels_(&constitutive_kernels()),
      modulus_(constants_.elastic.lame + constants_.elastic.two_G) {}

bool strength_varies(const TrescaParameters& clay, const Mechanisms& mechanisms) {
  return clay.s_u_field.on() || mechanisms.strain_softening.on() || mechanisms.rate_dependence.on() ||
         mechanisms.strength_gradient.on() || mechanisms.clay_crust.on();
}

double strength_at(const TrescaParameters& clay, const Mechanisms& mechanisms, double depth) {
  const double weakest = 0.01 * clay.s_u;  // a falling gradient does not end in negative strength
  const double s_u = clay.s_u_field.at(clay.s_u, depth);
  return std::max(weakest,
                  s_u * (1.0 + mechanisms.clay_crust.at(depth)) + mechanisms.strength_gradient.at(depth));
}

}  // namespace cpt::solver

#include "solver/constitutive/tresca.hpp"

#include "solver/constitutive/linear_elastic.hpp"

namespace cpt::solver {

Tresca::Tresca(const TrescaParameters& clay)
    : constants_{LinearElastic::constants(clay.G, clay.nu), clay.s_u},
      kernels_(&constitutive_kernels()),
      modulus_(constants_.elastic.lame + constants_.elastic.two_G) {}

}  // namespace cpt::solver

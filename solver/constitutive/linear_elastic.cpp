#include "solver/constitutive/linear_elastic.hpp"

namespace cpt::solver {

LinearElastic::LinearElastic(double E, double nu)
    : constants_(constants(E / (2.0 * (1.0 + nu)), nu)), kernels_(&constitutive_kernels()) {}

}  // namespace cpt::solver

// Single-element tests through the same constitutive code as the push: triaxial, oedometer, isotropic
// compression.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/constitutive/specimen.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

enum class ElementPath { triaxial, oedometer, isotropic };

/// Parameters of a linear elastic specimen.
struct Elastic {
  double E;   // [Pa]
  double nu;  // [-]
};

/// What to test. Stresses and strains are compression-positive, strains natural (logarithmic).
struct ElementTest {
  ElementPath path = ElementPath::triaxial;
  bool drained = true;  ///< triaxial only: constant cell pressure, or constant volume
  std::variant<LawParameters, Elastic> material = NorSandParameters{};
  double sigma_a = 100.0e3;                               // [Pa] initial axial effective stress, > 0
  double sigma_r = 100.0e3;                               // [Pa] initial radial effective stress, > 0
  double e_0 = std::numeric_limits<double>::quiet_NaN();  // [-] initial void ratio; NaN: the soil's
  double h_0 =
      std::numeric_limits<double>::quiet_NaN();  // initial first state variable; NaN: the law's start
  double max_axial_strain = 0.25;                // [-] > 0
  double max_axial_stress =
      std::numeric_limits<double>::infinity();  // [Pa] the first row beyond it is the last
  int steps = 250;                              // [-] rows of the result, equal steps of axial strain, >= 1
  double max_increment = 2.5e-4;  // [-] axial strain of one increment at most: a row takes several
};

/// One row of the result; psi is NaN for laws without a critical state line.
struct ElementRow {
  double eps_a;  // [-] axial strain
  double eps_v;  // [-] volumetric strain
  double q;      // [Pa] sigma_a - sigma_r
  double p;      // [Pa] mean effective stress
  double e;      // [-] void ratio
  double psi;    // [-] state parameter e - e_c(p)
  double h_0;    // state variables of the law
  double h_1;
};

struct ElementResult {
  std::vector<ElementRow> rows;  ///< the first is the initial state
  std::string problem;           ///< empty if the test ran to its end; otherwise rows hold what there is
};

[[nodiscard]] ElementResult run_element_test(const ElementTest& test);

/// Radial strain increment [-] (compression-positive) that, with an axial one, brings the radial stress to
/// the cell pressure [Pa]; `guess` is the last step's answer. nullopt if there is none.
[[nodiscard]] std::optional<double> drained_radial_strain(const Specimen& specimen, double axial,
                                                          double cell_pressure, double guess);

}  // namespace cpt::solver

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
  std::variant<Sand, Clay, Elastic> material = Sand{};
  double sigma_a = 100.0e3;                               // [Pa] initial axial effective stress, > 0
  double sigma_r = 100.0e3;                               // [Pa] initial radial effective stress, > 0
  double e_0 = std::numeric_limits<double>::quiet_NaN();  // [-] initial void ratio; NaN: from D_r or n_0
  double p_i =
      std::numeric_limits<double>::quiet_NaN();  // [Pa] initial image pressure; NaN: yield surface and OCR
  double max_axial_strain = 0.25;                // [-] > 0
  double max_axial_stress =
      std::numeric_limits<double>::infinity();  // [Pa] the first row beyond it is the last
  int steps = 250;                              // [-] rows of the result, equal steps of axial strain, >= 1
  double max_increment = 2.5e-4;  // [-] axial strain of one increment at most: a row takes several
};

/// One row of the result; psi, p_i and psi_i are NaN but for sand.
struct ElementRow {
  double eps_a;  // [-] axial strain
  double eps_v;  // [-] volumetric strain
  double q;      // [Pa] sigma_a - sigma_r
  double p;      // [Pa] mean effective stress
  double e;      // [-] void ratio
  double psi;    // [-] state parameter e - e_c(p)
  double p_i;    // [Pa] image pressure
  double psi_i;  // [-] state parameter at the image pressure
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

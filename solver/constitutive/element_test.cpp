#include "solver/constitutive/element_test.hpp"

#include <cmath>

#include "solver/constitutive/critical_state_line.hpp"
#include "solver/constitutive/linear_elastic.hpp"
#include "solver/constitutive/norsand.hpp"
#include "solver/constitutive/tresca.hpp"

namespace cpt::solver {
namespace {

template <typename... Functions>
struct Overload : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overload(Functions...) -> Overload<Functions...>;  // clang 14 has no such guide of its own

double radial_stress(const Specimen& specimen) { return -specimen.stress().rr; }
double axial_stress(const Specimen& specimen) { return -specimen.stress().zz; }

// Compression-positive increments.
Specimen strained(const Specimen& specimen, double axial, double radial) {
  Specimen next = specimen;
  next.strain(-radial, -axial, -radial, 0.0);
  return next;
}

struct Prepared {
  Specimen specimen;
  std::optional<CriticalStateLine> line;
};

Prepared prepare(const ElementTest& test) {
  const PointStress stress = {-test.sigma_r, -test.sigma_a, -test.sigma_r, 0.0};
  const auto void_ratio = [&](double from_material) {
    return std::isnan(test.e_0) ? from_material : test.e_0;
  };
  return std::visit(
      Overload{[&](const Sand& sand) {
                 const NorSand law(sand);
                 const double e = void_ratio(sand.e_max - sand.D_r * (sand.e_max - sand.e_min));
                 const double p_i = std::isnan(test.p_i) ? law.initial_image_pressure(stress.rr, stress.zz,
                                                                                      stress.tt, stress.rz, e)
                                                         : test.p_i;
                 return Prepared{Specimen(law, stress, e, p_i), CriticalStateLine(sand)};
               },
               [&](const Clay& clay) {
                 return Prepared{Specimen(Tresca(clay), stress, void_ratio(clay.n_0 / (1.0 - clay.n_0))), {}};
               },
               [&](const Elastic& elastic) {
                 return Prepared{Specimen(LinearElastic(elastic.E, elastic.nu), stress, void_ratio(0.0)), {}};
               }},
      test.material);
}

ElementRow row(const Prepared& prepared, double eps_a, double eps_v) {
  const Specimen& s = prepared.specimen;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  ElementRow r{eps_a, eps_v, axial_stress(s) - radial_stress(s), s.p(), s.e(), nan, nan, nan};
  if (prepared.line) {
    r.psi = s.e() - prepared.line->void_ratio(s.p());
    r.p_i = s.p_i();
    r.psi_i = s.e() - prepared.line->void_ratio(s.p_i());
  }
  return r;
}

}  // namespace

// Illinois' method from the last step's answer, with a step
// outward until the answer is bracketed. Raising the radial strain raises the radial stress.
std::optional<double> drained_radial_strain(const Specimen& specimen, double axial, double cell_pressure,
                                            double guess) {
  const auto excess = [&](double radial) {
    return radial_stress(strained(specimen, axial, radial)) - cell_pressure;
  };
  const double tolerance = 1e-12 * cell_pressure;
  double reach = std::abs(axial);
  double a = guess, f_a = excess(a);
  if (std::abs(f_a) <= tolerance) return a;
  double b = a, f_b = f_a;
  for (int i = 0; i < 60 && f_a * f_b > 0.0; ++i, reach *= 2.0) {
    a = b;
    f_a = f_b;
    b = a - std::copysign(reach * (i == 0 ? 1e-3 : 1.0), f_a);
    f_b = excess(b);
  }
  if (!(f_a * f_b <= 0.0)) return std::nullopt;
  for (int i = 0; i < 100; ++i) {
    const double c = b - f_b * (b - a) / (f_b - f_a);
    const double f_c = excess(c);
    if (!std::isfinite(f_c)) return std::nullopt;
    if (f_c * f_b < 0.0) {
      a = b;
      f_a = f_b;
    } else {
      f_a *= 0.5;
    }
    b = c;
    f_b = f_c;
    if (std::abs(f_c) <= tolerance || std::abs(b - a) <= 1e-16 * std::abs(axial)) break;
  }
  return b;
}

ElementResult run_element_test(const ElementTest& test) {
  ElementResult result;
  if (!(test.sigma_a > 0.0 && test.sigma_r > 0.0 && test.max_axial_strain > 0.0 && test.steps >= 1)) {
    result.problem = "initial stresses and the largest axial strain must be positive, steps at least 1";
    return result;
  }
  Prepared prepared = prepare(test);
  const double axial_row = test.max_axial_strain / test.steps;
  const int increments = static_cast<int>(std::ceil(axial_row / test.max_increment - 1e-9));
  const double axial = axial_row / increments;
  double eps_a = 0.0, eps_v = 0.0;
  double radial = -0.3 * axial;
  result.rows.push_back(row(prepared, eps_a, eps_v));
  for (int i = 1; i <= test.steps * increments; ++i) {
    switch (test.path) {
      case ElementPath::oedometer:
        radial = 0.0;
        break;
      case ElementPath::isotropic:
        radial = axial;
        break;
      case ElementPath::triaxial:
        if (test.drained) {
          const auto found = drained_radial_strain(prepared.specimen, axial, test.sigma_r, radial);
          if (!found) {
            result.problem = "no radial strain keeps the cell pressure";
            return result;
          }
          radial = *found;
        } else {
          radial = -0.5 * axial;
        }
    }
    prepared.specimen = strained(prepared.specimen, axial, radial);
    eps_a += axial;
    eps_v += axial + 2.0 * radial;
    if (i % increments != 0) continue;
    result.rows.push_back(row(prepared, eps_a, eps_v));
    if (!std::isfinite(result.rows.back().q + result.rows.back().p)) {
      result.problem = "the stress became non-finite";
      return result;
    }
    if (axial_stress(prepared.specimen) >= test.max_axial_stress) break;
  }
  return result;
}

}  // namespace cpt::solver

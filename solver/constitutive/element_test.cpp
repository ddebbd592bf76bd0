#include "solver/constitutive/element_test.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "solver/constitutive/linear_elastic.hpp"
#include "solver/soils/law.hpp"

namespace cpt::solver {
namespace {

double radial_stress(const Specimen& specimen) { return -specimen.stress().rr; }
double axial_stress(const Specimen& specimen) { return -specimen.stress().zz; }

// Compression-positive increments.
Specimen strained(const Specimen& specimen, double axial, double radial) {
  Specimen next = specimen;
  next.strain(-radial, -axial, -radial, 0.0);
  return next;
}

// A law that copies of a specimen share.
struct SharedModel {
  std::shared_ptr<const SoilModel> model;
  [[nodiscard]] double update(const Batch& batch) const { return model->update(batch); }
};

Specimen prepare(const ElementTest& test) {
  const PointStress stress = {-test.sigma_r, -test.sigma_a, -test.sigma_r, 0.0};
  const auto asked = [](double value, double otherwise) { return std::isnan(value) ? otherwise : value; };
  if (const auto* elastic = std::get_if<Elastic>(&test.material))
    return {LinearElastic(elastic->E, elastic->nu), stress, asked(test.e_0, 0.0)};
  const auto& parameters = std::get<LawParameters>(test.material);
  const Law& law = law_of(parameters);
  const SharedModel model{law.model(parameters, {})};
  const double e = asked(test.e_0, law.void_ratio(parameters));
  PointHistory history = model.model->start({0.0, stress.rr, stress.zz, stress.tt, stress.rz, e});
  history[0] = asked(test.h_0, history[0]);
  return {model, stress, e, history[0], history[1]};
}

ElementRow row(const ElementTest& test, const Specimen& s, double eps_a, double eps_v) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  ElementRow r{eps_a, eps_v, axial_stress(s) - radial_stress(s), s.p(), s.e(), nan, s.h_0(), s.h_1()};
  if (const auto* parameters = std::get_if<LawParameters>(&test.material))
    r.psi = s.e() - law_of(*parameters).critical_void_ratio(*parameters, s.p());
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
  Specimen specimen = prepare(test);
  const double axial_row = test.max_axial_strain / test.steps;
  const int increments = static_cast<int>(std::ceil(axial_row / test.max_increment - 1e-9));
  const double axial = axial_row / increments;
  double eps_a = 0.0, eps_v = 0.0;
  double radial = -0.3 * axial;
  result.rows.push_back(row(test, specimen, eps_a, eps_v));
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
          const auto found = drained_radial_strain(specimen, axial, test.sigma_r, radial);
          if (!found) {
            result.problem = "no radial strain keeps the cell pressure";
            return result;
          }
          radial = *found;
        } else {
          radial = -0.5 * axial;
        }
    }
    specimen = strained(specimen, axial, radial);
    eps_a += axial;
    eps_v += axial + 2.0 * radial;
    if (i % increments != 0) continue;
    result.rows.push_back(row(test, specimen, eps_a, eps_v));
    if (!std::isfinite(result.rows.back().q + result.rows.back().p)) {
      result.problem = "the stress became non-finite";
      return result;
    }
    if (std::holds_alternative<LawParameters>(test.material) && !(specimen.e() > 0.0)) {
      result.rows.pop_back();
      result.problem = fmt::format("no voids are left at an axial strain of {:.3g} %", 100.0 * eps_a);
      return result;
    }
    if (axial_stress(specimen) >= test.max_axial_stress) break;
  }
  return result;
}

}  // namespace cpt::solver

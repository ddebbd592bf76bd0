#include "parameters/calibration/simulated_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/constitutive/critical_state_line.hpp"

namespace cpt::calibration {
namespace {

constexpr double triaxial_row = 2.5e-4;   // [-] natural axial strain of one row, which cubics join;
constexpr double oedometer_row = 2.5e-4;  // [-] which straight lines join
constexpr double tolerance = 1.0e-5;      // [-] of a sub-step: a fit tells smaller differences than a push
constexpr int fewest_rows = 3;            // as a cubic needs them beside the first
constexpr double usual_K_0 = 0.5;         // [-] of an oedometer test that gives none
constexpr double more_strain = 3.0;       // [-] an oedometer test may take so many times the measured strain,
constexpr double more_strain_yet = 0.05;  // [-] and this, before it counts as one that does not reach its end

int rows_over(double strain, double row) {
  return std::max(fewest_rows, static_cast<int>(std::ceil(strain / row)));
}

double axial_stress(const solver::ElementRow& row) { return row.p + 2.0 / 3.0 * row.q; }

// The rows' y at x, which rises from row to row; straight lines between them, y of the last beyond.
template <class X, class Y>
double interpolated(const std::vector<solver::ElementRow>& rows, double x, const X& x_of, const Y& y_of) {
  const auto after = std::ranges::lower_bound(rows, x, {}, x_of);
  if (after == rows.begin()) return y_of(rows.front());
  if (after == rows.end()) return y_of(rows.back());
  const auto before = after - 1;
  const double share = (x - x_of(*before)) / (x_of(*after) - x_of(*before));
  return y_of(*before) + share * (y_of(*after) - y_of(*before));
}

// Column of a triaxial test, whose rows are equal steps of strain apart, at a natural strain: Lagrange's
// cubic through the four rows around it.
double at_strain(const std::vector<solver::ElementRow>& rows, double eps_a,
                 double solver::ElementRow::*column) {
  const double place = std::max(eps_a / rows[1].eps_a, 0.0);
  const std::size_t first =
      std::min(static_cast<std::size_t>(std::max(std::floor(place) - 1.0, 0.0)), rows.size() - 4);
  const double t = place - static_cast<double>(first);
  return -(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0 * rows[first].*column +
         t * (t - 2.0) * (t - 3.0) / 2.0 * rows[first + 1].*column -
         t * (t - 1.0) * (t - 3.0) / 2.0 * rows[first + 2].*column +
         t * (t - 1.0) * (t - 2.0) / 6.0 * rows[first + 3].*column;
}

solver::NorSandParameters exactly(solver::NorSandParameters sand) {
  sand.substep_tolerance = std::min(sand.substep_tolerance, tolerance);
  return sand;
}

double start_of(const OedometerCurve& curve) {
  return std::isnan(curve.e_0) ? curve.readings.front().e : curve.e_0;
}

}  // namespace

std::string_view to_string(Channel channel) {
  switch (channel) {
    case Channel::q:
      return "q / q_max";
    case Channel::eps_v:
      return "eps_v";
    case Channel::e:
      return "e";
    case Channel::ln_G_0:
      return "ln G0";
  }
  return "";
}

solver::ElementResult simulate(const TriaxialCurve& curve, const solver::NorSandParameters& sand) {
  solver::ElementTest test;
  test.material = exactly(sand);
  test.sigma_a = test.sigma_r = curve.p_0;
  test.e_0 = void_ratio_before(curve, sand);
  test.max_axial_strain = natural_strain(curve.readings.back().eps_a);
  test.steps = rows_over(test.max_axial_strain, triaxial_row);
  test.max_increment = triaxial_row;
  return run_element_test(test);
}

solver::ElementResult simulate(const OedometerCurve& curve, const solver::NorSandParameters& sand) {
  solver::ElementTest test;
  test.path = solver::ElementPath::oedometer;
  test.material = exactly(sand);
  test.sigma_a = curve.readings.front().sigma_v;
  test.sigma_r = (std::isnan(curve.K_0) ? usual_K_0 : curve.K_0) * test.sigma_a;
  test.e_0 = start_of(curve);
  const double measured = std::log((1.0 + test.e_0) / (1.0 + curve.readings.back().e));
  test.max_axial_strain = more_strain * std::max(measured, 0.0) + more_strain_yet;
  test.max_axial_stress = curve.readings.back().sigma_v;
  test.steps = rows_over(test.max_axial_strain, oedometer_row);
  solver::ElementResult result = run_element_test(test);
  if (result.problem.empty() && axial_stress(result.rows.back()) < test.max_axial_stress)
    result.problem = fmt::format("sigma_v is {:.4g} kPa at an axial strain of {:.3g} %",
                                 axial_stress(result.rows.back()) / 1e3, 100.0 * test.max_axial_strain);
  return result;
}

double small_strain_modulus(const TriaxialCurve& curve, const solver::NorSandParameters& sand) {
  const double gap = void_ratio_before(curve, sand) - sand.e_min_star;
  return sand.G_ref * solver::reference_pressure / gap *
         std::pow(curve.p_0 / solver::reference_pressure, sand.b);
}

SimulatedTests::SimulatedTests(LaboratoryTests tests) : tests_(std::move(tests)) {
  for (std::size_t test = 0; test < tests_.triaxial.size(); ++test) {
    const TriaxialCurve& curve = tests_.triaxial[test];
    const double largest = std::ranges::max(curve.readings, {}, &Reading::q).q;
    largest_q_.push_back(largest > 0.0 ? largest : 1.0);
    for (const Reading& reading : curve.readings)
      if (reading.eps_a > 0.0) observations_.push_back({Channel::q, test, reading.q / largest_q_.back()});
    for (const Reading& reading : curve.readings)
      if (reading.eps_a > 0.0 && !std::isnan(reading.eps_v))
        observations_.push_back({Channel::eps_v, test, reading.eps_v});
    if (!std::isnan(curve.G_0)) observations_.push_back({Channel::ln_G_0, test, std::log(curve.G_0)});
  }
  for (std::size_t k = 0; k < tests_.oedometer.size(); ++k) {
    const OedometerCurve& curve = tests_.oedometer[k];
    for (const OedometerReading& reading : curve.readings)
      if (reading.sigma_v > curve.readings.front().sigma_v)
        observations_.push_back({Channel::e, tests_.triaxial.size() + k, reading.e});
  }
}

std::string SimulatedTests::run(const solver::NorSandParameters& sand, std::vector<double>& values) const {
  values.clear();
  for (std::size_t test = 0; test < tests_.triaxial.size(); ++test) {
    const TriaxialCurve& curve = tests_.triaxial[test];
    const solver::ElementResult result = simulate(curve, sand);
    if (!result.problem.empty()) return fmt::format("{}: {}", curve.name, result.problem);
    const auto at = [&](double eps_a, double solver::ElementRow::*column) {
      return at_strain(result.rows, natural_strain(eps_a), column);
    };
    for (const Reading& reading : curve.readings)
      if (reading.eps_a > 0.0) values.push_back(at(reading.eps_a, &solver::ElementRow::q) / largest_q_[test]);
    for (const Reading& reading : curve.readings)
      if (reading.eps_a > 0.0 && !std::isnan(reading.eps_v))
        values.push_back(engineering_strain(at(reading.eps_a, &solver::ElementRow::eps_v)));
    if (!std::isnan(curve.G_0)) values.push_back(std::log(small_strain_modulus(curve, sand)));
  }
  for (const OedometerCurve& curve : tests_.oedometer) {
    const solver::ElementResult result = simulate(curve, sand);
    if (!result.problem.empty()) return fmt::format("{}: {}", curve.name, result.problem);
    for (const OedometerReading& reading : curve.readings)
      if (reading.sigma_v > curve.readings.front().sigma_v)
        values.push_back(interpolated(result.rows, reading.sigma_v, axial_stress,
                                      [](const solver::ElementRow& row) { return row.e; }));
  }
  for (const double value : values)
    if (!std::isfinite(value)) return "a simulated test is not finite";
  return {};
}

}  // namespace cpt::calibration

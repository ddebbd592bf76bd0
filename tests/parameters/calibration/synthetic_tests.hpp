// Laboratory tests of a sand whose parameters are known, with the scatter of readings.
#pragma once

#include <cmath>
#include <random>

#include "parameters/calibration/simulated_tests.hpp"

namespace cpt::calibration {

/// A sand away from Table 2 of Yost et al. (2023), where every fit starts.
inline solver::NorSandParameters other_sand() {
  solver::NorSandParameters sand;
  sand.e_cs0 = 0.87;
  sand.lambda = 0.018;
  sand.m = 0.6;
  sand.G_ref = 620.0;
  sand.b = 0.5;
  sand.phi_cs = 32.5 * std::acos(-1.0) / 180.0;
  sand.N = 0.22;
  sand.chi_tc = 3.4;
  sand.nu = 0.15;
  sand.H = 60.0;
  return sand;
}

struct SpecimenState {
  double e_0, p_0;
};

/// Standard deviations of readings: of q over the test's largest, of eps_v, of e, of ln G_0.
struct ReadingScatter {
  double q = 0.01, eps_v = 5e-4, e = 1e-3, ln_G_0 = 0.05;
};

/// Drained triaxial tests to 20 % of strain, a reading each 0.25 %, with the modulus at small strains before;
/// and an oedometer test from 10 kPa to 10 MPa, 25 readings.
inline LaboratoryTests synthetic_tests(const solver::NorSandParameters& sand,
                                       const std::vector<SpecimenState>& specimens, double oedometer_e_0,
                                       const ReadingScatter& scatter, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> error;
  LaboratoryTests tests;
  for (const SpecimenState& specimen : specimens) {
    TriaxialCurve& curve = tests.triaxial.emplace_back();
    curve.name = "CD";
    curve.e_0 = specimen.e_0;
    curve.p_0 = specimen.p_0;
    curve.G_0 = small_strain_modulus(curve, sand) * std::exp(scatter.ln_G_0 * error(generator));
    for (int i = 0; i <= 80; ++i) curve.readings.push_back({0.0025 * i, 0.0, 0.0});
    SimulatedTests one({{curve}, {}});
    std::vector<double> values;
    static_cast<void>(one.run(sand, values));  // q over 1 Pa, as all measured are zero
    double largest = 0.0;
    for (int i = 0; i < 80; ++i) largest = std::max(largest, values[i]);
    for (int i = 1; i <= 80; ++i) {
      curve.readings[i].q = values[i - 1] + scatter.q * largest * error(generator);
      curve.readings[i].eps_v = values[80 + i - 1] + scatter.eps_v * error(generator);
    }
  }
  if (oedometer_e_0 > 0.0) {
    OedometerCurve& curve = tests.oedometer.emplace_back();
    curve.name = "OE";
    curve.e_0 = oedometer_e_0;
    for (int i = 0; i <= 24; ++i) curve.readings.push_back({10e3 * std::pow(10.0, i / 8.0), oedometer_e_0});
    SimulatedTests one({{}, {curve}});
    std::vector<double> values;
    static_cast<void>(one.run(sand, values));
    for (std::size_t i = 0; i < values.size(); ++i)
      curve.readings[i + 1].e = values[i] + scatter.e * error(generator);
  }
  return tests;
}

}  // namespace cpt::calibration

#include "parameters/calibration/hardening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <vector>

#include "solver/constitutive/critical_state_line.hpp"
#include "solver/constitutive/element_test.hpp"

namespace cpt::calibration {
namespace {

constexpr int steps = 200;  // of a simulated test
constexpr int coarse = 24;  // values of H tried first
constexpr int bits = 26;    // of ln H that Brent's method finds: about half of a double's, its limit
constexpr std::size_t fewest_initial = 3;  // readings of the initial part beyond the start
constexpr double hopeless = 1.0e30;        // misfit of a test that does not run

std::vector<Reading> initial_part(const TriaxialCurve& curve, double fraction) {
  double largest = 0.0;
  for (const Reading& reading : curve.readings) largest = std::max(largest, reading.q);
  std::vector<Reading> part;
  for (const Reading& reading : curve.readings) {
    if (reading.eps_a > 0.0) part.push_back(reading);
    if (reading.q >= fraction * largest) break;
  }
  return part;
}

class Simulation {
 public:
  Simulation(const TriaxialCurve& curve, const solver::NorSandParameters& sand, double e_0, double eps_a) {
    test_.material = sand;
    test_.sigma_a = test_.sigma_r = curve.p_0;
    test_.e_0 = e_0;
    test_.steps = steps;
    test_.max_axial_strain = natural_strain(eps_a);
  }

  /// Simulates the test with this H; false if it does not run to its end.
  bool run(double H) {
    std::get<solver::NorSandParameters>(std::get<solver::LawParameters>(test_.material)).H = H;
    result_ = solver::run_element_test(test_);
    return result_.problem.empty();
  }

  [[nodiscard]] double q(double eps_a) const { return at(eps_a, &solver::ElementRow::q); }
  [[nodiscard]] double eps_v(double eps_a) const {
    return engineering_strain(at(eps_a, &solver::ElementRow::eps_v));
  }

 private:
  [[nodiscard]] double at(double eps_a, double solver::ElementRow::*column) const {
    const double place = std::min(natural_strain(eps_a) / test_.max_axial_strain, 1.0) * steps;
    const auto i = std::min(static_cast<std::size_t>(place), result_.rows.size() - 2);
    const double from = result_.rows[i].*column, to = result_.rows[i + 1].*column;
    return from + (place - static_cast<double>(i)) * (to - from);
  }

  solver::ElementTest test_;
  solver::ElementResult result_;
};

double root_mean_square(double sum_of_squares, std::size_t n) {
  return std::sqrt(sum_of_squares / static_cast<double>(n));
}

// Of q over the initial part, over the last measured q.
double misfit(Simulation& simulation, const std::vector<Reading>& part, double H) {
  if (!simulation.run(H)) return hopeless;
  double sum = 0.0;
  for (const Reading& reading : part) sum += std::pow(simulation.q(reading.eps_a) - reading.q, 2);
  return root_mean_square(sum, part.size()) / part.back().q;
}

// The minimum over ln H; several valleys are possible, so the best of a coarse row shows the way.
double best_hardening(Simulation& simulation, const std::vector<Reading>& part,
                      const HardeningOptions& options) {
  const double from = std::log(options.H_lower), to = std::log(options.H_upper);
  const auto ln_H = [&](int i) { return from + (to - from) * i / coarse; };
  const auto objective = [&](double x) { return misfit(simulation, part, std::exp(x)); };
  int best = 0;
  double least = objective(from);
  for (int i = 1; i <= coarse; ++i)
    if (const double here = objective(ln_H(i)); here < least) {
      best = i;
      least = here;
    }
  const auto [x, value] = boost::math::tools::brent_find_minima(objective, ln_H(std::max(best - 1, 0)),
                                                                ln_H(std::min(best + 1, coarse)), bits);
  return std::exp(x);
}

double eps_v_misfit(const TriaxialCurve& curve, Simulation& simulation, double H) {
  if (std::isnan(curve.readings.back().eps_v) || !simulation.run(H)) return not_given;
  double sum = 0.0;
  for (const Reading& reading : curve.readings)
    sum += std::pow(simulation.eps_v(reading.eps_a) - reading.eps_v, 2);
  return root_mean_square(sum, curve.readings.size());
}

}  // namespace

HardeningFit fit_hardening(const TriaxialCurve& curve, const solver::NorSandParameters& sand,
                           const HardeningOptions& options) {
  HardeningFit fit;
  fit.p_0 = curve.p_0;
  fit.e_0 = void_ratio_before(curve, sand);
  if (!(fit.p_0 > 0.0) || !(fit.e_0 > 0.0)) {
    fit.problem = "the stress p_0 and the density e_0 or D_r before shearing are not known";
    return fit;
  }
  fit.psi_0 = fit.e_0 - solver::CriticalStateLine(sand).void_ratio(fit.p_0);

  const std::vector<Reading> part = initial_part(curve, options.fraction);
  if (part.size() < fewest_initial || !(part.back().q > 0.0)) {
    fit.problem = fmt::format(
        "{} readings up to {:.6g} of the largest q, needs {}: read more often or match a larger part",
        part.size(), options.fraction, fewest_initial);
    return fit;
  }
  fit.eps_a = part.back().eps_a;
  fit.readings = static_cast<int>(part.size());
  fit.E_test = part.back().q / part.back().eps_a;

  Simulation simulation(curve, sand, fit.e_0, fit.eps_a);
  fit.H = best_hardening(simulation, part, options);
  fit.misfit = misfit(simulation, part, fit.H);
  if (fit.misfit >= hopeless) {
    fit.H = fit.misfit = not_given;
    fit.problem = "the simulated test does not run with any H";
    return fit;
  }
  fit.E_sand = simulation.q(fit.eps_a) / fit.eps_a;
  Simulation whole(curve, sand, fit.e_0, curve.readings.back().eps_a);
  fit.eps_v_misfit = eps_v_misfit(curve, whole, fit.H);
  constexpr double near = 1.01;
  if (fit.H < options.H_lower * near || fit.H > options.H_upper / near)
    fit.problem =
        fmt::format("H lies at the bound of the search, {:.6g} to {:.6g}", options.H_lower, options.H_upper);
  return fit;
}

}  // namespace cpt::calibration

#include "parameters/calibration/first_estimates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "parameters/calibration/hardening.hpp"
#include "solver/constitutive/critical_state_line.hpp"

namespace cpt::calibration {
namespace {

constexpr double peak_share = 0.1, end_share = 0.2;  // [-] of a test's strain
constexpr std::size_t fewest_in_a_stretch = 4;
constexpr double still = 0.05;          // [-] largest D and change of q at critical state
constexpr double told_dilatancy = 0.1;  // [-] the tests' D must differ by that much to tell N
constexpr double told_pressure = 2.0;   // [-] ends must differ by this factor to tell lambda
constexpr double near_enough = 0.3;     // [-] ends with a larger D say nothing of critical state
constexpr double inside = 0.01;         // [-] of the valid range: so far from its ends a fit starts
constexpr int rounds = 3;               // line and chi_tc in turns

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

struct Line {
  double at_0, slope;
};
// Least squares; nothing where all x are alike.
std::optional<Line> line_through(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 2) return std::nullopt;
  const double x_mean = mean(x), y_mean = mean(y);
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    product += (x[i] - x_mean) * (y[i] - y_mean);
    square += (x[i] - x_mean) * (x[i] - x_mean);
  }
  if (!(square > 1e-20 * static_cast<double>(x.size()) * x_mean * x_mean)) return std::nullopt;
  return Line{y_mean - product / square * x_mean, product / square};
}

struct Stretch {
  double D, q_change, q, eps_v, eps_a;  // slope and means
};
// Of the readings from..to, the last excluded.
std::optional<Stretch> stretch(const TriaxialCurve& curve, std::size_t from, std::size_t to) {
  if (to - from < fewest_in_a_stretch) return std::nullopt;
  std::vector<double> strain, volume, q, eps_v;
  for (std::size_t i = from; i < to; ++i) {
    const Reading& reading = curve.readings[i];
    strain.push_back(natural_strain(reading.eps_a));
    volume.push_back(natural_strain(reading.eps_v));
    q.push_back(reading.q);
    eps_v.push_back(reading.eps_v);
  }
  const auto v = line_through(strain, volume), stress = line_through(strain, q);
  if (!v || !stress) return std::nullopt;
  const double q_mean = mean(q);
  return Stretch{v->slope / (1.0 - v->slope / 3.0), stress->slope * (strain.back() - strain.front()) / q_mean,
                 q_mean, mean(eps_v), mean(strain)};
}

TestStates states_of(const TriaxialCurve& curve, const solver::NorSandParameters& sand) {
  TestStates states{.name = curve.name};
  const std::vector<Reading>& readings = curve.readings;
  if (std::isnan(readings.back().eps_v)) return states;
  const double e_0 = void_ratio_before(curve, sand), last = readings.back().eps_a;
  const auto p = [&](const Stretch& s) { return curve.p_0 + s.q / 3.0; };
  const auto e = [&](const Stretch& s) { return (1.0 + e_0) * (1.0 - s.eps_v) - 1.0; };
  const auto first_from = [&](double eps_a) {
    return static_cast<std::size_t>(std::ranges::lower_bound(readings, eps_a, {}, &Reading::eps_a) -
                                    readings.begin());
  };
  if (const auto end = stretch(curve, first_from((1.0 - end_share) * last), readings.size())) {
    states.D_end = end->D;
    states.q_change = end->q_change;
    states.eta_end = end->q / p(*end);
    states.p_end = p(*end);
    states.e_end = e(*end);
    states.critical = std::abs(end->D) <= still && std::abs(end->q_change) <= still;
  }
  for (std::size_t from = 0; from < readings.size(); ++from) {
    if (readings[from].eps_a + peak_share * last > last * (1.0 + 1e-9)) break;
    const std::size_t to = first_from(readings[from].eps_a + peak_share * last);
    const auto here =
        stretch(curve, from, std::max(to, std::min(from + fewest_in_a_stretch, readings.size())));
    if (!here || (!std::isnan(states.D_peak) && here->D >= states.D_peak)) continue;
    states.D_peak = here->D;
    states.eta_peak = here->q / p(*here);
    states.p_peak = p(*here);
    states.e_peak = e(*here);
  }
  return states;
}

// M_tc = 6 sin(phi) / (3 - sin(phi)), and the other way; degrees.
double degrees_of(double M_tc) { return std::asin(3.0 * M_tc / (6.0 + M_tc)) * 180.0 / std::numbers::pi; }

class Estimator {
 public:
  Estimator(const LaboratoryTests& tests, const solver::NorSandParameters& sand,
            std::span<const FitParameter* const> free)
      : tests_(tests), free_(free) {
    found_.sand = sand;
    for (const TriaxialCurve& curve : tests.triaxial) found_.states.push_back(states_of(curve, sand));
  }

  FirstEstimates find() {
    strength();
    for (int round = 0; round < rounds; ++round) {
      critical_state_line();
      dilatancy();
    }
    stiffness();
    hardening();
    return std::move(found_);
  }

 private:
  void set(std::string_view name, double value, std::string how) {
    const auto place = std::ranges::find_if(
        free_, [&](const FitParameter* parameter) { return parameter->quantity->name == name; });
    if (place == free_.end() || !std::isfinite(value)) return;
    const FitParameter& parameter = **place;
    const double margin = inside * parameter.range();
    // A logarithm of what is not positive has no place on the scale: its least.
    const double on_scale =
        parameter.logarithmic && value <= 0.0 ? parameter.lower() : parameter.scaled(value);
    value =
        parameter.study_value(std::clamp(on_scale, parameter.lower() + margin, parameter.upper() - margin));
    parameter.set(found_.sand, value);
    const auto known = std::ranges::find(found_.estimates, &parameter, &FirstEstimate::parameter);
    if (known == found_.estimates.end())
      found_.estimates.push_back({&parameter, value, std::move(how)});
    else
      *known = {&parameter, value, std::move(how)};
  }

  void strength() {
    std::vector<double> D, eta;
    const auto add = [&](double D_here, double eta_here) {
      if (std::isnan(D_here)) return;
      D.push_back(D_here);
      eta.push_back(eta_here);
    };
    for (const TestStates& states : found_.states) {
      add(states.D_peak, states.eta_peak);
      add(states.D_end, states.eta_end);
    }
    if (D.empty()) return;
    const auto [least, most] = std::ranges::minmax(D);
    const auto line = line_through(D, eta);
    double M = 0.0;
    if (line && most - least >= told_dilatancy) {
      set("N", 1.0 + line->slope, "stress ratio against dilatancy at peaks and ends");
      M = line->at_0;
    }
    if (M == 0.0)
      for (std::size_t i = 0; i < D.size(); ++i)
        M += (eta[i] + (1.0 - found_.sand.N) * D[i]) / static_cast<double>(D.size());
    set("phi_cs_deg", degrees_of(M), "stress ratio where the dilatancy is zero");
  }

  void critical_state_line() {
    std::vector<double> x, e;
    double least = 0.0, most = 0.0;
    int arrived = 0;
    for (const TestStates& states : found_.states) {
      if (std::isnan(states.D_end) || std::abs(states.D_end) > near_enough) continue;
      x.push_back(std::pow(states.p_end / solver::reference_pressure, found_.sand.m));
      e.push_back(states.e_end - states.D_end / found_.sand.chi_tc);
      least = x.size() == 1 ? states.p_end : std::min(least, states.p_end);
      most = std::max(most, states.p_end);
      if (states.critical) ++arrived;
    }
    if (x.empty()) return;
    const std::string how = fmt::format("ends of {} tests, {} of them at critical state", x.size(), arrived);
    const auto line = line_through(x, e);
    if (line && most >= told_pressure * least && line->slope < 0.0) set("lambda", -line->slope, how);
    double e_cs0 = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      e_cs0 += (e[i] + found_.sand.lambda * x[i]) / static_cast<double>(x.size());
    set("e_cs0", e_cs0, how);
  }

  void dilatancy() {
    const solver::CriticalStateLine line(found_.sand);
    double product = 0.0, square = 0.0;
    int dilate = 0;
    for (const TestStates& states : found_.states) {
      if (!(states.D_peak < -told_dilatancy)) continue;
      const double psi = states.e_peak - line.void_ratio(states.p_peak);
      product += psi * states.D_peak;
      square += psi * psi;
      ++dilate;
    }
    if (dilate > 0 && product > 0.0)
      set("chi_tc", product / square,
          fmt::format("least dilatancy against the state parameter there, {} tests", dilate));
  }

  void stiffness() {
    std::vector<double> x, y;
    for (const TriaxialCurve& curve : tests_.triaxial) {
      if (std::isnan(curve.G_0)) continue;
      x.push_back(std::log(curve.p_0 / solver::reference_pressure));
      y.push_back(std::log(curve.G_0 * (void_ratio_before(curve, found_.sand) - found_.sand.e_min_star) /
                           solver::reference_pressure));
    }
    if (x.empty()) return;
    const std::string how = fmt::format("G0 of {} tests", x.size());
    if (const auto line = line_through(x, y)) set("b", line->slope, how);
    double ln_G_ref = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      ln_G_ref += (y[i] - found_.sand.b * x[i]) / static_cast<double>(x.size());
    set("G_ref", std::exp(ln_G_ref), how);
  }

  void hardening() {
    std::vector<double> H;
    for (const TriaxialCurve& curve : tests_.triaxial)
      if (const HardeningFit fit = fit_hardening(curve, found_.sand); !std::isnan(fit.H)) H.push_back(fit.H);
    if (H.empty()) return;
    std::ranges::sort(H);
    set("H", H[H.size() / 2],
        fmt::format("median of {} tests' own, {:.3g} to {:.3g}", H.size(), H.front(), H.back()));
  }

  const LaboratoryTests& tests_;
  std::span<const FitParameter* const> free_;
  FirstEstimates found_;
};

}  // namespace

FirstEstimates first_estimates(const LaboratoryTests& tests, const solver::NorSandParameters& sand,
                               std::span<const FitParameter* const> free) {
  return Estimator(tests, sand, free).find();
}

}  // namespace cpt::calibration

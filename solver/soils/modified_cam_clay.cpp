#include "solver/soils/modified_cam_clay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/quantities.hpp"
#include "solver/soils/law_builders.hpp"

namespace cpt::solver {
namespace {

using P = ModifiedCamClayParameters;

constexpr std::string_view roscoe_burland = "Roscoe & Burland (1968)";

std::vector<LawQuantity> make_quantities() {
  return {
      parameter<P, &P::M>("M", "M", none, 0.3, 2.0, "stress ratio q / p' at the critical state",
                          roscoe_burland),
      parameter<P, &P::lambda>("lambda", "λ", none, 0.01, 1.0,
                               "slope of the normal compression line in v over ln p'", roscoe_burland),
      parameter<P, &P::kappa>("kappa", "κ", none, 0.001, 0.5, "slope of a swelling line in v over ln p'",
                              roscoe_burland),
      parameter<P, &P::nu>("nu", "ν", none, 0.0, 0.45, "Poisson's ratio of the clay skeleton",
                           roscoe_burland),
      parameter<P, &P::e_0>("e_0", "e₀", none, 0.1, 5.0, "void ratio before the push, at every depth",
                            "state of the soil"),
      parameter<P, &P::OCR>("OCR", "OCR", none, 1.0, 50.0,
                            "initial size of the yield surface over that through the initial stress",
                            "state of the soil"),
      parameter<P, &P::rho_grains>("rho_grains_kg_per_m3", "ρₛ", kilograms_per_cubic_metre, 2000.0, 3500.0,
                                   "density of the clay's grains", "typical of clay minerals"),
      parameter<P, &P::p_min>("p_min_kPa", "pₘᵢₙ", kilopascals, 0.01, 5.0,
                              "mean stress below which the clay carries none", "numerical setting"),
  };
}

// Deviator of an axisymmetric stress, compression-positive, and sqrt(3 J_2).
struct Deviator {
  double rr, zz, tt, rz;
  [[nodiscard]] double q() const { return std::sqrt(1.5 * (rr * rr + zz * zz + tt * tt + 2.0 * rz * rz)); }
  void scale(double factor) {
    rr *= factor;
    zz *= factor;
    tt *= factor;
    rz *= factor;
  }
};

// Backward Euler, with the volume exact: v falls by kappa d ln p' along a swelling line and by (lambda -
// kappa) d ln p_c where the clay yields, so that normal compression and critical state lines are met whatever
// the step. Compression is positive. f = q^2 / M^2 + p' (p' - p_c), associated; p_c is the size of the
// ellipse.
class Model : public SoilModel {
 public:
  explicit Model(const P& p)
      : p_(p), plastic_slope_(p.lambda - p.kappa), G_over_K_(1.5 * (1.0 - 2.0 * p.nu) / (1.0 + p.nu)) {}

  [[nodiscard]] double update(const Batch& batch) const override {
    double largest = 0.0;
    for (std::size_t k = 0; k < batch.size; ++k) largest = std::max(largest, update(batch, k));
    return largest;
  }
  [[nodiscard]] double poissons_ratio() const override { return p_.nu; }

  [[nodiscard]] PointHistory start(const PointStart& s) const override {
    const double p = -(s.s_rr + s.s_zz + s.s_tt) / 3.0;
    const Deviator d = {-s.s_rr - p, -s.s_zz - p, -s.s_tt - p, -s.s_rz};
    return {p_.OCR * (p + d.q() * d.q() / (p_.M * p_.M * p))};
  }

 private:
  // Of a step: what yielding changes.
  struct Plastic {
    double p, p_c, shrink;  // shrink: of the deviator
  };

  double update(const Batch& b, std::size_t k) const {
    const double v_0 = 1.0 + b.e[k], d_v = b.d_rr[k] + b.d_zz[k] + b.d_tt[k];  // tension-positive, natural
    const double v_1 = v_0 * std::exp(d_v);
    const double p_0 = std::max(-(b.s_rr[k] + b.s_zz[k] + b.s_tt[k]) / 3.0, p_.p_min);
    const double G = G_over_K_ * v_0 * p_0 / p_.kappa;
    const double pressure = (b.s_rr[k] + b.s_zz[k] + b.s_tt[k]) / 3.0, mean = d_v / 3.0;
    Deviator d = {-(b.s_rr[k] - pressure) - 2.0 * G * (b.d_rr[k] - mean),
                  -(b.s_zz[k] - pressure) - 2.0 * G * (b.d_zz[k] - mean),
                  -(b.s_tt[k] - pressure) - 2.0 * G * (b.d_tt[k] - mean), -b.s_rz[k] - 2.0 * G * b.d_rz[k]};
    double p = p_0 * std::exp((v_0 - v_1) / p_.kappa), p_c = b.h_0[k];
    const double q = d.q();
    if (q * q / (p_.M * p_.M) + p * (p - p_c) > 0.0) {
      const Plastic end = yield(p, p_c, q, 0.5 * (v_0 + v_1), G);
      p = end.p;
      p_c = end.p_c;
      d.scale(end.shrink);
    }
    if (!(p >= p_.p_min)) {  // also for NaN, which stays
      p = p < p_.p_min ? p_.p_min : p;
      d.scale(0.0);
    }
    b.s_rr[k] = -(p + d.rr);
    b.s_zz[k] = -(p + d.zz);
    b.s_tt[k] = -(p + d.tt);
    b.s_rz[k] = -d.rz;
    b.e[k] = v_1 - 1.0;
    b.h_0[k] = std::max(p_c, p_.p_min);
    return v_1 * std::max(p, p_0) / p_.kappa * (1.0 + 4.0 / 3.0 * G_over_K_);
  }

  // y = ln(p_c / p_c,trial) and the multiplier phi >= 0 with
  //   (lambda - kappa) y = v phi (2 p' - p_c),   q^2 / M^2 + p' (p' - p_c) = 0.
  // Given phi the first has one root y, since p' falls and p_c rises with it; the second falls with phi.
  Plastic yield(double p_trial, double p_c_trial, double q_trial, double v, double G) const {
    const auto at = [&](double y, double phi) {
      return Plastic{p_trial * std::exp(-plastic_slope_ / p_.kappa * y), p_c_trial * std::exp(y),
                     1.0 / (1.0 + 6.0 * G * phi / (p_.M * p_.M))};
    };
    const auto f = [&](const Plastic& s) {
      const double q = q_trial * s.shrink;
      return q * q / (p_.M * p_.M) + s.p * (s.p - s.p_c);
    };
    double y = 0.0;
    const auto settle = [&](double phi) {  // y of this phi, by Newton's method
      for (int i = 0; i < 50; ++i) {
        const Plastic s = at(y, phi);
        const double residual = plastic_slope_ * y - v * phi * (2.0 * s.p - s.p_c);
        const double slope = plastic_slope_ + v * phi * (2.0 * s.p * plastic_slope_ / p_.kappa + s.p_c);
        const double step = std::clamp(residual / slope, -0.5, 0.5);
        y -= step;
        if (std::abs(step) <= 1e-15) break;
      }
      return at(y, phi);
    };
    // Illinois' method; the unit of phi is that which halves the deviator, or the elastic volume change.
    const double tolerance = 1e-13 * p_c_trial * p_c_trial;
    double low = 0.0, f_low = f(at(0.0, 0.0));
    double high = f_low / (p_c_trial * p_c_trial) * p_.kappa / (v * p_c_trial);
    Plastic end = settle(high);
    double f_high = f(end);
    for (int i = 0; i < 100 && f_high > 0.0; ++i) {
      low = high;
      f_low = f_high;
      high *= 2.0;
      end = settle(high);
      f_high = f(end);
    }
    for (int i = 0; i < 60 && std::abs(f_high) > tolerance; ++i) {
      const double middle = high - f_high * (high - low) / (f_high - f_low);
      end = settle(middle);
      const double f_middle = f(end);
      if (f_middle * f_high < 0.0) {
        low = high;
        f_low = f_high;
      } else {
        f_low *= 0.5;
      }
      high = middle;
      f_high = f_middle;
    }
    return end;
  }

  P p_;
  double plastic_slope_, G_over_K_;
};

class ModifiedCamClayLaw : public Law {
 public:
  [[nodiscard]] std::string_view name() const override { return "modified_cam_clay"; }
  [[nodiscard]] std::string_view title() const override { return "Modified Cam Clay"; }
  [[nodiscard]] std::string_view models() const override { return "clay in effective stress"; }
  [[nodiscard]] std::string_view source() const override {
    return "Roscoe & Burland, On the generalized stress-strain behaviour of wet clay (1968); implicit update "
           "after "
           "Borja & Lee, Comput. Methods Appl. Mech. Engrg 78 (1990) 49-72";
  }
  [[nodiscard]] std::string_view departs() const override {
    return "The same M for all Lode angles; the void ratio is one number for all depths, so that the normal "
           "compression "
           "line of a point follows from its stress; no stress below p_min.";
  }
  [[nodiscard]] std::span<const LawQuantity> quantities() const override {
    static const std::vector<LawQuantity> list = make_quantities();
    return list;
  }
  [[nodiscard]] std::span<const StateVariable> state(const LawParameters&, const Mechanisms&) const override {
    static constexpr std::array list = {
        StateVariable{"p_c", "Pa", "size of the yield surface on the p' axis"}};
    return list;
  }
  [[nodiscard]] LawParameters defaults() const override { return P{}; }

  [[nodiscard]] TreatedAs treated_as() const override { return TreatedAs::sand; }
  [[nodiscard]] bool has_friction() const override { return true; }
  [[nodiscard]] bool has_adhesion() const override { return false; }
  // The friction angle in triaxial compression: sin phi = 3 M / (6 + M).
  [[nodiscard]] ContactStrength contact(const LawParameters& p, const Contact& contact) const override {
    return {std::tan(contact.friction_ratio * std::asin(3.0 * of(p).M / (6.0 + of(p).M))), 0.0};
  }

  [[nodiscard]] double void_ratio(const LawParameters& p) const override { return of(p).e_0; }
  [[nodiscard]] double grain_density(const LawParameters& p) const override { return of(p).rho_grains; }

  [[nodiscard]] std::unique_ptr<const SoilModel> model(const LawParameters& p,
                                                       const Mechanisms&) const override {
    return std::make_unique<Model>(of(p));
  }

  [[nodiscard]] std::vector<Problem> problems(const Setup& setup, std::size_t soil, bool) const override {
    const Soil& clay = setup.soils[soil];
    const P& p = of(clay.parameters);
    const auto own = [&](std::string_view name) { return fmt::format("{}.{}", clay.name, name); };
    if (p.kappa >= p.lambda)
      return {{own("kappa"),
               fmt::format("{} must be below {}", given(setup, own("kappa")), given(setup, own("lambda")))}};
    const double mean = (setup.initial.sigma_v0 + 2.0 * setup.initial.sigma_h0) / 3.0;
    if (mean <= p.p_min)
      return {{own("p_min_kPa"),
               fmt::format("{} must be below the initial mean stress {:.4g} kPa of {} and {}",
                           given(setup, own("p_min_kPa")), mean / 1e3, given(setup, "initial.sigma_v0_kPa"),
                           given(setup, "initial.sigma_h0_kPa"))}};
    const double q = std::abs(setup.initial.sigma_v0 - setup.initial.sigma_h0);
    if (q < p.M * mean) return {};
    return {{"initial.sigma_h0_kPa",
             fmt::format("{} and {} make a stress ratio q/p' of {:.3g}, at or beyond the critical state, {}",
                         given(setup, "initial.sigma_h0_kPa"), given(setup, "initial.sigma_v0_kPa"), q / mean,
                         given(setup, own("M")))}};
  }

 private:
  static const P& of(const LawParameters& p) { return std::get<P>(p); }
};

}  // namespace

const Law& ModifiedCamClayParameters::law() {
  static const ModifiedCamClayLaw law;
  return law;
}

}  // namespace cpt::solver

#include "solver/soils/mohr_coulomb.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "solver/initial_state.hpp"
#include "solver/quantities.hpp"
#include "solver/soils/law_builders.hpp"

namespace cpt::solver {
namespace {

using P = MohrCoulombParameters;

constexpr std::string_view coulomb = "Coulomb (1776), Mohr (1900)";

std::vector<LawQuantity> make_quantities() {
  return {
      parameter<P, &P::E>("E_kPa", "E", kilopascals, 100.0, 1.0e6, "Young's modulus", coulomb),
      parameter<P, &P::nu>("nu", "ν", none, 0.0, 0.49, "Poisson's ratio", coulomb),
      parameter<P, &P::c>("c_kPa", "c", kilopascals, 0.0, 1000.0, "cohesion", coulomb),
      parameter<P, &P::phi>("phi_deg", "φ", degrees, 0.0, 50.0, "friction angle", coulomb),
      parameter<P, &P::psi>("psi_deg", "ψ", degrees, 0.0, 30.0, "dilation angle, at most the friction angle",
                            coulomb),
      parameter<P, &P::sigma_t>("sigma_t_kPa", "σₜ", kilopascals, 0.0, 1000.0,
                                "tensile strength, at most c / tan(phi)", "Rankine"),
      parameter<P, &P::n_0>("n_0", "n₀", none, 0.1, 0.8, "initial porosity", "state of the soil"),
      parameter<P, &P::rho_grains>("rho_grains_kg_per_m3", "ρₛ", kilograms_per_cubic_metre, 2000.0, 3500.0,
                                   "density of the grains", "state of the soil"),
  };
}

using Vector3 = Eigen::Vector3d;

// A plane of the yield surface in principal stresses, tension-positive: normal . sigma <= strength, with
// plastic strain along flow.
struct Plane {
  Vector3 normal, flow;
  double strength;  // [Pa]
};

// The return in principal stresses is linear on every face, edge and corner of the pyramid and its cut-off:
// the planes in force are those whose multipliers are not negative and that leave no other plane violated
// (Koiter 1953; Clausen, Damkilde & Andersen, Comput. Struct. 85 (2007) 1795-1807). Faces are tried first,
// then edges, then corners.
class Model : public SoilModel {
 public:
  explicit Model(const P& p) : E_(p.E), nu_(p.nu) {
    const double G = E_ / (2.0 * (1.0 + nu_)), lame = E_ * nu_ / ((1.0 + nu_) * (1.0 - 2.0 * nu_));
    stiffness_ = 2.0 * G * Eigen::Matrix3d::Identity() + Eigen::Matrix3d::Constant(lame);
    modulus_ = lame + 2.0 * G;
    // sigma_1 >= sigma_2 >= sigma_3: the face and its two neighbours, then the cut-off of each.
    const auto add_face = [&](int larger, int smaller) {
      Plane plane{Vector3::Zero(), Vector3::Zero(), 2.0 * p.c * std::cos(p.phi)};
      plane.normal(larger) = 1.0 + std::sin(p.phi);
      plane.normal(smaller) = -(1.0 - std::sin(p.phi));
      plane.flow(larger) = 1.0 + std::sin(p.psi);
      plane.flow(smaller) = -(1.0 - std::sin(p.psi));
      planes_.push_back(plane);
    };
    add_face(0, 2);
    add_face(0, 1);
    add_face(1, 2);
    for (int k = 0; k < 3; ++k) planes_.push_back({Vector3::Unit(k), Vector3::Unit(k), p.sigma_t});
    for (int a = 0; a < count; ++a) sets_.push_back({a});
    for (int a = 0; a < count; ++a)
      for (int b = a + 1; b < count; ++b) sets_.push_back({a, b});
    for (int a = 0; a < count; ++a)
      for (int b = a + 1; b < count; ++b)
        for (int c = b + 1; c < count; ++c) sets_.push_back({a, b, c});
  }

  [[nodiscard]] double update(const Batch& batch) const override {
    for (std::size_t k = 0; k < batch.size; ++k) update(batch, k);
    return modulus_;
  }
  [[nodiscard]] double poissons_ratio() const override { return nu_; }

 private:
  static constexpr int count = 6;

  void update(const Batch& b, std::size_t k) const {
    const double d_v = b.d_rr[k] + b.d_zz[k] + b.d_tt[k];
    const double lame = stiffness_(0, 1), two_G = stiffness_(0, 0) - lame;
    const double rr = b.s_rr[k] + lame * d_v + two_G * b.d_rr[k];
    const double zz = b.s_zz[k] + lame * d_v + two_G * b.d_zz[k];
    const double tt = b.s_tt[k] + lame * d_v + two_G * b.d_tt[k];
    const double rz = b.s_rz[k] + two_G * b.d_rz[k];
    b.e[k] = (1.0 + b.e[k]) * std::exp(d_v) - 1.0;

    const double centre = 0.5 * (rr + zz), half = 0.5 * (rr - zz), radius = std::hypot(half, rz);
    const double in_plane[2] = {centre + radius, centre - radius};
    // Where the hoop stress ranks among the principal ones.
    const int hoop = tt >= in_plane[0] ? 0 : tt >= in_plane[1] ? 1 : 2;
    const int first = hoop == 0 ? 1 : 0, second = hoop == 2 ? 1 : 2;
    Vector3 sigma;
    sigma(hoop) = tt;
    sigma(first) = in_plane[0];
    sigma(second) = in_plane[1];
    sigma = returned(sigma);
    const double mid = 0.5 * (sigma(first) + sigma(second)),
                 new_radius = 0.5 * (sigma(first) - sigma(second));
    const double cos = radius > 0.0 ? half / radius : 1.0, sin = radius > 0.0 ? rz / radius : 0.0;
    b.s_rr[k] = mid + new_radius * cos;
    b.s_zz[k] = mid - new_radius * cos;
    b.s_tt[k] = sigma(hoop);
    b.s_rz[k] = new_radius * sin;
  }

  [[nodiscard]] bool inside(const Vector3& sigma, double tolerance) const {
    return std::ranges::all_of(
        planes_, [&](const Plane& plane) { return plane.normal.dot(sigma) <= plane.strength + tolerance; });
  }

  [[nodiscard]] Vector3 returned(const Vector3& trial) const {
    if (inside(trial, 0.0) || !trial.allFinite()) return trial;
    const double tolerance = 1e-12 * (trial.cwiseAbs().maxCoeff() + planes_[0].strength);
    for (const std::vector<int>& set : sets_) {
      const auto size = static_cast<Eigen::Index>(set.size());
      Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> step(3, size);
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> system(size, size);
      Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> excess(size);
      for (Eigen::Index j = 0; j < size; ++j)
        step.col(j) = stiffness_ * planes_[static_cast<std::size_t>(set[static_cast<std::size_t>(j)])].flow;
      for (Eigen::Index i = 0; i < size; ++i) {
        const Plane& plane = planes_[static_cast<std::size_t>(set[static_cast<std::size_t>(i)])];
        excess(i) = plane.normal.dot(trial) - plane.strength;
        for (Eigen::Index j = 0; j < size; ++j) system(i, j) = plane.normal.dot(step.col(j));
      }
      const auto factors = system.fullPivLu();
      if (!factors.isInvertible()) continue;
      const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> multipliers = factors.solve(excess);
      if (multipliers.minCoeff() < 0.0) continue;
      const Vector3 sigma = trial - step * multipliers;
      const bool ordered = sigma(0) >= sigma(1) - tolerance && sigma(1) >= sigma(2) - tolerance;
      if (ordered && inside(sigma, tolerance)) return sigma;
    }
    return Vector3::Constant(planes_[3].strength);  // the cut-off's corner, which bounds all
  }

  double E_, nu_, modulus_;
  Eigen::Matrix3d stiffness_;
  std::vector<Plane> planes_;
  std::vector<std::vector<int>> sets_;
};

class MohrCoulombLaw : public Law {
 public:
  [[nodiscard]] std::string_view name() const override { return "mohr_coulomb"; }
  [[nodiscard]] std::string_view title() const override { return "Mohr-Coulomb"; }
  [[nodiscard]] std::string_view models() const override { return "soil with cohesion and friction"; }
  [[nodiscard]] std::string_view source() const override {
    return "Coulomb (1776), Mohr (1900); exact return of Clausen, Damkilde & Andersen, Comput. Struct. 85 "
           "(2007) "
           "1795-1807, as planes in principal stresses (Koiter 1953)";
  }
  [[nodiscard]] std::string_view departs() const override {
    return "Constant elastic moduli; the cut-off of tension is associated.";
  }
  [[nodiscard]] std::span<const LawQuantity> quantities() const override {
    static const std::vector<LawQuantity> list = make_quantities();
    return list;
  }
  [[nodiscard]] LawParameters defaults() const override { return P{}; }

  [[nodiscard]] TreatedAs treated_as() const override { return TreatedAs::sand; }
  [[nodiscard]] bool has_friction() const override { return true; }
  [[nodiscard]] bool has_adhesion() const override { return true; }
  [[nodiscard]] ContactStrength contact(const LawParameters& p, const Contact& contact) const override {
    return {std::tan(contact.friction_ratio * of(p).phi), contact.adhesion_ratio * of(p).c};
  }

  [[nodiscard]] double void_ratio(const LawParameters& p) const override {
    return of(p).n_0 / (1.0 - of(p).n_0);
  }
  [[nodiscard]] double grain_density(const LawParameters& p) const override { return of(p).rho_grains; }

  [[nodiscard]] std::unique_ptr<const SoilModel> model(const LawParameters& p,
                                                       const Mechanisms&) const override {
    return std::make_unique<Model>(of(p));
  }

  [[nodiscard]] std::vector<Problem> problems(const Setup& setup, std::size_t soil, bool) const override {
    const P& p = of(setup.soils[soil].parameters);
    const auto own = [&](std::string_view name) {
      return fmt::format("{}.{}", setup.soils[soil].name, name);
    };
    const auto value = [&](std::string_view name) { return given(setup, own(name)); };
    if (p.phi == 0.0 && p.c == 0.0)
      return {{own("c_kPa"),
               fmt::format("{} with {}: the soil has no strength", value("c_kPa"), value("phi_deg"))}};
    if (p.psi > p.phi)
      return {{own("psi_deg"), fmt::format("{} must be at most {}", value("psi_deg"), value("phi_deg"))}};
    if (p.sigma_t * std::tan(p.phi) > p.c)
      return {{own("sigma_t_kPa"), fmt::format("{} must be at most c / tan(phi) of {} and {}",
                                               value("sigma_t_kPa"), value("c_kPa"), value("phi_deg"))}};
    const double sigma_v = setup.initial.sigma_v0, sigma_h = setup.initial.sigma_h0;
    const double larger = std::max(sigma_v, sigma_h), smaller = std::min(sigma_v, sigma_h);
    const double bears =
        (smaller * (1.0 + std::sin(p.phi)) + 2.0 * p.c * std::cos(p.phi)) / (1.0 - std::sin(p.phi));
    if (larger <= bears) return {};
    return {{"initial.sigma_h0_kPa",
             fmt::format("{} and {}: beside {:.4g} kPa the soil bears at most {:.4g} kPa, with {} and {}",
                         given(setup, "initial.sigma_h0_kPa"), given(setup, "initial.sigma_v0_kPa"),
                         smaller / 1e3, bears / 1e3, value("c_kPa"), value("phi_deg"))}};
  }

 private:
  static const P& of(const LawParameters& p) { return std::get<P>(p); }
};

}  // namespace

const Law& MohrCoulombParameters::law() {
  static const MohrCoulombLaw law;
  return law;
}

}  // namespace cpt::solver

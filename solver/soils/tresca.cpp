#include "solver/soils/tresca.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "solver/constitutive/tresca.hpp"
#include "solver/constitutive/varying_tresca.hpp"
#include "solver/initial_state.hpp"
#include "solver/quantities.hpp"
#include "solver/soils/law_builders.hpp"

namespace cpt::solver {
namespace {

using P = TrescaParameters;

constexpr std::string_view table_3 = "Yost et al. (2023), Table 3";

std::vector<LawQuantity> make_quantities() {
  std::vector<LawQuantity> list = {
      parameter<P, &P::n_0>("n_0", "n₀", none, 0.1, 0.8, "initial porosity of the clay", table_3),
      parameter<P, &P::s_u>("s_u_kPa", "sᵤ", kilopascals, 1.0, 1000.0, "undrained shear strength", table_3),
      parameter<P, &P::G>("G_kPa", "G", kilopascals, 10.0, 1.0e5, "shear modulus of the clay", table_3),
      parameter<P, &P::nu>("nu", "νᵤ", none, 0.3, 0.4999, "undrained Poisson's ratio of the clay",
                           "Yost et al. (2023), section 4.3"),
      parameter<P, &P::rho_grains>("rho_grains_kg_per_m3", "ρₛ,clay", kilograms_per_cubic_metre, 2000.0,
                                   3500.0, "density of the clay's grains",
                                   "typical of clay minerals; not given by Yost et al. (2023)"),
  };
  std::ranges::move(field_of<P, &P::s_u_field>("s_u_field_deviation_kPa", "s_u_field_length_m",
                                               "s_u_field_kind", "s_u_field_seed", kilopascals, 1000.0),
                    std::back_inserter(list));
  return list;
}

class Uniform : public SoilModel {
 public:
  explicit Uniform(const P& parameters) : law_(parameters), nu_(parameters.nu) {}
  [[nodiscard]] double update(const Batch& batch) const override { return law_.update(batch); }
  [[nodiscard]] double poissons_ratio() const override { return nu_; }

 private:
  Tresca law_;
  double nu_;  // [-]
};

// A strength of its own at every point, by depth, strain and rate.
class Varying : public SoilModel {
 public:
  Varying(const P& parameters, const Mechanisms& mechanisms)
      : law_(parameters, mechanisms.strain_softening, mechanisms.rate_dependence),
        parameters_(parameters),
        mechanisms_(mechanisms) {}
  [[nodiscard]] double update(const Batch& batch) const override { return law_.update(batch); }
  [[nodiscard]] double poissons_ratio() const override { return parameters_.nu; }
  [[nodiscard]] PointHistory start(const PointStart& s) const override {
    const double s_u = strength_at(parameters_, mechanisms_, s.depth);
    if (!parameters_.s_u_field.on()) return {s_u};
    // Clay that a field makes weaker than the stresses it lies under would not lie there.
    return {std::max(s_u, std::hypot(0.5 * (s.s_zz - s.s_rr), s.s_rz))};
  }

 private:
  VaryingTresca law_;
  P parameters_;
  Mechanisms mechanisms_;
};

class TrescaLaw : public Law {
 public:
  [[nodiscard]] std::string_view name() const override { return "tresca"; }
  [[nodiscard]] std::string_view title() const override { return "Tresca"; }
  [[nodiscard]] std::string_view models() const override { return "undrained clay"; }
  [[nodiscard]] std::string_view source() const override {
    return "Tresca (1864), exact return to the hexagon; parameters of Yost et al. (2023), Table 3";
  }
  [[nodiscard]] std::string_view departs() const override {
    return "Total stress with a Poisson's ratio just below 0.5, so that the clay is not quite "
           "incompressible.";
  }
  [[nodiscard]] std::span<const LawQuantity> quantities() const override {
    static const std::vector<LawQuantity> list = make_quantities();
    return list;
  }
  [[nodiscard]] std::span<const StateVariable> state(const LawParameters& p,
                                                     const Mechanisms& mechanisms) const override {
    static constexpr std::array list = {
        StateVariable{"s_u0", "Pa", "undrained shear strength before softening and rate"},
        StateVariable{"gamma_p", "-", "accumulated plastic shear strain"}};
    if (!strength_varies(of(p), mechanisms)) return {};
    return list;
  }
  [[nodiscard]] LawParameters defaults() const override { return P{}; }

  [[nodiscard]] TreatedAs treated_as() const override { return TreatedAs::clay; }
  [[nodiscard]] bool has_friction() const override { return false; }
  [[nodiscard]] bool has_adhesion() const override { return true; }
  [[nodiscard]] ContactStrength contact(const LawParameters& p, const Contact& contact) const override {
    return {0.0, contact.adhesion_ratio * of(p).s_u};
  }

  [[nodiscard]] double void_ratio(const LawParameters& p) const override {
    return of(p).n_0 / (1.0 - of(p).n_0);
  }
  [[nodiscard]] double grain_density(const LawParameters& p) const override { return of(p).rho_grains; }

  [[nodiscard]] std::unique_ptr<const SoilModel> model(const LawParameters& p,
                                                       const Mechanisms& mechanisms) const override {
    if (strength_varies(of(p), mechanisms)) return std::make_unique<Varying>(of(p), mechanisms);
    return std::make_unique<Uniform>(of(p));
  }

  [[nodiscard]] std::vector<Problem> problems(const Setup& setup, std::size_t soil,
                                              bool sound_layers) const override;

 private:
  static const P& of(const LawParameters& p) { return std::get<P>(p); }
};

// At the wall its friction comes on top of the stress difference.
std::vector<Problem> wall_shear_problem(const Setup& setup, const Layer& layer, double K_0) {
  const Soil& clay = setup.soils[layer.soil];
  const double coefficient = setup.mechanisms.wall_friction.coefficient;
  for (const double depth : {layer.top, layer.bottom}) {
    const double sigma_v = vertical_stress(setup, -depth);
    const double shear = coefficient * K_0 * sigma_v;
    const double largest = std::hypot(0.5 * (1.0 - K_0) * sigma_v, shear);
    if (largest <= as<P>(clay).s_u) continue;
    const std::string friction = given(setup, "wall_friction.coefficient");
    return {{"wall_friction.coefficient",
             fmt::format(
                 "{} makes a shear stress of {:.3g} kPa at the wall at {} m, with that of K_0 = {:.3g} "
                 "{:.3g} kPa, but Tresca bears at most s_u, and {}",
                 friction, shear / 1e3, depth, K_0, largest / 1e3, given(setup, clay.name + ".s_u_kPa"))}};
  }
  return {};
}

std::vector<Problem> TrescaLaw::problems(const Setup& setup, std::size_t soil, bool sound_layers) const {
  if (!sound_layers) return {};
  const Soil& clay = setup.soils[soil];
  const double K_0 = setup.initial.sigma_h0 / setup.initial.sigma_v0;
  for (const Layer& layer : setup.layers) {
    if (layer.soil != soil) continue;
    const double q = std::abs(1.0 - K_0) * vertical_stress(setup, -layer.bottom);
    if (q <= 2.0 * of(clay.parameters).s_u) {
      const std::vector<Problem> found = wall_shear_problem(setup, layer, K_0);
      if (!found.empty()) return found;
      continue;
    }
    return {
        {"initial.sigma_h0_kPa",
         fmt::format(
             "{} and {} (K_0 = {:.3g}) make a stress difference of {:.3g} kPa at {} m, but Tresca bears at "
             "most 2 s_u, and {}",
             given(setup, "initial.sigma_h0_kPa"), given(setup, "initial.sigma_v0_kPa"), K_0, q / 1e3,
             layer.bottom, given(setup, clay.name + ".s_u_kPa"))}};
  }
  return {};
}

}  // namespace

const Law& TrescaParameters::law() {
  static const TrescaLaw law;
  return law;
}

}  // namespace cpt::solver

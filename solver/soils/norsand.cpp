#include "solver/soils/norsand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "solver/constitutive/critical_state_line.hpp"
#include "solver/constitutive/norsand.hpp"
#include "solver/quantities.hpp"
#include "solver/soils/law_builders.hpp"

namespace cpt::solver {
namespace {

using P = NorSandParameters;

constexpr std::string_view table_1 = "Yost et al. (2023), Table 1";
constexpr std::string_view table_2 = "Yost et al. (2023), Table 2";
constexpr std::string_view norsand_book = "Jefferies & Been (2015)";
constexpr std::string_view numerical = "numerical setting";

std::vector<LawQuantity> make_quantities() {
  std::vector<LawQuantity> list = {
      parameter<P, &P::e_cs0>("e_cs0", "e_cs,0", none, 0.5, 1.5, "critical state void ratio at p' = 0",
                              table_2),
      parameter<P, &P::lambda>("lambda", "λ", none, 0.001, 0.1, "slope of the critical state line", table_2),
      parameter<P, &P::m>("m", "m", none, 0.2, 1.5, "exponent of the critical state line", table_2),
      parameter<P, &P::G_ref>("G_ref", "G_ref", none, 50.0, 5000.0, "shear modulus factor", table_2),
      parameter<P, &P::b>("b", "b", none, 0.0, 1.0, "exponent of the stiffness relation", table_2),
      parameter<P, &P::e_min_star>("e_min_star", "e*ₘᵢₙ", none, 0.0, 0.5,
                                   "void ratio at which volumetric strains are negligible", table_2),
      parameter<P, &P::phi_cs>("phi_cs_deg", "φ_cs", degrees, 20.0, 45.0, "critical state friction angle",
                               table_2),
      parameter<P, &P::N>("N", "N", none, 0.0, 0.6, "dilatancy (volumetric coupling) parameter", table_2),
      parameter<P, &P::chi_tc>("chi_tc", "χ", none, 0.5, 8.0, "dilatancy coefficient in triaxial compression",
                               table_2),
      parameter<P, &P::nu>("nu", "ν", none, 0.0, 0.45, "Poisson's ratio of the sand", table_2),
      parameter<P, &P::H>("H", "H", none, 1.0, 2000.0, "hardening modulus", table_2),
      parameter<P, &P::D_r>("D_r_percent", "Dᵣ", percent, 1.0, 100.0, "relative density",
                            "Yost et al. (2023), sections 3.3 and 5"),
      parameter<P, &P::e_min>("e_min", "eₘᵢₙ", none, 0.2, 1.2, "minimum void ratio", table_1),
      parameter<P, &P::e_max>("e_max", "eₘₐₓ", none, 0.3, 2.0, "maximum void ratio", table_1),
      parameter<P, &P::rho_grains>("rho_grains_kg_per_m3", "ρₛ", kilograms_per_cubic_metre, 2000.0, 3500.0,
                                   "density of the sand's grains", table_1),
      alternative<P, &P::start>(
          "start", "start", {"initial_stress", "at_rest"},
          "stress that the initial yield surface passes through: the initial one, or that "
          "at rest, K_0 = 1 - sin(phi_cs), under the same vertical stress",
          norsand_book),
      parameter<P, &P::OCR>("OCR", "OCR", none, 1.0, 20.0, "initial p_i over that of this yield surface",
                            norsand_book),
      parameter<P, &P::cap_ratio>("cap_ratio", "cap", none, 1.0, 10.0,
                                  "inner cap: largest p_i over its limit at maximum dilatancy", norsand_book),
      parameter<P, &P::hardening_exponent>("hardening_exponent", "n_H", none, 0.0, 2.0,
                                           "exponent of p / p_i in the hardening rule", norsand_book),
      parameter<P, &P::p_min>("p_min_kPa", "pₘᵢₙ", kilopascals, 0.01, 5.0,
                              "mean stress below which the sand carries none", numerical),
      alternative<P, &P::flow>("flow", "flow rule", {"radial", "associated"},
                               "direction of deviatoric plastic flow", norsand_book),
      parameter<P, &P::substep_tolerance>("substep_tolerance", "tol", none, 1.0e-9, 1.0e-2,
                                          "relative error of stress and p_i allowed in one sub-step",
                                          numerical),
  };
  std::ranges::move(field_of<P, &P::D_r_field>("D_r_field_deviation_percent", "D_r_field_length_m",
                                               "D_r_field_kind", "D_r_field_seed", percent, 100.0),
                    std::back_inserter(list));
  return list;
}

// Initial p_i [Pa].
double image_pressure_at(const PointStart& s, const P& sand, const NorSand& law) {
  const double p_i = law.initial_image_pressure(s.s_rr, s.s_zz, s.s_tt, s.s_rz, s.e);
  if (sand.start == SandStart::initial_stress) return p_i;
  const double at_rest = (1.0 - std::sin(sand.phi_cs)) * s.s_zz;
  return std::max(p_i, law.initial_image_pressure(at_rest, s.s_zz, at_rest, 0.0, s.e));
}

class Model : public SoilModel {
 public:
  Model(const P& parameters, const GrainCrushing& crushing)
      : law_(parameters, crushing), parameters_(parameters) {}
  [[nodiscard]] double update(const Batch& batch) const override { return law_.update(batch); }
  [[nodiscard]] double poissons_ratio() const override { return parameters_.nu; }
  [[nodiscard]] std::int32_t safeguarded(const Batch& batch, std::int32_t count) const override {
    std::int32_t held = 0;
    for (std::int32_t k = 0; k < count; ++k)
      if (law_.evaluate({batch.s_rr[k], batch.s_zz[k], batch.s_tt[k], batch.s_rz[k]}, batch.e[k],
                        batch.h_0[k])
              .limited)
        ++held;
    return held;
  }
  [[nodiscard]] PointHistory start(const PointStart& s) const override {
    return {image_pressure_at(s, parameters_, law_)};
  }

 private:
  NorSand law_;
  P parameters_;
};

class NorSandLaw : public Law {
 public:
  [[nodiscard]] std::string_view name() const override { return "norsand"; }
  [[nodiscard]] std::string_view title() const override { return "NorSand"; }
  [[nodiscard]] std::string_view models() const override { return "drained sand"; }
  [[nodiscard]] std::string_view source() const override {
    return "Jefferies & Been, Soil Liquefaction, 2nd ed. (2015), chapter 3 and appendix C; exponential "
           "critical state "
           "line of Li & Wang (1998); parameters of Yost et al. (2023), Table 2";
  }
  [[nodiscard]] std::string_view departs() const override {
    return "Associated deviatoric flow with a rounded corner by default, an inner cap on the image pressure, "
           "a largest "
           "exponent in the hardening rule, no stress below p_min; no softening term of undrained loading.";
  }
  [[nodiscard]] std::span<const LawQuantity> quantities() const override {
    static const std::vector<LawQuantity> list = make_quantities();
    return list;
  }
  [[nodiscard]] std::span<const StateVariable> state(const LawParameters&, const Mechanisms&) const override {
    static constexpr std::array list = {StateVariable{"p_i", "Pa", "image pressure"}};
    return list;
  }
  [[nodiscard]] LawParameters defaults() const override { return P{}; }

  [[nodiscard]] TreatedAs treated_as() const override { return TreatedAs::sand; }
  [[nodiscard]] bool has_friction() const override { return true; }
  [[nodiscard]] bool has_adhesion() const override { return false; }
  [[nodiscard]] ContactStrength contact(const LawParameters& p, const Contact& contact) const override {
    return {std::tan(contact.friction_ratio * of(p).phi_cs), 0.0};
  }

  [[nodiscard]] double void_ratio(const LawParameters& p) const override {
    return of(p).e_max - of(p).D_r * (of(p).e_max - of(p).e_min);
  }
  [[nodiscard]] double grain_density(const LawParameters& p) const override { return of(p).rho_grains; }
  [[nodiscard]] bool density_varies() const override { return true; }
  // Between e_min and e_max where a mechanism or a random field acts.
  [[nodiscard]] double void_ratio_at(const Setup& setup, const LawParameters& p, const LeftBehind& left,
                                     double depth) const override {
    const P& sand = of(p);
    const double e = void_ratio(p);
    const double denser = setup.mechanisms.surface_compaction.at(depth) +
                          setup.mechanisms.density_lens.at(depth) +
                          setup.mechanisms.density_trend.at(depth, setup.penetrometer.final_depth) +
                          (sand.D_r_field.on() ? sand.D_r_field.at(sand.D_r, depth) - sand.D_r : 0.0);
    const double change = left.void_ratio(depth) - denser * (sand.e_max - sand.e_min);
    return change == 0.0 ? e : std::clamp(e + change, std::min(e, sand.e_min), std::max(e, sand.e_max));
  }

  [[nodiscard]] double critical_void_ratio(const LawParameters& p, double mean_stress) const override {
    return CriticalStateLine(of(p)).void_ratio(mean_stress);
  }

  [[nodiscard]] std::unique_ptr<const SoilModel> model(const LawParameters& p,
                                                       const Mechanisms& mechanisms) const override {
    return std::make_unique<Model>(of(p), mechanisms.grain_crushing);
  }

  [[nodiscard]] std::vector<Problem> problems(const Setup& setup, std::size_t soil, bool) const override;

 private:
  static const P& of(const LawParameters& p) { return std::get<P>(p); }
};

std::vector<Problem> NorSandLaw::problems(const Setup& setup, std::size_t soil, bool) const {
  const LawParameters& parameters = setup.soils[soil].parameters;
  const P& sand = of(parameters);
  const auto own = [&](std::string_view name) { return fmt::format("{}.{}", setup.soils[soil].name, name); };
  const auto value = [&](std::string_view name) { return given(setup, own(name)); };
  if (sand.e_min >= sand.e_max)
    return {{own("e_min"), fmt::format("{} must be below {}", value("e_min"), value("e_max"))}};
  const double e = void_ratio(parameters);
  if (e <= sand.e_min_star)
    return {{own("e_min_star"), fmt::format("{} must be below the initial void ratio {:.4f} at {}",
                                            value("e_min_star"), e, value("D_r_percent"))}};

  const double sigma_v = setup.initial.sigma_v0, sigma_h = setup.initial.sigma_h0;
  const std::string given_v = given(setup, "initial.sigma_v0_kPa"),
                    given_h = given(setup, "initial.sigma_h0_kPa");
  const double p = (sigma_v + 2.0 * sigma_h) / 3.0;
  if (p <= sand.p_min)
    return {{own("p_min_kPa"), fmt::format("{} must be below the initial mean stress {:.4g} kPa of {} and {}",
                                           value("p_min_kPa"), p / 1e3, given_v, given_h)}};
  const double e_c = CriticalStateLine(sand).void_ratio(p);
  if (e_c <= sand.e_min_star)
    return {{own("e_cs0"),
             fmt::format("the critical state void ratio at the initial stress is {:.4f} with {}, {} and "
                         "{}: it must exceed {}",
                         e_c, value("e_cs0"), value("lambda"), value("m"), value("e_min_star"))}};

  // NorSand's largest image pressure at this density bounds the stress ratio, Jefferies & Been (2015).
  const NorSand law(sand);
  const PointStart start{0.0, -sigma_h, -sigma_v, -sigma_h, 0.0, e};
  const double p_i = image_pressure_at(start, sand, law) / sand.OCR;
  const NorSandState state = law.evaluate({-sigma_h, -sigma_v, -sigma_h, 0.0}, e, p_i);
  if (p_i < state.p_mx) return {};
  return {
      {"initial.sigma_h0_kPa",
       fmt::format("{} and {} (K_0 = {:.3g}) make a stress ratio q/p' of {:.3g}, but this sand bears at most "
                   "{:.3g} (state parameter {:+.3f} at {}, {}, {})",
                   given_h, given_v, sigma_h / sigma_v, state.q / state.p,
                   std::max(0.0, state.M_i * (1.0 + std::log(state.p_mx / state.p))), state.psi,
                   value("D_r_percent"), value("phi_cs_deg"), value("chi_tc"))}};
}

}  // namespace

const Law& NorSandParameters::law() {
  static const NorSandLaw law;
  return law;
}

}  // namespace cpt::solver

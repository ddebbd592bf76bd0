#include "solver/soils/elastic_soil.hpp"

#include "solver/soils/elastic.hpp"
#include "solver/soils/law_builders.hpp"

namespace cpt::solver {
namespace {

using P = ElasticSoilParameters;

constexpr std::string_view hooke = "Hooke (1678)";

class ElasticSoilLaw : public Law {
 public:
  [[nodiscard]] std::string_view name() const override { return "elastic"; }
  [[nodiscard]] std::string_view title() const override { return "Linear elasticity"; }
  [[nodiscard]] std::string_view models() const override { return "soil that never yields"; }
  [[nodiscard]] std::string_view source() const override { return hooke; }
  [[nodiscard]] std::string_view departs() const override { return "Stresses are small beside E only."; }
  [[nodiscard]] std::span<const LawQuantity> quantities() const override {
    static const std::vector<LawQuantity> list = {
        parameter<P, &P::E>("E_kPa", "E", kilopascals, 100.0, 1.0e6, "Young's modulus", hooke),
        parameter<P, &P::nu>("nu", "ν", none, 0.0, 0.49, "Poisson's ratio", hooke),
        parameter<P, &P::e_0>("e_0", "e₀", none, 0.2, 3.0, "void ratio before the push", "state of the soil"),
        parameter<P, &P::rho_grains>("rho_grains_kg_per_m3", "ρₛ", kilograms_per_cubic_metre, 2000.0, 3500.0,
                                     "density of the grains", "state of the soil"),
    };
    return list;
  }
  [[nodiscard]] LawParameters defaults() const override { return P{}; }

  [[nodiscard]] TreatedAs treated_as() const override { return TreatedAs::sand; }
  [[nodiscard]] bool has_friction() const override { return false; }
  [[nodiscard]] bool has_adhesion() const override { return false; }
  [[nodiscard]] ContactStrength contact(const LawParameters&, const Contact&) const override { return {}; }

  [[nodiscard]] double void_ratio(const LawParameters& p) const override { return of(p).e_0; }
  [[nodiscard]] double grain_density(const LawParameters& p) const override { return of(p).rho_grains; }

  [[nodiscard]] std::unique_ptr<const SoilModel> model(const LawParameters& p,
                                                       const Mechanisms&) const override {
    return elastic_soil(of(p).E, of(p).nu);
  }

  [[nodiscard]] std::vector<Problem> problems(const Setup&, std::size_t, bool) const override { return {}; }

 private:
  static const P& of(const LawParameters& p) { return std::get<P>(p); }
};

}  // namespace

const Law& ElasticSoilParameters::law() {
  static const ElasticSoilLaw law;
  return law;
}

}  // namespace cpt::solver

#include "parameters/calibration/fit_parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace cpt::calibration {
namespace {

struct Listed {
  std::string_view name;
  bool logarithmic;
};
constexpr std::array<Listed, 10> listed = {{{"e_cs0", false},
                                            {"lambda", true},
                                            {"m", false},
                                            {"G_ref", true},
                                            {"b", false},
                                            {"phi_cs_deg", false},
                                            {"N", false},
                                            {"chi_tc", false},
                                            {"nu", false},
                                            {"H", true}}};

}  // namespace

double FitParameter::scaled(double study_value) const {
  return logarithmic ? std::log(study_value) : study_value;
}

double FitParameter::study_value(double value) const { return logarithmic ? std::exp(value) : value; }

double FitParameter::of(const solver::NorSandParameters& sand) const {
  return quantity->get(sand) / quantity->scale;
}

void FitParameter::set(solver::NorSandParameters& sand, double study_value) const {
  solver::LawParameters changed = sand;
  quantity->set(changed, study_value * quantity->scale);
  sand = std::get<solver::NorSandParameters>(changed);
}

std::span<const FitParameter> fit_parameters() {
  static const auto list = [] {
    std::vector<FitParameter> made;
    const auto quantities = solver::NorSandParameters::law().quantities();
    for (const Listed& one : listed)
      made.push_back(
          {&*std::ranges::find(quantities, one.name, &solver::LawQuantity::name), one.logarithmic});
    return made;
  }();
  return list;
}

const FitParameter* find_fit_parameter(std::string_view name) {
  for (const FitParameter& parameter : fit_parameters())
    if (parameter.quantity->name == name) return &parameter;
  return nullptr;
}

}  // namespace cpt::calibration

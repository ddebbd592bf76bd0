#include "parameters/unknown_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "parameters/nearest_name.hpp"
#include "parameters/quantity_synonyms.hpp"
#include "solver/quantities.hpp"
#include "solver/soils/law.hpp"

namespace cpt::parameters {
namespace {

using solver::Law, solver::Setup, solver::Soil;

std::string_view parameter_of(std::string_view name) { return name.substr(name.find('.') + 1); }

bool has(const Law& law, std::string_view parameter) {
  return std::ranges::find(law.quantities(), parameter, &solver::LawQuantity::name) != law.quantities().end();
}

// "phi" of "phi_cs_deg".
std::string stem(std::string_view parameter) { return squeezed(parameter.substr(0, parameter.find('_'))); }

class Meant {
 public:
  Meant(std::string_view name, const Setup& setup, bool layers_known)
      : setup_(setup), name_(name), near_(nearest_quantity(name, setup)) {
    for (std::size_t k = 0; k < setup.soils.size(); ++k)
      if (!layers_known || solver::contains(setup, k)) soils_.push_back(&setup.soils[k]);
    const std::size_t dot = name.find('.');
    if (dot != std::string_view::npos) group_ = name.substr(0, dot);
    own_ = std::ranges::find(setup.soils, group_, &Soil::name);
    parameter_ = parameter_of(name);
    const bool of_a_law =
        std::ranges::any_of(solver::all_laws(), [&](auto law) { return has(*law, parameter_); });
    if (!of_a_law) parameter_ = near_of_soil() ? parameter_of(near_) : std::string_view();
  }

  [[nodiscard]] std::string text() const {
    const std::string near = near_.empty() ? "" : fmt::format("did you mean {}?", near_);
    if (parameter_.empty()) return near;
    if (own_ == setup_.soils.end()) return of_another_soil(near);
    if (near_.substr(0, near_.find('.')) != group_) return of_other_laws();
    // One of its own law; the name may be one of another law all the same.
    if (parameter_ == parameter_of(near_)) return near;
    return stem(parameter_) == stem(parameter_of(near_)) ? near + " " + of_other_laws() : of_other_laws();
  }

 private:
  [[nodiscard]] bool near_of_soil() const {
    return std::ranges::any_of(setup_.soils,
                               [&](const Soil& soil) { return near_.starts_with(soil.name + '.'); });
  }

  // No soil is called so: the nearest that has the parameter, else all that have it.
  [[nodiscard]] std::string of_another_soil(const std::string& near) const {
    std::vector<std::string_view> soils;
    for (const Soil* soil : soils_)
      if (has(solver::law_of(*soil), parameter_)) soils.push_back(soil->name);
    if (soils.empty()) return laws();
    if (const std::string_view soil = nearest_name(group_, soils); !soil.empty()) soils = {soil};
    if (!near_.empty() && !near_of_soil()) return near;
    std::string names;
    for (const std::string_view soil : soils)
      names += fmt::format("{}{}.{}", names.empty() ? "" : " or ", soil, parameter_);
    return fmt::format("did you mean {}?", names);
  }

  [[nodiscard]] std::string of_other_laws() const {
    return fmt::format("{}; {} is of {}", laws(), group_, solver::law_of(*own_).name());
  }

  // "nu is a parameter of norsand (sand), tresca (no soil of the study)"
  [[nodiscard]] std::string laws() const {
    std::string list;
    for (const Law* law : solver::all_laws()) {
      if (!has(*law, parameter_)) continue;
      std::string soils;
      for (const Soil* soil : soils_)
        if (&solver::law_of(*soil) == law) soils += (soils.empty() ? "" : ", ") + soil->name;
      list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", law->name(),
                          soils.empty() ? "no soil here" : soils);
    }
    return fmt::format("{} is a parameter of {}", parameter_, list);
  }

  const Setup& setup_;
  std::string_view name_, near_, group_, parameter_;
  std::vector<const Soil*> soils_;
  std::vector<Soil>::const_iterator own_;
};

}  // namespace

std::string meant_quantity(std::string_view name, const Setup& setup, bool layers_known) {
  return Meant(name, setup, layers_known).text();
}

}  // namespace cpt::parameters

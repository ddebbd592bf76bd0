#include "parameters/read_soils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "parameters/study_keys.hpp"
#include "solver/mechanisms/catalogue.hpp"
#include "solver/quantities.hpp"
#include "solver/soils/law.hpp"

namespace cpt::parameters {
namespace {

bool acceptable(const Member& soil, ErrorList& errors) {
  const std::string& name = soil.key;
  const std::string key = joined("soils", name);
  const bool plain =
      !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
      std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
  if (!plain)
    errors.add(soil.place, key, fmt::format("\"{}\" is no name for a soil", name),
               "a letter first, then letters, digits and _");
  else if (is_group_beside_soils(name) || name == "surcharge" || name == "windows" || name == "layers")
    errors.add(soil.place, key, fmt::format("\"{}\" means something else in a study", name),
               "call the soil otherwise");
  else
    return true;
  return false;
}

// Nothing after an error.
std::optional<std::string> law_of(const Member& soil, std::span<const std::string_view> laws,
                                  ErrorList& errors) {
  const std::string key = joined("soils", soil.key);
  if (soil.value.kind != Value::Kind::table) {
    errors.add(soil.place, key, fmt::format("must be a table, not {}", to_string(soil.value.kind)),
               fmt::format("such as [soils.{}] with law = \"{}\"", soil.key, laws.front()));
    return std::nullopt;
  }
  refuse_unknown_keys(
      soil.value, key, known_names(study_keys(), "soils"), errors,
      fmt::format("parameters go under [fixed] or [parameters]: \"{}.NAME\" = ...", soil.key));
  return name_field(soil.value, key, "law", true, laws, errors);
}

}  // namespace

bool is_group_beside_soils(std::string_view name) {
  return std::ranges::any_of(solver::all_quantities(), [&](const solver::Quantity& quantity) {
    return quantity.soil.empty() && quantity.name.substr(0, quantity.name.find('.')) == name;
  });
}

bool SoilDoubts::about(std::string_view name, const solver::Setup& setup) const {
  if (named.contains(std::string(name))) return true;
  return any && !is_group_beside_soils(name) &&
         std::ranges::find(setup.soils, name, &solver::Soil::name) == setup.soils.end();
}

void read_soils(const Value& root, solver::Setup& setup, SoilDoubts& doubts, ErrorList& errors) {
  const auto nothing_known = [&] {
    doubts.any = true;
    for (const solver::Soil& soil : setup.soils) doubts.named.insert(soil.name);
  };
  const Value* table = section(root, "soils", errors);
  const bool elsewhere = errors.is_meant(root, "soils");
  if (table == nullptr) {
    if (elsewhere || root.find("soils") != nullptr) nothing_known();
    return;
  }
  if (table->members.empty()) {
    errors.add(table->place, "soils", "names no soil",
               "add [soils.NAME] with its law, or leave the section out");
    return nothing_known();
  }
  doubts.any = elsewhere;
  std::vector<std::string_view> laws;
  for (const solver::Law* law : solver::all_laws()) laws.push_back(law->name());
  std::vector<solver::Soil> soils;
  for (const Member& member : table->members) {
    if (!acceptable(member, errors)) {
      doubts.any = true;
      continue;
    }
    const std::optional<std::string> law = law_of(member, laws, errors);
    if (!law) doubts.named.insert(member.key);
    soils.push_back({member.key, solver::find_law(law ? *law : laws.front())->defaults()});
  }
  if (soils.empty()) return nothing_known();
  setup.soils = std::move(soils);
}

}  // namespace cpt::parameters

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

}  // namespace

bool is_group_beside_soils(std::string_view name) {
  return std::ranges::any_of(solver::all_quantities(), [&](const solver::Quantity& quantity) {
    return quantity.soil.empty() && quantity.name.substr(0, quantity.name.find('.')) == name;
  });
}

bool read_soils(const Value& root, solver::Setup& setup, ErrorList& errors) {
  const Value* table = section(root, "soils", errors);
  if (table == nullptr) return root.find("soils") == nullptr;
  const std::size_t before = errors.size();
  std::vector<std::string_view> laws;
  for (const solver::Law* law : solver::all_laws()) laws.push_back(law->name());
  std::vector<solver::Soil> soils;
  for (const Member& member : table->members) {
    const std::string key = joined("soils", member.key);
    if (!acceptable(member, errors)) continue;
    if (member.value.kind != Value::Kind::table) {
      errors.add(member.place, key, fmt::format("must be a table, not {}", to_string(member.value.kind)),
                 fmt::format("such as [soils.{}] with law = \"{}\"", member.key, laws.front()));
      continue;
    }
    refuse_unknown_keys(
        member.value, key, known_names(study_keys(), "soils"), errors,
        fmt::format("parameters go under [fixed] or [parameters]: \"{}.NAME\" = ...", member.key));
    if (const auto name = name_field(member.value, key, "law", true, laws, errors))
      soils.push_back({member.key, solver::find_law(*name)->defaults()});
  }
  if (table->members.empty())
    errors.add(table->place, "soils", "names no soil",
               "add [soils.NAME] with its law, or leave the section out");
  if (errors.size() != before) return false;
  setup.soils = std::move(soils);
  return true;
}

}  // namespace cpt::parameters

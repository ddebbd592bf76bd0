#include <utility>

#include "solver/soils/law.hpp"

namespace cpt::solver {
namespace {

template <std::size_t... I>
std::array<const Law*, sizeof...(I)> list_of(std::index_sequence<I...>) {
  return {&std::variant_alternative_t<I, LawParameters>::law()...};
}

}  // namespace

std::span<const Law* const> all_laws() {
  static const auto list = list_of(std::make_index_sequence<std::variant_size_v<LawParameters>>());
  return list;
}

const Law* find_law(std::string_view name) {
  for (const Law* law : all_laws())
    if (law->name() == name) return law;
  return nullptr;
}

const Law& law_of(const LawParameters& parameters) { return *all_laws()[parameters.index()]; }

const Law& law_of(const Soil& soil) { return law_of(soil.parameters); }

}  // namespace cpt::solver

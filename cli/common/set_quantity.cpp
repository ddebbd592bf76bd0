#include "cli/common/set_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/common/study_argument.hpp"
#include "parameters/nearest_name.hpp"
#include "parameters/unknown_quantity.hpp"
#include "parameters/written_number.hpp"
#include "solver/quantities.hpp"

namespace cpt::cli {
namespace {

double parse_value(const solver::Quantity& quantity, std::string_view text) {
  if (!quantity.choices.empty()) {
    const auto found = std::find(quantity.choices.begin(), quantity.choices.end(), text);
    if (found == quantity.choices.end()) {
      const std::string_view near = parameters::nearest_name(text, quantity.choices);
      throw BadInput(fmt::format("{} = {}: must be one of {}{}", quantity.name, text,
                                 fmt::join(quantity.choices, ", "),
                                 near.empty() ? "" : fmt::format("; did you mean {}?", near)));
    }
    return static_cast<double>(found - quantity.choices.begin());
  }
  const std::optional<double> number = parameters::written_number(text);
  if (!number) {
    const std::string hint = parameters::number_hint(text);
    throw BadInput(
        fmt::format("{} = {}: not a number{}", quantity.name, text, hint.empty() ? "" : "; " + hint));
  }
  const double value = *number;
  // Negated, so that a value that is not a number fails too.
  if (!(value >= quantity.min && value <= quantity.max) || (quantity.integer && value != std::floor(value)))
    throw BadInput(fmt::format("{} = {}: must be {}{} to {} {}", quantity.name, text,
                               quantity.integer ? "whole, " : "", quantity.min, quantity.max, quantity.unit));
  return value;
}

}  // namespace

void set_quantity(solver::Setup& setup, std::string_view setting, std::string_view group) {
  const auto equals = setting.find('=');
  if (equals == std::string_view::npos) throw BadInput(fmt::format("--set {}: must be NAME=VALUE", setting));
  const std::string_view name = setting.substr(0, equals);
  const solver::Quantity* quantity = solver::find_quantity(name, setup);
  if (quantity == nullptr) {
    const std::string meant = parameters::meant_quantity(name, setup, group.empty());
    throw BadInput(fmt::format("--set {}: there is no quantity {}{}{}", setting, name,
                               meant.empty() ? "" : "; ", meant));
  }
  if (!name.starts_with(group))
    throw BadInput(fmt::format("--set {}: only quantities named {}... play a part here", setting, group));
  quantity->set_value(setup, parse_value(*quantity, setting.substr(equals + 1)));
}

}  // namespace cpt::cli

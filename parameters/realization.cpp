#include "parameters/realization.hpp"

#include <limits>

namespace cpt::parameters {

std::string_view to_string(Side side) {
  switch (side) {
    case Side::baseline:
      return "baseline";
    case Side::lower:
      return "lower";
    case Side::upper:
      return "upper";
    case Side::point:
      return "point";
    case Side::repeat:
      return "repeat";
  }
  return "";
}

std::string_view parameter_name(const Study& study, const Realization& realization) {
  if (realization.point >= 0) return study.points[static_cast<std::size_t>(realization.point)].name;
  if (realization.row < 0) return "";
  return study.rows[static_cast<std::size_t>(realization.row)].quantity->name;
}

double parameter_value(const Study& study, const Realization& realization) {
  if (realization.row < 0) return std::numeric_limits<double>::quiet_NaN();
  const Row& row = study.rows[static_cast<std::size_t>(realization.row)];
  switch (realization.side) {
    case Side::lower:
      return row.lower;
    case Side::upper:
      return row.upper;
    default:
      return row.baseline;
  }
}

std::string value_text(const Study& study, const Realization& realization) {
  if (realization.point < 0) {
    if (realization.row < 0) return "";
    return study.rows[static_cast<std::size_t>(realization.row)].quantity->format(
        parameter_value(study, realization));
  }
  std::string text;
  for (const Change& change : study.points[static_cast<std::size_t>(realization.point)].changes)
    text += std::string(text.empty() ? "" : ", ") + std::string(change.quantity->name) + " = " +
            change.quantity->format(change.value);
  return text;
}

solver::Setup make_setup(const Study& study, const Realization& realization) {
  solver::Setup setup = study.baseline;
  if (realization.row >= 0)
    study.rows[static_cast<std::size_t>(realization.row)].quantity->set_value(
        setup, parameter_value(study, realization));
  if (realization.point >= 0)
    for (const Change& change : study.points[static_cast<std::size_t>(realization.point)].changes)
      change.quantity->set_value(setup, change.value);
  return setup;
}

std::string settings_text(const Study& study, const Realization& realization) {
  return solver::canonical_text(make_setup(study, realization));
}

}  // namespace cpt::parameters

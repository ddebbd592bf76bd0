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
  }
  return "";
}

std::string_view parameter_name(const Study& study, const Realization& realization) {
  return realization.row < 0 ? "" : study.rows[static_cast<std::size_t>(realization.row)].quantity->name;
}

double parameter_value(const Study& study, const Realization& realization) {
  if (realization.row < 0) return std::numeric_limits<double>::quiet_NaN();
  const Row& row = study.rows[static_cast<std::size_t>(realization.row)];
  switch (realization.side) {
    case Side::baseline:
      return row.baseline;
    case Side::lower:
      return row.lower;
    case Side::upper:
      return row.upper;
  }
  return row.baseline;
}

solver::Setup make_setup(const Study& study, const Realization& realization) {
  solver::Setup setup = study.baseline;
  if (realization.row >= 0)
    study.rows[static_cast<std::size_t>(realization.row)].quantity->set_value(
        setup, parameter_value(study, realization));
  return setup;
}

std::string settings_text(const Study& study, const Realization& realization) {
  return solver::canonical_text(make_setup(study, realization));
}

}  // namespace cpt::parameters

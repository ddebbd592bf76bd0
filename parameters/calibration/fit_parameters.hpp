// The parameters of NorSand that laboratory tests may tell.
#pragma once

#include <span>
#include <string_view>

#include "solver/soils/law.hpp"

namespace cpt::calibration {

/// A parameter on the scale on which it is fitted: its study unit, or the logarithm of it where only its
/// order of magnitude is known beforehand.
struct FitParameter {
  const solver::LawQuantity* quantity;  ///< name, unit and valid range
  bool logarithmic;

  [[nodiscard]] double lower() const { return scaled(quantity->min); }
  [[nodiscard]] double upper() const { return scaled(quantity->max); }
  [[nodiscard]] double range() const { return upper() - lower(); }
  [[nodiscard]] double scaled(double study_value) const;
  [[nodiscard]] double study_value(double scaled) const;

  /// In the study's unit.
  [[nodiscard]] double of(const solver::NorSandParameters& sand) const;
  void set(solver::NorSandParameters& sand, double study_value) const;
};

/// In the law's order: e_cs0, lambda, m, G_ref, b, phi_cs_deg, N, chi_tc, nu, H.
[[nodiscard]] std::span<const FitParameter> fit_parameters();
/// nullptr if there is none of that name.
[[nodiscard]] const FitParameter* find_fit_parameter(std::string_view name);

}  // namespace cpt::calibration

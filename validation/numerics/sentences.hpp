// What a study of the numerics found, in sentences.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "results/statistics/discretization_error.hpp"
#include "validation/numerics/study.hpp"

namespace cpt::validation::numerics {

/// Three meshes of a study and what they say of q_c in a window.
struct MeshTriple {
  std::array<double, 3> refinement;           ///< finest first
  std::array<results::MeshResult, 3> meshes;  ///< h is 1 / refinement; q_c in kPa
  results::DiscretizationError error;
};

/// Every three neighbouring meshes that are completed, finest first.
[[nodiscard]] std::vector<MeshTriple> mesh_triples(const NumericsStudy& study, std::string_view window);

/// What the change of one setting from the baseline to the most accurate value that is completed does to a
/// channel's average.
struct Effect {
  const Setting* setting;
  double value;   ///< the most accurate one
  double change;  ///< [-] against the reference; 0 within rounding
  bool told;      ///< larger than the repeats explain; false without repeats
};

/// Largest change first; settings with nothing more accurate than the baseline are left out.
[[nodiscard]] std::vector<Effect> effects(const NumericsStudy& study, std::string_view window,
                                          std::size_t channel = tip_resistance);

/// Markdown list: which setting moves q_c in a window by how much, what is noise, what the meshes converge
/// to.
[[nodiscard]] std::string sentences(const NumericsStudy& study, std::string_view window);

/// "-4.2 %", with so many decimals.
[[nodiscard]] std::string percent(double ratio, int digits = 1);

/// "0.02 m/s": a value of a setting with its unit.
[[nodiscard]] std::string value_text(const Setting& setting, double value);

/// "cell size", "mass scaling": a setting in words.
[[nodiscard]] std::string words(const Setting& setting);

}  // namespace cpt::validation::numerics

// Study texts for the tests.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "parameters/read_study.hpp"

namespace cpt::parameters {

inline const std::string window = "[[windows]]\nname = \"sand\"\nfrom_m = 0.5054\nto_m = 0.5255\n";

/// A sound study of homogeneous sand at the quick preset, with more text at its end.
inline std::string sand_study(const std::string& more) {
  return "profile = \"homogeneous_sand\"\npreset = \"quick\"\n" + window + more;
}

/// The study, or a failed test that prints the errors.
inline Study study_of(const std::string& toml, const std::filesystem::path& file = "/studies/sand.toml") {
  StudyOrErrors result = parse_study(toml, file);
  if (const auto* errors = std::get_if<std::vector<StudyError>>(&result)) {
    ADD_FAILURE() << format(*errors);
    return {};
  }
  return std::get<Study>(std::move(result));
}

/// The errors; none for a sound study.
inline std::vector<StudyError> errors_of(const std::string& toml) {
  const StudyOrErrors result = parse_study(toml, "/studies/sand.toml");
  const auto* errors = std::get_if<std::vector<StudyError>>(&result);
  return errors ? *errors : std::vector<StudyError>();
}

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace cpt::parameters

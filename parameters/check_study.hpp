// Checks of a study as a whole: physics of every realization, windows against the push.
#pragma once

#include <vector>

#include "parameters/fields.hpp"
#include "parameters/read_quantities.hpp"
#include "parameters/study.hpp"

namespace cpt::parameters {

/// Where the study's parts stand in the file.
struct StudyPlaces {
  Place profile;
  Place soils;
  std::vector<Place> layers;  ///< one a layer, where the study has its own
  Place zones;
  std::vector<Place> points;   ///< one a point of the study
  std::vector<Place> windows;  ///< one a window of the study
};

/// Reports impossible combinations (solver::problems) of the baseline and of each realization, and windows
/// that the push does not reach. What involves a doubtful quantity or layer is not judged: its error is on
/// the list already.
void check_study(const Study& study, const QuantitySections& sections, const StudyPlaces& places,
                 const SoilDoubts& doubts, ErrorList& errors);

}  // namespace cpt::parameters

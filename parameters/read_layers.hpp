// The tables [[layers]] of a study: layers in place of the profile's.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "parameters/read_soils.hpp"
#include "solver/setup.hpp"

namespace cpt::parameters {

/// The layers of a study. After an error they are not those that the study means, and the doubts say so.
struct OwnLayers {
  std::vector<solver::Layer> layers;  ///< but those of a soil that is in doubt; empty where there are none
  std::vector<Place> places;          ///< one a layer of `layers`
  std::optional<double> bottom;       ///< [m] of the last one, where it is known
  Place bottom_place;
};

/// Reads them and tells soils of [soils] that no layer has. `setup` has the soils and, for a study without
/// layers of its own, the profile's layers.
[[nodiscard]] OwnLayers read_layers(const Value& root, const solver::Setup& setup, SoilDoubts& doubts,
                                    ErrorList& errors);

/// Tells where they do not end at the height of the soil; true if they do.
bool check_end(const OwnLayers& layers, double soil_height, ErrorList& errors);

}  // namespace cpt::parameters

// Named starting points: the three soil profiles of Yost et al. (2023) and four resolutions.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "solver/setup.hpp"

namespace cpt::solver {

enum class Profile { homogeneous_sand, homogeneous_clay, layered_sand_clay };
enum class Preset { quick, standard, paper, fine };

/// The baseline setup of a profile at a resolution. Every field can be overridden afterwards.
[[nodiscard]] Setup make_setup(Profile profile, Preset preset);

/// Name in study files <-> value; nullopt if there is no such name.
[[nodiscard]] std::string_view to_string(Profile profile);
[[nodiscard]] std::string_view to_string(Preset preset);
[[nodiscard]] std::optional<Profile> profile_from_string(std::string_view name);
[[nodiscard]] std::optional<Preset> preset_from_string(std::string_view name);
[[nodiscard]] std::span<const Profile> all_profiles();
[[nodiscard]] std::span<const Preset> all_presets();

}  // namespace cpt::solver

// What Yost et al. (2023), Computers and Geotechnics 158, 105378, published: every number and statement that
// the comparison holds against a campaign, and nothing else. `section` is the section of the paper.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace cpt::validation::paper {

/// A number as printed.
struct Published {
  double value;
  std::string_view section;
};

inline constexpr double cone_radius = 0.01265;  // [m] section 3.1

// Section 5.1: noise of the baseline inside the window.
inline constexpr Published noise_sand{0.0127, "5.1"};           // [-]
inline constexpr Published noise_clay{0.0132, "5.1"};           // [-]
inline constexpr Published noise_embedded_sand{0.0519, "5.1"};  // [-]
inline constexpr Published noise_embedded_clay{0.0325, "5.1"};  // [-]
inline constexpr Published peak_depth{0.3082, "5.1"};    // [m] of the baseline in the first embedded sand
inline constexpr Published peak_least{1552, "5.1"};      // [kPa] least q_c in the window about it
inline constexpr Published peak_largest{1637, "5.1"};    // [kPa] largest
inline constexpr Published trough_depth{0.2771, "5.1"};  // [m] of the baseline in the first embedded clay

// Section 5.2: averages of q_c.
inline constexpr Published sand_least{3280, "5.2"};    // [kPa] over all realizations but H = 75
inline constexpr Published sand_largest{5070, "5.2"};  // [kPa] "about", as the least
inline constexpr Published sand_hard{8542, "5.2"};     // [kPa] H = 75
inline constexpr Published clay_baseline{264, "5.2"};  // [kPa]
inline constexpr Published clay_least{230, "5.2"};     // [kPa]
inline constexpr Published clay_largest{342, "5.2"};   // [kPa]
inline constexpr Published radius_index{0.05, "6.3"};  // [-] SI of the chamber's radius in sand, "about"

// Section 6.3: the second push.
inline constexpr Published stress_effect{0.15, "6.3.1"};      // [-] sigma'_v0 100 to 120 kPa on q_c, "about"
inline constexpr Published density_effect{0.10, "6.3.2"};     // [-] D_R 60 to 65 % on q_c, "about"
inline constexpr Published measured_rise{0.26, "6.3"};        // [-] of q_c from the first to the second push
inline constexpr Published wall_sigma_v{0.20, "6.3.1"};       // [-] largest rise at the wall, "up to about"
inline constexpr Published wall_sigma_h{2.40, "6.3.1"};       // [-] the same
inline constexpr Published wall_ratio_start{0.5, "6.3.1"};    // [-] sigma'_h / sigma'_v at the wall
inline constexpr Published wall_ratio{1.0, "6.3.1"};          // [-] "much closer to" this at the end
inline constexpr Published altered_to{0.24, "6.3.2"};         // [m] void ratio altered up to here, "about"
inline constexpr Published least_void_ratio{0.669, "6.3.2"};  // [-] at the end of the push

/// Where a group of parameters stands against SI_noise.
enum class Level { above_noise, at_or_below_noise };

/// Parameters that the paper names together, and its words for them.
struct Group {
  std::span<const std::string_view> parameters;
  Level level;
  std::string_view words;
};

/// Groups of one window from the largest influence to the least (section 5.2, Figs. 11 and 12).
struct Ranking {
  std::string_view study;
  std::string_view window;
  std::span<const Group> groups;
};

namespace detail {
using Names = std::string_view;
inline constexpr std::array<Names, 1> sand_1 = {"sand.H"};
inline constexpr std::array<Names, 4> sand_2 = {"sand.D_r_percent", "contact.friction_ratio", "sand.chi_tc",
                                                "chamber.wall"};
inline constexpr std::array<Names, 4> sand_3 = {"initial.sigma_h0_kPa", "sand.lambda", "sand.phi_cs_deg",
                                                "chamber.radius_m"};
inline constexpr std::array<Names, 3> sand_4 = {"sand.N", "sand.G_ref", "sand.nu"};
inline constexpr std::array sand = {
    Group{sand_1, Level::above_noise, "by far the parameter dominating"},
    Group{sand_2, Level::above_noise, "other fairly significant contributions"},
    Group{sand_3, Level::above_noise, "less significant"},
    Group{sand_4, Level::at_or_below_noise, "just at or below SI_noise"}};

inline constexpr std::array<Names, 2> clay_1 = {"clay.G_kPa", "clay.s_u_kPa"};
inline constexpr std::array<Names, 2> clay_2 = {"contact.adhesion_ratio", "initial.sigma_h0_kPa"};
inline constexpr std::array<Names, 3> clay_3 = {"chamber.wall", "chamber.radius_m", "clay.n_0"};
inline constexpr std::array clay = {Group{clay_1, Level::above_noise, "dominate"},
                                    Group{clay_2, Level::above_noise, "less significant, but above SI_noise"},
                                    Group{clay_3, Level::at_or_below_noise, "just at or below SI_noise"}};

inline constexpr std::array<Names, 2> embedded_sand_1 = {"clay.G_kPa", "sand.D_r_percent"};
inline constexpr std::array<Names, 3> embedded_sand_2 = {"sand.H", "contact.friction_ratio", "chamber.wall"};
inline constexpr std::array<Names, 11> embedded_sand_3 = {"sand.lambda",
                                                          "sand.G_ref",
                                                          "sand.phi_cs_deg",
                                                          "sand.N",
                                                          "sand.chi_tc",
                                                          "sand.nu",
                                                          "clay.n_0",
                                                          "clay.s_u_kPa",
                                                          "contact.adhesion_ratio",
                                                          "initial.sigma_h0_kPa",
                                                          "chamber.radius_m"};
inline constexpr std::array embedded_sand = {
    Group{embedded_sand_1, Level::above_noise, "the most uncertainty"},
    Group{embedded_sand_2, Level::above_noise, "above the noise level"},
    Group{embedded_sand_3, Level::at_or_below_noise, "all other parameters: below"}};

inline constexpr std::array<Names, 2> embedded_clay_1 = {"contact.friction_ratio", "sand.H"};
inline constexpr std::array<Names, 3> embedded_clay_2 = {"clay.s_u_kPa", "clay.G_kPa", "sand.D_r_percent"};
inline constexpr std::array<Names, 2> embedded_clay_3 = {"sand.chi_tc", "chamber.wall"};
inline constexpr std::array<Names, 9> embedded_clay_4 = {
    "sand.lambda",     "sand.G_ref", "sand.phi_cs_deg",        "sand.N",
    "sand.nu",         "clay.n_0",   "contact.adhesion_ratio", "initial.sigma_h0_kPa",
    "chamber.radius_m"};
inline constexpr std::array embedded_clay = {
    Group{embedded_clay_1, Level::above_noise, "largest"},
    Group{embedded_clay_2, Level::above_noise, "the next largest"},
    Group{embedded_clay_3, Level::above_noise, "followed by"},
    Group{embedded_clay_4, Level::at_or_below_noise, "all other parameters: at or below"}};
}  // namespace detail

inline constexpr Ranking sand_ranking{"homogeneous_sand", "sand", detail::sand};
inline constexpr Ranking clay_ranking{"homogeneous_clay", "clay", detail::clay};
inline constexpr Ranking embedded_sand_ranking{"layered", "embedded_sand", detail::embedded_sand};
inline constexpr Ranking embedded_clay_ranking{"layered", "embedded_clay", detail::embedded_clay};

}  // namespace cpt::validation::paper

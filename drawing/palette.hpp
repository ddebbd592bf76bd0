// Colours that stay apart for colour-blind readers: Okabe & Ito (2008), "Color Universal Design".
#pragma once

#include <array>
#include <string_view>

namespace cpt::drawing::palette {

inline constexpr std::string_view paper = "#ffffff";
inline constexpr std::string_view ink = "#222222";
inline constexpr std::string_view muted = "#666666";
inline constexpr std::string_view faint = "#b5b5b5";
inline constexpr std::string_view grid = "#dddddd";
inline constexpr std::string_view band = "#d9d9d9";
inline constexpr std::string_view clay = "#f1e7d4";
/// Of soils after the first, light enough for lines above them.
inline constexpr std::array<std::string_view, 4> tints = {clay, "#dfe9ef", "#e6e0ec", "#e2ecdc"};

inline constexpr std::string_view blue = "#0072b2";
inline constexpr std::string_view vermillion = "#d55e00";
inline constexpr std::string_view green = "#009e73";
inline constexpr std::string_view purple = "#cc79a7";
inline constexpr std::string_view sky = "#56b4e9";
inline constexpr std::string_view orange = "#e69f00";
inline constexpr std::string_view warn = "#a34700";  ///< of words, which need more contrast than bars

/// In the order in which curves are told apart.
inline constexpr std::array<std::string_view, 6> series = {vermillion, blue, green, purple, orange, sky};

/// How the style sheet of a page calls them (reports/html/report.css), which has others for dark ground.
struct Name {
  std::string_view color, name;
};
inline constexpr std::array<Name, 13> names = {{{paper, "paper"},
                                                {ink, "ink"},
                                                {muted, "muted"},
                                                {faint, "faint"},
                                                {grid, "rule"},
                                                {band, "band"},
                                                {blue, "blue"},
                                                {vermillion, "vermillion"},
                                                {green, "green"},
                                                {purple, "purple"},
                                                {sky, "sky"},
                                                {orange, "orange"},
                                                {warn, "warn"}}};

}  // namespace cpt::drawing::palette

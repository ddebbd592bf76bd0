#include "reports/view/colour_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace cpt::reports::view {
namespace {

// Every fifth of the 256 colours of S. van der Walt and N. Smith's "viridis" and "magma" (matplotlib 1.5,
// CC0); straight lines between them miss no colour by more than one part in 255.
constexpr std::string_view viridis_colours =
    "44015446085c471063481769481d6f482475472a7a46307e453781433d844142873f48893d4e8a3a538b38598c355e8d"
    "33638d31688e2e6d8e2c718e2a768e297b8e27808e25848e23898e218e8d20928c1f978b1e9c891fa18821a58524aa83"
    "28ae802eb37c35b7793dbc7446c06f50c46a5ac86465cb5e70cf577cd25089d54895d840a2da37b0dd2fbddf26cae11f"
    "d8e219e5e419f1e51dfde725";
constexpr std::string_view magma_colours =
    "00000402020b0504160907200e0b2b140e361a104221114e29115a311165390f6e420f754a107952137c5a167e621980"
    "6a1c81721f81792282812581892881912b81992d80a1307eaa337db2357bba3878c23b75ca3e72d2426fd9466be04c67"
    "e75263ec5860f1605df4695cf7725cf97b5dfb8560fc8e64fd9869fea16efeaa74feb47bfebd82fec68afecf92fed89a"
    "fde2a3fdebacfcf4b6fcfdbf";
// "RdBu" with 11 colours, Brewer (2003), from blue to red.
constexpr std::string_view red_blue_colours =
    "053061"
    "2166ac"
    "4393c3"
    "92c5de"
    "d1e5f0"
    "f7f7f7"
    "fddbc7"
    "f4a582"
    "d6604d"
    "b2182b"
    "67001f";

std::vector<Colour> parsed(std::string_view hexadecimal) {
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < hexadecimal.size(); i += 6)
    colours.push_back(colour_of(hexadecimal.substr(i, 6)));
  return colours;
}

const std::vector<Colour>& colours_of(ColourMap map) {
  static const std::vector<Colour> maps[] = {parsed(viridis_colours), parsed(magma_colours),
                                             parsed(red_blue_colours)};
  return maps[static_cast<std::size_t>(map)];
}

std::uint8_t between(std::uint8_t a, std::uint8_t b, double fraction) {
  return static_cast<std::uint8_t>(std::lround(a + fraction * (b - a)));
}

}  // namespace

Colour colour_of(std::string_view hexadecimal) {
  if (hexadecimal.starts_with('#')) hexadecimal.remove_prefix(1);
  std::uint32_t value = 0;
  std::from_chars(hexadecimal.data(), hexadecimal.data() + hexadecimal.size(), value, 16);
  return Colour::of(value);
}

std::string hex(Colour colour) { return fmt::format("#{:06x}", colour.value()); }

Colour mixed(Colour a, Colour b, double fraction) {
  return {between(a.r, b.r, fraction), between(a.g, b.g, fraction), between(a.b, b.b, fraction)};
}

Colour colour_at(ColourMap map, double place) {
  const std::vector<Colour>& colours = colours_of(map);
  if (map == ColourMap::magma) place = 1.0 - place;
  const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(at), colours.size() - 2);
  return mixed(colours[below], colours[below + 1], at - static_cast<double>(below));
}

Colour shade_at(ColourMap map, double place) {
  const double shade = std::min(std::floor(std::clamp(place, 0.0, 1.0) * shades), shades - 1.0);
  return colour_at(map, shade / (shades - 1.0));
}

}  // namespace cpt::reports::view

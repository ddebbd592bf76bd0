// Colour maps of fields: even in lightness, or diverging from white, and safe for colour-blind readers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cpt::reports::view {

struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Colour&) const = default;
  /// 0xRRGGBB.
  [[nodiscard]] static constexpr Colour of(std::uint32_t value) {
    return {static_cast<std::uint8_t>(value >> 16 & 0xff), static_cast<std::uint8_t>(value >> 8 & 0xff),
            static_cast<std::uint8_t>(value & 0xff)};
  }
  [[nodiscard]] constexpr std::uint32_t value() const {
    return static_cast<std::uint32_t>(r) << 16 | static_cast<std::uint32_t>(g) << 8 | b;
  }
};

/// Of "#rrggbb" or "rrggbb".
[[nodiscard]] Colour colour_of(std::string_view hexadecimal);
/// "#rrggbb".
[[nodiscard]] std::string hex(Colour colour);
/// `a` at 0, `b` at 1.
[[nodiscard]] Colour mixed(Colour a, Colour b, double fraction);

enum class ColourMap {
  viridis,   ///< dark violet to yellow
  magma,     ///< cream to black: where nothing is, the page is light
  red_blue,  ///< blue, white in the middle, red
};

/// At a place from 0 to 1; beyond them the colour at the end.
[[nodiscard]] Colour colour_at(ColourMap map, double place);

/// Fields are drawn in so many shades of a map: too fine a step to see, and few enough that three maps fit
/// the 256 colours of a GIF. Odd, so that the middle of a diverging map is white.
inline constexpr int shades = 63;
/// The shade at a place from 0 to 1.
[[nodiscard]] Colour shade_at(ColourMap map, double place);

}  // namespace cpt::reports::view

// Figures as pixels: SVG to pictures and PNG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cpt::drawing {

/// Pixels 0xRRGGBB, row by row from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;
  [[nodiscard]] std::uint32_t at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row) * width + column];
  }
};

/// Renders an SVG document whose size is in points at so many dots per inch. Throws Error.
[[nodiscard]] Picture render(const std::string& svg, double dots_per_inch);

/// A picture as a PNG file holds it. Throws Error.
[[nodiscard]] std::string png(const Picture& picture);
/// A picture as "data:image/png;base64,...", for Svg::image.
[[nodiscard]] std::string png_uri(const Picture& picture);

}  // namespace cpt::drawing

// Figures as pixels: SVG to pictures and PNG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cpt::reports {

/// Pixels 0xRRGGBB, row by row from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;
  [[nodiscard]] std::uint32_t at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row) * width + column];
  }
};

/// Renders an SVG document whose size is in points at so many dots per inch. Throws results::Error, naming
/// `what`, if the document is refused.
[[nodiscard]] Picture render(const std::string& svg, double dots_per_inch, const std::string& what);

/// Throws results::Error if the file cannot be written.
void write_png(const Picture& picture, const std::filesystem::path& file);
/// Renders an SVG document to a PNG file. Throws results::Error if the document or the file is refused.
void write_png(const std::string& svg, const std::filesystem::path& file, double dots_per_inch = 300.0);

/// A picture as "data:image/png;base64,...", for Svg::image.
[[nodiscard]] std::string png_uri(const Picture& picture);

}  // namespace cpt::reports

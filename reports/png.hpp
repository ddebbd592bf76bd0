// SVG to PNG.
#pragma once

#include <filesystem>
#include <string>

namespace cpt::reports {

/// Renders an SVG document whose size is in points to a PNG file at so many dots per inch.
/// Throws results::Error if the document or the file is refused.
void write_png(const std::string& svg, const std::filesystem::path& file, double dots_per_inch = 300.0);

}  // namespace cpt::reports

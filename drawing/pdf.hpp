// SVG documents as the pages of a PDF.
#pragma once

#include <string>
#include <vector>

#include "drawing/svg.hpp"

namespace cpt::drawing {

/// A document drawn into a box [pt], as large as fits, centred.
struct PlacedSvg {
  std::string svg;
  Box place;
};
using PdfPage = std::vector<PlacedSvg>;

inline constexpr double a4_width = 595.28;   // [pt]
inline constexpr double a4_height = 841.89;  // [pt]

/// A4 pages as vectors, as a PDF file holds them. `created` (ISO 8601, UTC) is the date in the file, so that
/// the same pages give the same bytes. Throws Error if a document is refused.
[[nodiscard]] std::string pdf(const std::vector<PdfPage>& pages, const std::string& title,
                              const std::string& created);

}  // namespace cpt::drawing

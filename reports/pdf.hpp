// SVG documents as the pages of a PDF.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/svg.hpp"

namespace cpt::reports {

/// A document drawn into a box [pt], as large as fits, centred.
struct PlacedSvg {
  std::string svg;
  Box place;
};
using PdfPage = std::vector<PlacedSvg>;

inline constexpr double a4_width = 595.28;   // [pt]
inline constexpr double a4_height = 841.89;  // [pt]

/// Writes A4 pages as vectors. `created` (ISO 8601, UTC) is the date in the file, so that the same pages give
/// the same bytes. Throws results::Error if a document or the file is refused.
void write_pdf(const std::vector<PdfPage>& pages, const std::string& title, const std::string& created,
               const std::filesystem::path& file);

}  // namespace cpt::reports

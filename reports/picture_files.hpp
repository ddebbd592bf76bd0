// Pictures and pages as files.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "drawing/error.hpp"
#include "drawing/pdf.hpp"
#include "drawing/png.hpp"
#include "results/files/error.hpp"

namespace cpt::reports {

/// What `draw` returns. Throws results::Error, naming the file that it is for, where it cannot be drawn.
template <class Draw>
auto drawn_for(const std::filesystem::path& file, const Draw& draw) {
  try {
    return draw();
  } catch (const drawing::Error& problem) {
    throw results::Error(fmt::format("{}: {}", file.string(), problem.what()));
  }
}

// All throw results::Error if the document or the file is refused.
void write_png(const drawing::Picture& picture, const std::filesystem::path& file);
/// Renders an SVG document first.
void write_png(const std::string& svg, const std::filesystem::path& file, double dots_per_inch = 300.0);
void write_pdf(const std::vector<drawing::PdfPage>& pages, const std::string& title,
               const std::string& created, const std::filesystem::path& file);

}  // namespace cpt::reports

#include "reports/picture_files.hpp"

#include "results/files/atomic_file.hpp"

namespace cpt::reports {

void write_png(const drawing::Picture& picture, const std::filesystem::path& file) {
  results::replace_file(file, drawn_for(file, [&] { return drawing::png(picture); }));
}

void write_png(const std::string& svg, const std::filesystem::path& file, double dots_per_inch) {
  write_png(drawn_for(file, [&] { return drawing::render(svg, dots_per_inch); }), file);
}

void write_pdf(const std::vector<drawing::PdfPage>& pages, const std::string& title,
               const std::string& created, const std::filesystem::path& file) {
  results::replace_file(file, drawn_for(file, [&] { return drawing::pdf(pages, title, created); }));
}

}  // namespace cpt::reports

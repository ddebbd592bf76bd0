#include "drawing/pdf.hpp"

#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <memory>

#include "drawing/error.hpp"

namespace cpt::drawing {
namespace {

void draw(cairo_t* context, const PlacedSvg& part) {
  GError* error = nullptr;
  const std::unique_ptr<RsvgHandle, decltype(&g_object_unref)> handle(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(part.svg.data()), part.svg.size(), &error),
      g_object_unref);
  const RsvgRectangle place{part.place.x, part.place.y, part.place.width, part.place.height};
  if (handle != nullptr && rsvg_handle_render_document(handle.get(), context, &place, &error) != 0) return;
  const std::string why = error != nullptr ? error->message : "unknown reason";
  if (error != nullptr) g_error_free(error);
  throw Error(fmt::format("cannot be drawn ({})", why));
}

}  // namespace

std::string pdf(const std::vector<PdfPage>& pages, const std::string& title, const std::string& created) {
  std::string bytes;
  const auto append = [](void* to, const unsigned char* more, unsigned count) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(more), count);
    return CAIRO_STATUS_SUCCESS;
  };
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_pdf_surface_create_for_stream(append, &bytes, a4_width, a4_height), cairo_surface_destroy);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
  const std::string date = created.substr(0, 19) + "Z";  // without fractions, which cairo does not read
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, date.c_str());
  {
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface.get()),
                                                                     cairo_destroy);
    for (const PdfPage& page : pages) {
      for (const PlacedSvg& part : page) draw(context.get(), part);
      cairo_show_page(context.get());
    }
  }
  cairo_surface_finish(surface.get());
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(fmt::format("cannot be drawn ({})", cairo_status_to_string(status)));
  return bytes;
}

}  // namespace cpt::drawing

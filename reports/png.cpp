#include "reports/png.hpp"

#include <cairo.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>

#include "results/error.hpp"

namespace cpt::reports {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, GError* error) {
  const std::string why = error != nullptr ? error->message : "unknown reason";
  if (error != nullptr) g_error_free(error);
  throw results::Error(fmt::format("{}: cannot be drawn ({})", file.string(), why));
}

}  // namespace

void write_png(const std::string& svg, const std::filesystem::path& file, double dots_per_inch) {
  GError* error = nullptr;
  const std::unique_ptr<RsvgHandle, decltype(&g_object_unref)> handle(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error),
      g_object_unref);
  if (handle == nullptr) fail(file, error);
  rsvg_handle_set_dpi(handle.get(), dots_per_inch);
  double width = 0.0;
  double height = 0.0;
  if (rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) == 0) fail(file, nullptr);

  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(width)),
                                 static_cast<int>(std::ceil(height))),
      cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface.get()),
                                                                   cairo_destroy);
  cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
  cairo_paint(context.get());
  const RsvgRectangle viewport{0.0, 0.0, width, height};
  if (rsvg_handle_render_document(handle.get(), context.get(), &viewport, &error) == 0) fail(file, error);
  const cairo_status_t status = cairo_surface_write_to_png(surface.get(), file.c_str());
  if (status != CAIRO_STATUS_SUCCESS)
    throw results::Error(
        fmt::format("{}: cannot be written ({})", file.string(), cairo_status_to_string(status)));
}

}  // namespace cpt::reports

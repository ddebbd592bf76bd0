#include "drawing/png.hpp"

#include <cairo.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "drawing/error.hpp"

namespace cpt::drawing {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

[[noreturn]] void fail(GError* error) {
  const std::string why = error != nullptr ? error->message : "unknown reason";
  if (error != nullptr) g_error_free(error);
  throw Error(fmt::format("cannot be drawn ({})", why));
}

Surface surface_of(int width, int height) {
  return {cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy};
}

// Cairo's rows may be longer than the picture's.
Surface surface_of(const Picture& picture) {
  Surface surface = surface_of(picture.width, picture.height);
  cairo_surface_flush(surface.get());
  unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < picture.height && data != nullptr; ++row)
    std::memcpy(data + static_cast<std::ptrdiff_t>(row) * stride,
                picture.pixels.data() + static_cast<std::ptrdiff_t>(row) * picture.width,
                static_cast<std::size_t>(picture.width) * sizeof(std::uint32_t));
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

}  // namespace

Picture render(const std::string& svg, double dots_per_inch) {
  GError* error = nullptr;
  const std::unique_ptr<RsvgHandle, decltype(&g_object_unref)> handle(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error),
      g_object_unref);
  if (handle == nullptr) fail(error);
  rsvg_handle_set_dpi(handle.get(), dots_per_inch);
  double width = 0.0;
  double height = 0.0;
  if (rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) == 0) fail(nullptr);

  // A size that was meant to be whole may miss it by rounding.
  const auto whole = [](double size) { return static_cast<int>(std::ceil(size - 1e-6)); };
  const Surface surface = surface_of(whole(width), whole(height));
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface.get()),
                                                                   cairo_destroy);
  cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
  cairo_paint(context.get());
  const RsvgRectangle viewport{0.0, 0.0, width, height};
  if (rsvg_handle_render_document(handle.get(), context.get(), &viewport, &error) == 0) fail(error);

  cairo_surface_flush(surface.get());
  const unsigned char* const data = cairo_image_surface_get_data(surface.get());
  if (data == nullptr) fail(nullptr);
  Picture picture{whole(width), whole(height), {}};
  picture.pixels.resize(static_cast<std::size_t>(picture.width) * picture.height);
  for (int row = 0; row < picture.height; ++row)
    std::memcpy(picture.pixels.data() + static_cast<std::ptrdiff_t>(row) * picture.width,
                data + static_cast<std::ptrdiff_t>(row) * cairo_image_surface_get_stride(surface.get()),
                static_cast<std::size_t>(picture.width) * sizeof(std::uint32_t));
  for (std::uint32_t& pixel : picture.pixels) pixel &= 0xffffff;
  return picture;
}

std::string png(const Picture& picture) {
  std::string bytes;
  const auto append = [](void* to, const unsigned char* more, unsigned count) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(more), count);
    return CAIRO_STATUS_SUCCESS;
  };
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_of(picture).get(), append, &bytes);
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(fmt::format("cannot be drawn ({})", cairo_status_to_string(status)));
  return bytes;
}

std::string png_uri(const Picture& picture) {
  const std::string bytes = png(picture);
  const std::unique_ptr<gchar, decltype(&g_free)> text(
      g_base64_encode(reinterpret_cast<const guchar*>(bytes.data()), bytes.size()), g_free);
  return "data:image/png;base64," + std::string(text.get());
}

}  // namespace cpt::drawing

#include "drawing/gif.hpp"

#include <fmt/format.h>
#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/error.hpp"

namespace cpt::drawing {
namespace {

constexpr int bits = 8;
constexpr std::uint8_t transparent = 255;

const char* reason(int error) {
  const char* const text = GifErrorString(error);
  return text != nullptr ? text : "unknown reason";
}

int squared(int a) { return a * a; }

// Greens weigh most in what the eye takes for near.
int distance(std::uint32_t a, std::uint32_t b) {
  const auto part = [](std::uint32_t colour, int shift) { return static_cast<int>(colour >> shift & 0xff); };
  return 3 * squared(part(a, 16) - part(b, 16)) + 6 * squared(part(a, 8) - part(b, 8)) +
         squared(part(a, 0) - part(b, 0));
}

[[noreturn]] void fail(const std::string& why) { throw Error(fmt::format("cannot be written ({})", why)); }

}  // namespace

GifAnimation::GifAnimation(int width, int height, std::vector<std::uint32_t> colours)
    : width_(width),
      height_(height),
      colours_(std::move(colours)),
      gif_(nullptr, [](GifFileType* gif) { EGifCloseFile(gif, nullptr); }) {
  const auto append = [](GifFileType* to, const GifByteType* bytes, int count) {
    static_cast<std::string*>(to->UserData)->append(reinterpret_cast<const char*>(bytes), count);
    return count;
  };
  int error = 0;
  gif_.reset(EGifOpen(&bytes_, append, &error));
  GifFileType* const gif = gif_.get();
  if (gif == nullptr) fail(reason(error));

  std::array<GifColorType, 256> table{};
  for (std::size_t i = 0; i < colours_.size(); ++i)
    table[i] = {static_cast<GifByteType>(colours_[i] >> 16 & 0xff),
                static_cast<GifByteType>(colours_[i] >> 8 & 0xff),
                static_cast<GifByteType>(colours_[i] & 0xff)};
  ColorMapObject* const map = GifMakeMapObject(1 << bits, table.data());
  EGifSetGifVersion(gif, true);
  const bool good = map != nullptr && EGifPutScreenDesc(gif, width_, height_, bits, 0, map) == GIF_OK;
  GifFreeMapObject(map);
  // "NETSCAPE2.0", the extension that repeats an animation; 0 times is for ever.
  constexpr std::array<GifByteType, 3> for_ever = {1, 0, 0};
  if (!good || EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE) != GIF_OK ||
      EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0") != GIF_OK ||
      EGifPutExtensionBlock(gif, for_ever.size(), for_ever.data()) != GIF_OK ||
      EGifPutExtensionTrailer(gif) != GIF_OK)
    fail(reason(gif->Error));
}

std::uint8_t GifAnimation::nearest(std::uint32_t colour) {
  const auto [entry, is_new] = found_.try_emplace(colour);
  if (is_new) {
    const auto best = std::ranges::min_element(
        colours_, {}, [&](std::uint32_t candidate) { return distance(candidate, colour); });
    entry->second = static_cast<std::uint8_t>(best - colours_.begin());
  }
  return entry->second;
}

void GifAnimation::add(const Picture& picture, double seconds) {
  if (picture.width != width_ || picture.height != height_)
    fail(fmt::format("a frame of {} x {} pixels in place of {} x {}", picture.width, picture.height, width_,
                     height_));
  // Only the box of pixels that change is written, and in it what stays is transparent: many pixels of one
  // value take less room. Short runs keep their colours, as they would only break up the runs beside them.
  constexpr int short_run = 12;
  const bool first = shown_.empty();
  if (first) shown_.resize(picture.pixels.size());
  std::vector<std::uint8_t> change(picture.pixels.size());
  int left = width_, right = -1, upper = height_, lower = -1;
  for (int row = 0; row < height_; ++row) {
    const std::size_t start = static_cast<std::size_t>(row) * width_;
    int same = 0;  // pixels before this one that stay
    for (int column = 0; column <= width_; ++column) {
      const std::uint8_t index = column < width_ ? nearest(picture.pixels[start + column]) : transparent;
      if (column < width_) change[start + column] = index;
      if (column < width_ && !first && index == shown_[start + column]) {
        ++same;
        continue;
      }
      if (same >= short_run) std::fill_n(change.begin() + start + column - same, same, transparent);
      same = 0;
      if (column == width_) continue;
      shown_[start + column] = index;
      left = std::min(left, column), right = std::max(right, column);
      upper = std::min(upper, row), lower = std::max(lower, row);
    }
  }
  if (right < 0) left = right = upper = lower = 0;

  GifFileType* const gif = gif_.get();
  const GraphicsControlBlock control{DISPOSE_DO_NOT, false, static_cast<int>(std::lround(100.0 * seconds)),
                                     transparent};
  std::array<GifByteType, 4> bytes{};
  EGifGCBToExtension(&control, bytes.data());
  const int width = right - left + 1;
  bool good = EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, bytes.size(), bytes.data()) == GIF_OK &&
              EGifPutImageDesc(gif, left, upper, width, lower - upper + 1, false, nullptr) == GIF_OK;
  for (int row = upper; row <= lower && good; ++row)
    good = EGifPutLine(gif, change.data() + static_cast<std::size_t>(row) * width_ + left, width) == GIF_OK;
  if (!good) fail(reason(gif->Error));
}

std::string GifAnimation::close() {
  int error = 0;
  if (EGifCloseFile(gif_.release(), &error) != GIF_OK) fail(reason(error));
  return std::move(bytes_);
}

}  // namespace cpt::drawing

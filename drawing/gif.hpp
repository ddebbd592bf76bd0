// Pictures as an animated GIF, which browsers, slides and mail programs play without any script.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "drawing/png.hpp"

struct GifFileType;  // of giflib

namespace cpt::drawing {

/// Encodes frame after frame in memory; close() gives the whole.
class GifAnimation {
 public:
  /// All pictures are of this size (1 to 65535 pixels each way), and drawn in the nearest of these colours
  /// (0xRRGGBB, 2 to 255 of them). Repeats for ever. Throws Error if giflib refuses.
  GifAnimation(int width, int height, std::vector<std::uint32_t> colours);
  GifAnimation(const GifAnimation&) = delete;
  GifAnimation& operator=(const GifAnimation&) = delete;

  /// Adds a picture that stays for so many seconds (0.02 to 600, in hundredths). Throws Error.
  void add(const Picture& picture, double seconds);
  /// The animation as a file holds it; nothing may be added afterwards. Throws Error.
  [[nodiscard]] std::string close();

 private:
  [[nodiscard]] std::uint8_t nearest(std::uint32_t colour);

  int width_, height_;
  std::vector<std::uint32_t> colours_;
  std::unordered_map<std::uint32_t, std::uint8_t> found_;  // colours whose nearest is known
  std::vector<std::uint8_t> shown_;                        // by the frames so far; empty before the first
  std::string bytes_;
  std::unique_ptr<GifFileType, void (*)(GifFileType*)> gif_;  // writes to bytes_
};

}  // namespace cpt::drawing

// Animations read back through giflib: what a player shows after each frame.
#include "drawing/gif.hpp"

#include <gif_lib.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/error.hpp"

namespace cpt::drawing {
namespace {

const std::vector<std::uint32_t> colours = {0xffffff, 0xff0000, 0x0000ff, 0x008000};

struct Played {
  std::vector<Picture> pictures;
  std::vector<int> hundredths;
  bool for_ever = false;
};

int next_bytes(GifFileType* gif, GifByteType* to, int count) {
  std::string_view& left = *static_cast<std::string_view*>(gif->UserData);
  const std::size_t taken = left.copy(reinterpret_cast<char*>(to), static_cast<std::size_t>(count));
  left.remove_prefix(taken);
  return static_cast<int>(taken);
}

Played play(std::string_view bytes) {
  Played played;
  int error = 0;
  GifFileType* const gif = DGifOpen(&bytes, next_bytes, &error);
  EXPECT_NE(gif, nullptr) << error;
  if (gif == nullptr || DGifSlurp(gif) != GIF_OK) return played;
  const auto colour_of = [&](int index) {
    const GifColorType& c = gif->SColorMap->Colors[index];
    return static_cast<std::uint32_t>(c.Red) << 16 | static_cast<std::uint32_t>(c.Green) << 8 | c.Blue;
  };
  Picture shown{gif->SWidth, gif->SHeight,
                std::vector<std::uint32_t>(static_cast<std::size_t>(gif->SWidth) * gif->SHeight)};
  for (int i = 0; i < gif->ImageCount; ++i) {
    const SavedImage& image = gif->SavedImages[i];
    for (int e = 0; e < image.ExtensionBlockCount; ++e)
      if (image.ExtensionBlocks[e].Function == APPLICATION_EXT_FUNC_CODE)
        played.for_ever =
            std::string(reinterpret_cast<const char*>(image.ExtensionBlocks[e].Bytes), 11) == "NETSCAPE2.0";
    GraphicsControlBlock control{};
    EXPECT_EQ(DGifSavedExtensionToGCB(gif, i, &control), GIF_OK);
    const GifImageDesc& box = image.ImageDesc;
    for (int row = 0; row < box.Height; ++row)
      for (int column = 0; column < box.Width; ++column) {
        const int index = image.RasterBits[row * box.Width + column];
        if (index == control.TransparentColor) continue;
        shown.pixels[static_cast<std::size_t>(box.Top + row) * shown.width + box.Left + column] =
            colour_of(index);
      }
    played.pictures.push_back(shown);
    played.hundredths.push_back(control.DelayTime);
  }
  DGifCloseFile(gif, &error);
  return played;
}

// A red square that moves over white.
Picture square_at(int place) {
  Picture picture{40, 20, std::vector<std::uint32_t>(800, 0xffffff)};
  for (int row = 5; row < 9; ++row)
    for (int column = place; column < place + 4; ++column) picture.pixels[row * 40 + column] = 0xff0000;
  return picture;
}

TEST(Gif, PlaysTheSamePixelsForEver) {
  GifAnimation animation(40, 20, colours);
  for (const int place : {0, 3, 3, 30}) animation.add(square_at(place), place == 30 ? 2.0 : 0.15);
  const Played played = play(animation.close());
  EXPECT_TRUE(played.for_ever);
  EXPECT_EQ(played.hundredths, (std::vector<int>{15, 15, 15, 200}));
  ASSERT_EQ(played.pictures.size(), 4U);
  for (const auto& [frame, place] : {std::pair{0, 0}, {1, 3}, {2, 3}, {3, 30}})
    EXPECT_EQ(played.pictures[frame].pixels, square_at(place).pixels) << frame;
}

TEST(Gif, OtherColoursBecomeTheNearest) {
  Picture picture{3, 1, {0xf0f0f0, 0xe01010, 0x2010d0}};
  GifAnimation animation(3, 1, colours);
  animation.add(picture, 0.1);
  EXPECT_EQ(play(animation.close()).pictures.at(0).pixels,
            (std::vector<std::uint32_t>{0xffffff, 0xff0000, 0x0000ff}));
}

TEST(Gif, OddFramesAreRefused) {
  GifAnimation animation(10, 10, colours);
  EXPECT_THROW(animation.add(square_at(0), 0.1), Error);
}

}  // namespace
}  // namespace cpt::drawing

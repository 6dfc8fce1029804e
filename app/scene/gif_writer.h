// SPDX-License-Identifier: GPL-3.0-or-later
// Animated GIF: pictures in, a stream of bytes out, one picture in memory at a time.
#pragma once

#include <array>
#include <memory>
#include <ostream>
#include <vector>

namespace loopmend {

/// Red, green, blue of each pixel, rows from the top.
struct RgbPicture {
  int width = 0, height = 0;
  std::vector<unsigned char> bytes;  ///< 3 × width × height
};

using GifColor = std::array<unsigned char, 3>;
inline constexpr std::size_t most_gif_colors = 255;  ///< the 256th stands for "as in the picture before"

/// Colors between two of the palette become a pattern of both that is the same in every picture (ordered
/// dithering), so that
/// what stands still does not flicker, and is not stored again.
class GifWriter {
 public:
  /// @param palette  1..most_gif_colors colors. @throws InvalidArgument; Error where giflib refuses.
  GifWriter(std::ostream& out, int width, int height, std::vector<GifColor> palette);
  ~GifWriter();
  GifWriter(const GifWriter&) = delete;
  GifWriter& operator=(const GifWriter&) = delete;

  /// @param hundredths of a second that it is shown, 1..65535. @throws InvalidArgument for a picture of another
  /// size; Error.
  void add(const RgbPicture& picture, int hundredths);
  /// After the last picture. A stream that has failed is found by its state.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace loopmend

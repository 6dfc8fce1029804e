// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/gif_writer.h"

#include "core/error.h"

#include <gif_lib.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace loopmend {
namespace {

constexpr int unchanged = 255;

/// Thresholds of ordered dithering: Bayer's matrix of 8 × 8, in units of 1/128 so that none is 0.
int bayer_threshold(int x, int y) {
  int value = 0;
  for (int bit = 0; bit < 3; ++bit) {
    const int a = (x >> bit) & 1, b = (y >> bit) & 1;
    value = 4 * value + 2 * (a ^ b) + b;
  }
  return 2 * value + 1;
}

int squared_distance(const std::array<int, 3>& a, const GifColor& b) {
  int sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

/// What a color becomes: `second` on `share` of 128 pixels, else `first`.
struct GifPattern {
  unsigned char first = 0, second = 0, share = 0;
};

class GifPatterns {
 public:
  explicit GifPatterns(const std::vector<GifColor>& palette) : palette_(palette) {}

  const GifPattern& of(const unsigned char* rgb) {
    const std::uint32_t key = (std::uint32_t{rgb[0]} << 16) | (std::uint32_t{rgb[1]} << 8) | rgb[2];
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    if (known_.size() >= most_known) known_.clear();
    return known_[key] = made({rgb[0], rgb[1], rgb[2]});
  }

 private:
  static constexpr std::size_t most_known = 1U << 18U;  // some 10 MB

  int nearest(const std::array<int, 3>& color) const {
    int best = 0, least = std::numeric_limits<int>::max();
    for (std::size_t k = 0; k < palette_.size(); ++k)
      if (const int d = squared_distance(color, palette_[k]); d < least) {
        least = d;
        best = static_cast<int>(k);
      }
    return best;
  }

  /// The nearest color, and the one nearest to its mirror image in the wanted color; the share makes the mean the
  /// wanted color's projection.
  GifPattern made(const std::array<int, 3>& color) const {
    const int first = nearest(color);
    const GifColor& p = palette_[first];
    std::array<int, 3> beyond{};
    for (std::size_t k = 0; k < 3; ++k) beyond[k] = 2 * color[k] - p[k];
    const int second = nearest(beyond);
    const GifColor& q = palette_[second];
    int along = 0, length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      along += (color[k] - p[k]) * (q[k] - p[k]);
      length += (q[k] - p[k]) * (q[k] - p[k]);
    }
    const int share = length > 0 ? std::clamp(128 * along / length, 0, 64) : 0;
    return {static_cast<unsigned char>(first), static_cast<unsigned char>(second), static_cast<unsigned char>(share)};
  }

  const std::vector<GifColor>& palette_;
  std::unordered_map<std::uint32_t, GifPattern> known_;
};

int to_stream(GifFileType* gif, const GifByteType* bytes, int count) {
  static_cast<std::ostream*>(gif->UserData)->write(reinterpret_cast<const char*>(bytes), count);
  return count;  // the stream itself knows whether it has failed
}

}  // namespace

struct GifWriter::Impl {
  Impl(int w, int h, std::vector<GifColor> p) : width(w), height(h), palette(std::move(p)), patterns(palette) {}

  int width, height;
  std::vector<GifColor> palette;
  GifPatterns patterns;
  GifFileType* gif = nullptr;
  std::vector<unsigned char> shown, next;  ///< indices into the palette

  void require(int answer) const {
    if (answer == GIF_ERROR) {
      const char* why = GifErrorString(gif->Error);
      throw Error(say("the film could not be made: %1.", why ? verbatim(why) : say("giflib failed")));
    }
  }
  void begin(std::ostream& out);
  void put_delay(int hundredths);
  void put_changes();
};

void GifWriter::Impl::begin(std::ostream& out) {
  int error = 0;
  gif = EGifOpen(&out, to_stream, &error);
  if (!gif) throw Error(say("the film could not be begun: giflib failed."));
  EGifSetGifVersion(gif, true);
  std::vector<GifColorType> colors(256);
  for (std::size_t k = 0; k < palette.size(); ++k) colors[k] = {palette[k][0], palette[k][1], palette[k][2]};
  const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> map(GifMakeMapObject(256, colors.data()),
                                                                         &GifFreeMapObject);
  require(EGifPutScreenDesc(gif, width, height, 8, 0, map.get()));
  // Netscape's extension: shown again and again.
  const std::array<unsigned char, 3> for_ever{1, 0, 0};
  require(EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE));
  require(EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0"));
  require(EGifPutExtensionBlock(gif, static_cast<int>(for_ever.size()), for_ever.data()));
  require(EGifPutExtensionTrailer(gif));
}

void GifWriter::Impl::put_delay(int hundredths) {
  GraphicsControlBlock control{};
  control.DisposalMode = DISPOSE_DO_NOT;
  control.DelayTime = hundredths;
  control.TransparentColor = unchanged;
  std::array<GifByteType, 4> bytes{};
  EGifGCBToExtension(&control, bytes.data());
  require(EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(bytes.size()), bytes.data()));
}

/// The box around the pixels that differ from what is shown; of a picture that does not differ, one pixel.
void GifWriter::Impl::put_changes() {
  int left = width, right = 0, top = height, bottom = 0;
  for (int y = 0, k = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, ++k) {
      if (!shown.empty() && shown[k] == next[k]) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  if (left > right) left = right = top = bottom = 0;
  const int columns = right - left + 1;
  require(EGifPutImageDesc(gif, left, top, columns, bottom - top + 1, false, nullptr));
  std::vector<GifPixelType> row(static_cast<std::size_t>(columns));
  for (int y = top; y <= bottom; ++y) {
    const std::size_t begin =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(left);
    for (std::size_t x = 0; x < row.size(); ++x) {
      const bool same = !shown.empty() && shown[begin + x] == next[begin + x];
      row[x] = same ? static_cast<GifPixelType>(unchanged) : next[begin + x];
    }
    require(EGifPutLine(gif, row.data(), columns));
  }
}

GifWriter::GifWriter(std::ostream& out, int width, int height, std::vector<GifColor> palette)
    : impl_(std::make_unique<Impl>(width, height, std::move(palette))) {
  if (width < 1 || height < 1 || width > 65535 || height > 65535 || impl_->palette.empty() ||
      impl_->palette.size() > most_gif_colors)
    throw InvalidArgument(say("a GIF has 1 to 65535 pixels on either side, and 1 to 255 colours."));
  try {
    impl_->begin(out);
  } catch (...) {
    int error = 0;
    if (impl_->gif) EGifCloseFile(impl_->gif, &error);
    throw;
  }
}

GifWriter::~GifWriter() {
  int error = 0;
  if (impl_->gif) EGifCloseFile(impl_->gif, &error);
}

void GifWriter::add(const RgbPicture& picture, int hundredths) {
  Impl& i = *impl_;
  const std::size_t pixels = static_cast<std::size_t>(i.width) * static_cast<std::size_t>(i.height);
  if (picture.width != i.width || picture.height != i.height || picture.bytes.size() != 3 * pixels || hundredths < 1 ||
      hundredths > 65535)
    throw InvalidArgument(say("every picture of a film has the same size, and is shown for a time above 0."));
  i.next.resize(pixels);
  std::size_t k = 0;
  for (int y = 0; y < i.height; ++y)
    for (int x = 0; x < i.width; ++x, ++k) {
      const GifPattern& pattern = i.patterns.of(&picture.bytes[3 * k]);
      i.next[k] = bayer_threshold(x & 7, y & 7) < pattern.share ? pattern.second : pattern.first;
    }
  i.put_delay(hundredths);
  i.put_changes();
  i.shown.swap(i.next);
}

void GifWriter::finish() {
  int error = 0;
  const int answer = EGifCloseFile(std::exchange(impl_->gif, nullptr), &error);
  if (answer == GIF_ERROR) throw Error(say("the film could not be ended: giflib failed."));
}

}  // namespace loopmend

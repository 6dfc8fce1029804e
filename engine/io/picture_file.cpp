// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture_file.h"

#include "core/error.h"
#include "io/file_content.h"

// After <cstdio>, as libjpeg wants it.
#include <jpeglib.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <string>
#include <vector>

namespace loopmend {

namespace {

constexpr unsigned most_pixels_a_side = 16384;

[[noreturn]] void fail(const std::filesystem::path& path, const Message& problem) {
  throw ReadError(path, problem, {}, say("Save the picture again as PNG or JPEG."));
}

void require_size(const std::filesystem::path& path, unsigned width, unsigned height) {
  if (width == 0 || height == 0 || width > most_pixels_a_side || height > most_pixels_a_side)
    fail(path, say("a picture of %1 by %2 pixels", width, height));
}

Picture read_png(const FileContent& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&image, file.bytes.data(), file.bytes.size()))
    fail(file.path, say("the picture is damaged: %1", image.message));
  if (image.width > most_pixels_a_side || image.height > most_pixels_a_side) {
    const unsigned width = image.width, height = image.height;
    png_image_free(&image);
    require_size(file.path, width, height);
  }
  image.format = PNG_FORMAT_RGBA;
  Picture picture(static_cast<int>(image.width), static_cast<int>(image.height));
  if (!png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr))
    fail(file.path, say("the picture is damaged: %1", image.message));
  return picture;
}

struct JpegErrors {
  jpeg_error_mgr manager;
  std::jmp_buf back;
  char message[JMSG_LENGTH_MAX];
};

extern "C" void leave_jpeg(j_common_ptr state) {
  auto* errors = reinterpret_cast<JpegErrors*>(state->err);
  errors->manager.format_message(state, errors->message);
  std::longjmp(errors->back, 1);
}
extern "C" void say_nothing(j_common_ptr) {}

/// What longjmp passes by has no destructors: all that has one is made by the caller.
bool decode(const FileContent& file, jpeg_decompress_struct& state, JpegErrors& errors, Picture& picture,
            std::vector<unsigned char>& row) {
  if (setjmp(errors.back)) return false;
  jpeg_mem_src(&state, reinterpret_cast<const unsigned char*>(file.bytes.data()), file.bytes.size());
  jpeg_read_header(&state, TRUE);
  if (state.image_width > most_pixels_a_side || state.image_height > most_pixels_a_side) {
    std::strcpy(errors.message, "it is larger than 16384 pixels a side");
    return false;
  }
  state.out_color_space = JCS_RGB;
  jpeg_start_decompress(&state);
  picture = Picture(static_cast<int>(state.output_width), static_cast<int>(state.output_height));
  row.resize(3U * state.output_width);
  while (state.output_scanline < state.output_height) {
    const int y = static_cast<int>(state.output_scanline);
    unsigned char* line = row.data();
    jpeg_read_scanlines(&state, &line, 1);
    for (int x = 0; x < picture.width; ++x) picture.at(x, y) = {line[3 * x], line[3 * x + 1], line[3 * x + 2], 255};
  }
  jpeg_finish_decompress(&state);
  return true;
}

Picture read_jpeg(const FileContent& file) {
  jpeg_decompress_struct state{};
  JpegErrors errors{};
  state.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = leave_jpeg;
  errors.manager.output_message = say_nothing;
  jpeg_create_decompress(&state);
  Picture picture;
  std::vector<unsigned char> row;
  const bool done = decode(file, state, errors, picture, row);
  jpeg_destroy_decompress(&state);
  if (!done) fail(file.path, say("the picture cannot be read: %1", errors.message));
  return picture;
}

}  // namespace

Picture read_picture(const std::filesystem::path& path) { return read_picture(load_file(path)); }

Picture read_picture(const FileContent& file) {
  if (file.bytes.substr(0, 4) == "\x89PNG") return read_png(file);
  if (file.bytes.substr(0, 2) == "\xFF\xD8") return read_jpeg(file);
  fail(file.path, say("this is neither PNG nor JPEG"));
}

void write_png(std::ostream& stream, const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  const bool opaque =
      std::all_of(picture.pixels.begin(), picture.pixels.end(), [](const Color& c) { return c[3] == 255; });
  std::vector<unsigned char> bytes;
  bytes.reserve(picture.pixels.size() * 4);
  for (const Color& c : picture.pixels) bytes.insert(bytes.end(), c.begin(), c.begin() + (opaque ? 3 : 4));
  image.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string encoded(size, '\0');
  if (!png_image_write_to_memory(&image, encoded.data(), &size, 0, bytes.data(), 0, nullptr))
    throw Error(say("the picture cannot be written: %1", image.message));
  stream.write(encoded.data(), static_cast<std::streamsize>(size));
}

}  // namespace loopmend

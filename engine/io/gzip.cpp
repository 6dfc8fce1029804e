// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gzip.h"

#include "core/error.h"
#include "core/path_text.h"
#include "core/system_memory.h"
#include "io/text_cursor.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>

namespace loopmend {

namespace {

constexpr int gzip_format = 16 + MAX_WBITS;
constexpr std::size_t piece = 1 << 18;

Bytef* bytes_of(const char* text) { return reinterpret_cast<Bytef*>(const_cast<char*>(text)); }

/// zlib counts in 32 bits: what is left of the input, as much as it takes at a time.
uInt part(std::size_t size) { return static_cast<uInt>(std::min<std::size_t>(size, std::numeric_limits<uInt>::max())); }

struct Inflation {
  z_stream stream{};
  Inflation() {
    if (inflateInit2(&stream, gzip_format) != Z_OK) throw std::bad_alloc();
  }
  ~Inflation() { inflateEnd(&stream); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
};

[[noreturn]] void fail(const std::filesystem::path& path, const Message& problem, std::size_t byte) {
  throw ReadError(path, problem, say("byte %1", byte), say("Copy or compress it again."));
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.substr(0, 2) == "\x1F\x8B"; }

std::string gunzip(const std::filesystem::path& path, std::string_view bytes) {
  Inflation inflation;
  z_stream& stream = inflation.stream;
  std::string result, buffer(piece, '\0');
  std::size_t at = 0;
  const double most = memory_of_machine() / 2;
  while (is_gzip(bytes.substr(at))) {
    inflateReset(&stream);
    for (int outcome = Z_OK; outcome != Z_STREAM_END;) {
      if (static_cast<double>(result.size()) > most)
        throw ReadError(path, say("the unpacked mesh would take more than half of this computer's memory"), {},
                        say("Reduce it first."));
      stream.next_in = bytes_of(bytes.data() + at);
      stream.avail_in = part(bytes.size() - at);
      const uInt given = stream.avail_in;
      stream.next_out = bytes_of(buffer.data());
      stream.avail_out = static_cast<uInt>(buffer.size());
      outcome = inflate(&stream, Z_NO_FLUSH);
      at += given - stream.avail_in;
      result.append(buffer.data(), buffer.size() - stream.avail_out);
      if (outcome == Z_MEM_ERROR) throw std::bad_alloc();
      if (outcome != Z_OK && outcome != Z_STREAM_END && outcome != Z_BUF_ERROR)
        fail(path, say("the compressed file is damaged"), at);
      if (outcome != Z_STREAM_END && at == bytes.size() && stream.avail_out > 0)
        fail(path, say("the compressed file is incomplete"), at);
    }
  }
  if (bytes.find_first_not_of('\0', at) != std::string_view::npos)
    fail(path, say("something else follows the compressed mesh"), at);
  return result;
}

bool has_gzip_name(const std::filesystem::path& path) {
  return equals_ignoring_case(path_text(path.extension()), ".gz");
}

std::filesystem::path without_gzip_name(const std::filesystem::path& path) {
  return has_gzip_name(path) ? path.parent_path() / path.stem() : path;
}

struct GzipWriter::State {
  z_stream stream{};
  State() {
    constexpr int default_memory = 8;
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_format, default_memory, Z_DEFAULT_STRATEGY) !=
        Z_OK)
      throw std::bad_alloc();
  }
  ~State() { deflateEnd(&stream); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

GzipWriter::GzipWriter(std::ostream& stream) : stream_(stream), state_(std::make_unique<State>()) {}
GzipWriter::~GzipWriter() = default;

void GzipWriter::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::string_view now = bytes.substr(0, part(bytes.size()));
    run(now, Z_NO_FLUSH);
    bytes.remove_prefix(now.size());
  }
}

void GzipWriter::finish() { run({}, Z_FINISH); }

void GzipWriter::run(std::string_view bytes, int flush) {
  z_stream& stream = state_->stream;
  std::array<char, 1 << 16> buffer{};
  stream.next_in = bytes_of(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  do {
    stream.next_out = bytes_of(buffer.data());
    stream.avail_out = buffer.size();
    deflate(&stream, flush);
    stream_.write(buffer.data(), static_cast<std::streamsize>(buffer.size() - stream.avail_out));
  } while (stream.avail_out == 0);
}

}  // namespace loopmend

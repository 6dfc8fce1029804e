// SPDX-License-Identifier: GPL-3.0-or-later
// Large scans: writes one with holes and pinched vertices, and measures what a plain loop takes to parse such a file beside
// what Loopmend takes to read it and to find its loops. Run by tests/bench/large_scans.py, which also times the commands.
#include "io/read_mesh.h"
#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <sys/resource.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace loopmend;

/// A wavy torus of a grid of quads, each cut in two. Around some nodes of the grid the quads are left out; beside the first
/// of these holes one more quad, which touches it at a vertex. A small tetrahedron stands with its tip on a vertex.
class Torus {
 public:
  explicit Torus(std::int64_t triangles) {
    columns_ = std::max<std::int64_t>(48, std::llround(std::sqrt(static_cast<double>(triangles))));
    rows_ = std::max<std::int64_t>(24, triangles / (2 * columns_));
  }

  std::int64_t points() const { return rows_ * columns_ + 3; }

  std::array<float, 3> point(std::int64_t v) const {
    std::array<float, 3> lift{};
    if (v >= rows_ * columns_) {
      const auto k = static_cast<std::size_t>(v - rows_ * columns_);
      v = tip();
      lift[k] = 0.02F * (k == 1 ? -1 : 1);
      lift[2] += 0.05F;
    }
    const double row = 2 * std::numbers::pi * static_cast<double>(v / columns_) / static_cast<double>(rows_);
    const double column = 2 * std::numbers::pi * static_cast<double>(v % columns_) / static_cast<double>(columns_);
    const double tube = 1 + 0.02 * std::sin(23 * row) * std::cos(31 * column), out = 3 + tube * std::cos(row);
    return {static_cast<float>(out * std::cos(column)) + lift[0], static_cast<float>(out * std::sin(column)) + lift[1],
            static_cast<float>(tube * std::sin(row)) + lift[2]};
  }

  /// Calls each(a, b, c) for all triangles, in the order of the grid.
  template <class Each>
  void for_each_triangle(const Each& each) const {
    for (std::int64_t r = 0; r < rows_; ++r)
      for (std::int64_t c = 0; c < columns_; ++c) {
        if (is_left_out(r, c)) continue;
        const std::int64_t a = node(r, c), b = node(r, c + 1), d = node(r + 1, c), e = node(r + 1, c + 1);
        each(a, b, e);
        each(a, e, d);
      }
    const std::int64_t p = rows_ * columns_, q = p + 1, s = p + 2, t = tip();
    each(t, p, q);
    each(t, q, s);
    each(t, s, p);
    each(p, s, q);
  }

 private:
  std::int64_t node(std::int64_t r, std::int64_t c) const { return r % rows_ * columns_ + c % columns_; }
  std::int64_t tip() const { return node(rows_ / 2, columns_ / 2 + 30); }

  /// Holes of about 40 edges, twelve in all, whatever the size of the grid.
  bool is_left_out(std::int64_t r, std::int64_t c) const {
    const std::int64_t row_step = rows_ / 3, column_step = columns_ / 4;
    const std::int64_t i = r % row_step - row_step / 2, j = c % column_step - column_step / 2;
    if (i * i + j * j <= 25 && r < 3 * row_step && c < 4 * column_step) return true;
    return r == row_step / 2 + 6 && c == column_step / 2 + 1;
  }

  std::int64_t rows_ = 0, columns_ = 0;
};

void write_binary(std::ofstream& out, const Torus& torus) {
  std::vector<char> buffer;
  const auto put = [&](const void* from, std::size_t size) {
    const char* bytes = static_cast<const char*>(from);
    buffer.insert(buffer.end(), bytes, bytes + size);
    if (buffer.size() < (1 << 22)) return;
    out.write(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    buffer.clear();
  };
  for (std::int64_t v = 0; v < torus.points(); ++v) {
    const std::array<float, 3> point = torus.point(v);
    put(point.data(), sizeof point);
  }
  torus.for_each_triangle([&](std::int64_t a, std::int64_t b, std::int64_t c) {
    const unsigned char size = 3;
    const std::array<std::int32_t, 3> corners = {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b),
                                                 static_cast<std::int32_t>(c)};
    put(&size, 1);
    put(corners.data(), sizeof corners);
  });
  out.write(buffer.data(), static_cast<std::streamsize>(buffer.size()));
}

void write_text(std::ofstream& out, const Torus& torus) {
  std::array<char, 96> line{};
  const auto put = [&](int size) { out.write(line.data(), size); };
  for (std::int64_t v = 0; v < torus.points(); ++v) {
    const std::array<float, 3> p = torus.point(v);
    put(std::snprintf(line.data(), line.size(), "%.7g %.7g %.7g\n", p[0], p[1], p[2]));
  }
  torus.for_each_triangle([&](std::int64_t a, std::int64_t b, std::int64_t c) {
    put(std::snprintf(line.data(), line.size(), "3 %lld %lld %lld\n", static_cast<long long>(a),
                      static_cast<long long>(b), static_cast<long long>(c)));
  });
}

void write_scan_file(const std::string& path, std::int64_t triangles, bool text) {
  const Torus torus(triangles);
  std::int64_t count = 0;
  torus.for_each_triangle([&](std::int64_t, std::int64_t, std::int64_t) { ++count; });
  std::ofstream out(path, std::ios::binary);
  out << "ply\nformat " << (text ? "ascii" : "binary_little_endian") << " 1.0\nelement vertex " << torus.points()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << count
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  if (text)
    write_text(out, torus);
  else
    write_binary(out, torus);
  if (!out.flush()) throw std::runtime_error(path + " could not be written");
}

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Of all threads. What else runs on the machine matters less than for the time that passes.
double processor_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// The fastest reader for a file of exactly this form: coordinates to double precision, corners to whole numbers.
double plain_loop(const std::string& path) {
  const auto start = Clock::now();
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw std::runtime_error(path + " cannot be opened");
  std::array<char, 256> line{};
  long long vertex_count = 0, face_count = 0;
  bool text = false;
  while (std::fgets(line.data(), line.size(), file.get()) && std::strncmp(line.data(), "end_header", 10) != 0) {
    std::sscanf(line.data(), "element vertex %lld", &vertex_count);
    std::sscanf(line.data(), "element face %lld", &face_count);
    text = text || std::strncmp(line.data(), "format ascii", 12) == 0;
  }
  std::vector<double> points(3 * static_cast<std::size_t>(vertex_count));
  std::vector<int> corners(3 * static_cast<std::size_t>(face_count));
  if (text) {
    for (std::size_t v = 0; v < points.size(); v += 3)
      if (std::fscanf(file.get(), "%lf %lf %lf", &points[v], &points[v + 1], &points[v + 2]) != 3) return -1;
    for (std::size_t f = 0; f < corners.size(); f += 3)
      if (std::fscanf(file.get(), " 3 %d %d %d", &corners[f], &corners[f + 1], &corners[f + 2]) != 3) return -1;
    return seconds_since(start);
  }
  std::array<float, 3> point{};
  for (std::size_t v = 0; v < points.size(); v += 3) {
    if (std::fread(point.data(), sizeof point, 1, file.get()) != 1) return -1;
    std::copy(point.begin(), point.end(), points.begin() + static_cast<std::ptrdiff_t>(v));
  }
  for (std::size_t f = 0; f < corners.size(); f += 3) {
    if (std::fgetc(file.get()) != 3) return -1;
    if (std::fread(&corners[f], 3 * sizeof(int), 1, file.get()) != 1) return -1;
  }
  return seconds_since(start);
}

void measure(const std::string& path) {
  const double plain = plain_loop(path), plain_processor = processor_seconds();
  const auto start = Clock::now();
  ImportedMesh mesh = read_mesh(path);
  const double read = seconds_since(start);
  const std::size_t triangles = mesh.soup.triangles.size();
  const SurfaceModel model = make_view_around_loops(std::move(mesh.soup), {}, std::move(mesh.survey));
  const double built = seconds_since(start);
  const std::size_t loops = find_boundary_loops(model).size();
  const double all = seconds_since(start);
  const double processor = processor_seconds() - plain_processor;
  std::printf(
      "%zu triangles, %zu loops: plain loop %.2f s (of a processor %.2f s); read %.2f s, view %.2f s, loops %.2f s, "
      "all "
      "%.2f s (%.2f s), %.1f times (%.1f times)\n",
      triangles, loops, plain, plain_processor, read, built - read, all - built, all, processor, all / plain,
      processor / plain_processor);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Writes large scans, and measures reading them and finding their loops.");
  app.require_subcommand(1);
  std::string path;
  std::int64_t triangles = 14'000'000;
  bool text = false;
  CLI::App* write = app.add_subcommand("write", "write a PLY file of about so many triangles");
  write->add_option("file", path)->required();
  write->add_option("triangles", triangles)->required();
  write->add_flag("--text", text, "as text");
  CLI::App* compare = app.add_subcommand("compare", "beside a plain loop that parses the same file");
  compare->add_option("file", path)->required();
  CLI11_PARSE(app, argc, argv);
  try {
    if (write->parsed())
      write_scan_file(path, triangles, text);
    else
      measure(path);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

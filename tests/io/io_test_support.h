// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of engine/io share: a folder that vanishes, small meshes, and "this file must be refused like so".
#pragma once

#include "core/error.h"
#include "io/read_mesh.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>

namespace loopmend {

/// A new empty folder, removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static std::atomic<int> count{0};
    // Thousands of small files are written: in memory, where there is such a place.
    const bool in_memory = ::access("/dev/shm", W_OK) == 0;
    path_ = (in_memory ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path()) /
            ("loopmend_io_test_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path path_;
};

inline void write_bytes(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

inline std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A test that reads file content given as a string.
class ReadTest : public ::testing::Test {
 protected:
  ImportedMesh read(std::string_view bytes, const std::string& name) {
    write_bytes(folder_ / name, bytes);
    return read_mesh(folder_ / name);
  }

  /// The content must be refused in one line that names the file and holds every one of the words.
  void expect_refused(std::string_view bytes, const std::string& name, std::initializer_list<const char*> words) {
    write_bytes(folder_ / name, bytes);
    try {
      read_mesh(folder_ / name);
      ADD_FAILURE() << "was read: " << bytes.substr(0, 300);
    } catch (const ReadError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find((folder_ / name).string()), 0U) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
      for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " not in: " << text;
    }
  }

  TemporaryFolder folder_;
};

/// What every reader promises about what it returns.
inline void expect_valid(const ImportedMesh& mesh) {
  const TriangleSoup& soup = mesh.soup;
  EXPECT_FALSE(soup.triangles.empty());
  EXPECT_EQ(mesh.report.vertices, soup.points.size());
  EXPECT_EQ(mesh.report.triangles, soup.triangles.size());
  EXPECT_TRUE(soup.colors.empty() || soup.colors.size() == soup.points.size());
  EXPECT_EQ(mesh.report.has_colors, !soup.colors.empty());
  bool finite = true;
  for (const Vec3& point : soup.points) finite = finite && point.allFinite();
  EXPECT_TRUE(finite);
  bool in_range = true;
  for (const Triangle& triangle : soup.triangles) {
    for (const int v : triangle) in_range = in_range && v >= 0 && v < static_cast<int>(soup.points.size());
  }
  EXPECT_TRUE(in_range);
}

inline bool same_bits(const Points& a, const Points& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (a[i][k] != b[i][k] || std::signbit(a[i][k]) != std::signbit(b[i][k])) return false;
    }
  }
  return true;
}

/// Two triangles and a point of its own, with coordinates that need all 17 digits or stand at the ends of the range.
inline TriangleSoup awkward_soup() {
  TriangleSoup soup;
  soup.points = {{0.1, 1.0 / 3.0, -0.0},
                 {1e300, 4.9406564584124654e-324, 2.0},
                 {-1e-300, 5.0, 123456789.123456789},
                 {7.0, 8.0, 9.0},
                 {0.30000000000000004, 3.0, 1.0}};
  soup.triangles = {{0, 1, 2}, {2, 1, 4}};
  return soup;
}

inline TriangleSoup colored_soup() {
  TriangleSoup soup = awkward_soup();
  soup.colors = {{0, 1, 2, 255}, {255, 254, 128, 255}, {10, 20, 30, 255}, {0, 0, 0, 255}, {77, 88, 99, 255}};
  return soup;
}

}  // namespace loopmend

// SPDX-License-Identifier: GPL-3.0-or-later
// Files as real exporters write them, made by code: what is read of each, or the sentence by which it is refused.
#pragma once

#include "io_test_support.h"

#include <string>
#include <string_view>
#include <vector>

namespace loopmend {

/// A file that is read. Most of them hold the same surface: the unit square in the plane z = 0, as two triangles.
struct Variant {
  std::string what;  ///< whose habit it is, or how the format is bent
  std::string file;  ///< its name; the same name comes again and again
  std::string bytes;
  std::string oddities{};  ///< ImportReport::oddities in words
  std::size_t points = 4, triangles = 2;
  Vec3 area = {0, 0, 1};  ///< the sum of the triangles' vector areas; the square's is its normal
};

/// A file that is refused, and the whole sentence after its name.
struct Refusal {
  std::string what;
  std::string file;
  std::string bytes;
  std::string sentence;
};

/// Every `what` of a text becomes `by`; fails where there is none.
inline std::string replaced(std::string text, std::string_view what, std::string_view by) {
  std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  for (; at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
  return text;
}

/// The first `what` only.
inline std::string replaced_once(std::string text, std::string_view what, std::string_view by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

/// `before` and `after` around what stands in each line.
inline std::string around_lines(const std::string& text, const std::string& before, const std::string& after) {
  return before + replaced(text.substr(0, text.size() - 1), "\n", after + "\n" + before) + after + "\n";
}

inline Vec3 vector_area(const TriangleSoup& soup) {
  Vec3 sum(0, 0, 0);
  const auto at = [&](int v) -> const Vec3& { return soup.points[v]; };
  for (const Triangle& t : soup.triangles) {
    const Vec3 a = at(t[1]) - at(t[0]), b = at(t[2]) - at(t[0]);
    sum += 0.5 * Vec3(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}

class ExporterTest : public ReadTest {
 protected:
  void expect_read(const std::vector<Variant>& variants) {
    for (const Variant& variant : variants) {
      SCOPED_TRACE(variant.file + ": " + variant.what);
      try {
        const ImportedMesh mesh = read(variant.bytes, variant.file);
        expect_valid(mesh);
        EXPECT_EQ(mesh.report.vertices, variant.points);
        EXPECT_EQ(mesh.report.triangles, variant.triangles);
        EXPECT_EQ(to_string(mesh.report.oddities), variant.oddities);
        const Vec3 area = vector_area(mesh.soup);
        // Coordinates are small whole numbers and simple fractions, in some of them rounded to floats.
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(area[k], variant.area[k], 1e-6) << "component " << k;
      } catch (const Error& error) {
        ADD_FAILURE() << error.what();
      }
    }
  }

  void expect_refusals(const std::vector<Refusal>& refusals) {
    for (const Refusal& refusal : refusals) {
      SCOPED_TRACE(refusal.file + ": " + refusal.what);
      try {
        read(refusal.bytes, refusal.file);
        ADD_FAILURE() << "was read";
      } catch (const ReadError& error) {
        EXPECT_EQ(error.what(), (folder_ / refusal.file).string() + ": " + refusal.sentence);
      }
    }
  }
};

}  // namespace loopmend

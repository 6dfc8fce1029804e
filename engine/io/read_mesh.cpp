// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_mesh.h"

#include "core/error.h"
#include "core/path_text.h"
#include "core/threads.h"
#include "io/file_content.h"
#include "io/first_occurrence.h"
#include "io/gzip.h"
#include "io/polydata.h"
#include "io/text_cursor.h"
#include "mesh/join_touching_fans.h"
#include "mesh/rounding_cracks.h"
#include "mesh/scan_attributes.h"
#include "mesh/triangulate_polygon.h"
#include "mesh/vertex_survey.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <span>
#include <utility>

namespace loopmend {

namespace {

/// STL has no topology of its own: its faces share a vertex where their corners lie in one place, up to rounding.
bool is_stl(MeshFormat format) { return format == MeshFormat::stl_ascii || format == MeshFormat::stl_binary; }

const char* format_name(MeshFormat format) {
  switch (format) {
    case MeshFormat::ply: return "PLY";
    case MeshFormat::stl_ascii:
    case MeshFormat::stl_binary: return "STL";
    case MeshFormat::obj: return "OBJ";
    case MeshFormat::off: return "OFF";
    case MeshFormat::gltf: return "glTF";
    case MeshFormat::three_mf: return "3MF";
    case MeshFormat::polydata: return "VTK";
  }
  return "";
}

PolygonSoup parse(const FileContent& file, MeshFormat format, FloatText float_text) {
  switch (format) {
    case MeshFormat::ply: return parse_ply(file, float_text);
    case MeshFormat::stl_ascii: return parse_stl_ascii(file);
    case MeshFormat::stl_binary: return parse_stl_binary(file);
    case MeshFormat::obj: return parse_obj(file);
    case MeshFormat::off: return parse_off(file);
    case MeshFormat::gltf: return parse_gltf(file);
    case MeshFormat::three_mf: return parse_3mf(file);
    case MeshFormat::polydata: return parse_polydata(file);
  }
  return {};
}

void require_faces(const std::filesystem::path& path, const PolygonSoup& soup) {
  if (soup.polygon_count() > 0) return;
  const Message cure = say("Loopmend needs a surface: export the mesh together with its faces.");
  if (soup.points.empty()) throw ReadError(path, say("holds no points and no faces"), {}, cure);
  throw ReadError(path, say("holds points but no faces"), say("%1 points", soup.points.size()), cure);
}

/// @param face_of  is set to the polygon of each triangle where some have more corners
Triangles triangulate(const std::filesystem::path& path, const PolygonSoup& soup, std::vector<int>& face_of) {
  const std::size_t count = soup.corners.size() - 2 * soup.polygon_count();
  constexpr std::size_t most = std::numeric_limits<int>::max() / 3;  // corners are numbered, too
  if (count > most || soup.corners.size() > std::numeric_limits<int>::max())
    throw ReadError(path, say("more than 715827882 triangles"), {}, say("Reduce it first."));
  Triangles triangles;
  if (soup.has_only_triangles()) {
    static_assert(sizeof(Triangle) == 3 * sizeof(int));
    const auto* first = reinterpret_cast<const Triangle*>(soup.corners.data());
    triangles.assign(first, first + count);  // the same bytes
    return triangles;
  }
  triangles.reserve(count);
  for (std::size_t k = 0; k < soup.polygon_count(); ++k) triangulate_polygon(soup.points, soup.polygon(k), triangles);
  if (count == soup.polygon_count()) return triangles;
  face_of.reserve(count);
  for (std::size_t k = 0; k < soup.polygon_count(); ++k)
    face_of.insert(face_of.end(), soup.polygon(k).size() - 2, static_cast<int>(k));
  return triangles;
}

std::size_t count_polygons(const PolygonSoup& soup) {
  if (soup.has_only_triangles()) return 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < soup.polygon_count(); ++k) count += soup.polygon(k).size() > 3 ? 1 : 0;
  return count;
}

std::size_t count_unreferenced(const TriangleSoup& soup) {
  std::vector<char> used(soup.points.size(), 0);
  for (const Triangle& triangle : soup.triangles) {
    for (const int v : triangle) used[v] = 1;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
}

/// How many of these points lie exactly where another of them does, not counting one for each place.
/// @param entries  hash and number of each point
std::size_t count_at_same_place(const Points& points, std::span<const std::uint64_t> entries) {
  const auto point = [&](std::uint64_t entry) -> const Vec3& { return points[static_cast<std::uint32_t>(entry)]; };
  constexpr std::uint64_t none = ~std::uint64_t{0};
  std::vector<std::uint64_t> table(std::bit_ceil(2 * entries.size() + 1), none);
  std::size_t count = 0;
  for (const std::uint64_t entry : entries) {
    std::size_t at = (entry >> 32) & (table.size() - 1);
    const auto is_same = [&] { return table[at] >> 32 == entry >> 32 && point(table[at]) == point(entry); };
    while (table[at] != none && !is_same()) at = (at + 1) & (table.size() - 1);
    if (table[at] == none)
      table[at] = entry;
    else
      ++count;
  }
  return count;
}

/// Points are dealt out by their hash, so that what is compared lies in a small part of the memory.
std::size_t count_coincident(const Points& points) {
  constexpr std::size_t parts = 256;
  const PointHash hash{&points};
  std::vector<std::uint32_t> hashes(points.size());
  parallel_for(0, static_cast<int>(points.size()), 1 << 16,
               [&](int v) { hashes[v] = static_cast<std::uint32_t>(hash(v)); });
  std::array<std::size_t, parts + 1> begin{};
  for (const std::uint32_t h : hashes) ++begin[(h >> 24) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint64_t> entries(points.size());  // hash, number of the point
  std::array<std::size_t, parts + 1> next = begin;
  for (std::size_t v = 0; v < points.size(); ++v)
    entries[next[hashes[v] >> 24]++] = (std::uint64_t{hashes[v]} << 32) | v;
  std::array<std::size_t, parts> count{};
  parallel_for(0, static_cast<int>(parts), 1, [&](int part) {
    const auto p = static_cast<std::size_t>(part);
    count[p] = count_at_same_place(points, std::span(entries).subspan(begin[p], begin[p + 1] - begin[p]));
  });
  return std::accumulate(count.begin(), count.end(), std::size_t{0});
}

/// A vertex twice, or an area that is zero up to rounding.
bool is_degenerate(const Points& points, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const auto at = [&](int v) -> const Vec3& { return points[v]; };
  Vec3 u = at(t[1]) - at(t[0]);
  Vec3 v = at(t[2]) - at(t[0]);
  const double scale = std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());
  if (scale == 0.0) return true;
  // Nearly all triangles, of ordinary size: far from the limit below, without a division.
  if (scale > 1e-60 && scale < 1e60 && u.cross(v).norm() > 1e-12 * scale * scale) return false;
  u /= scale;  // so that very small and very large meshes neither vanish nor overflow
  v /= scale;
  return u.cross(v).norm() <= 4.0 * std::numeric_limits<double>::epsilon();
}

std::size_t count_degenerate(const TriangleSoup& soup) {
  std::atomic<std::size_t> count{0};
  parallel_for(0, static_cast<int>(soup.triangles.size()), 1 << 16, [&](int f) {
    if (is_degenerate(soup.points, soup.triangles[f])) ++count;
  });
  return count;
}

std::size_t count_duplicates(const TriangleSoup& soup, const VertexSurvey& survey) {
  if (!survey.may_repeat) return 0;
  const std::vector<char> repeated = repeated_triangles(soup.triangles, soup.points.size());
  return static_cast<std::size_t>(std::count(repeated.begin(), repeated.end(), 1));
}

ImportReport make_report(MeshFormat format, const PolygonSoup& polygons, const ImportedMesh& mesh) {
  const TriangleSoup& soup = mesh.soup;
  ImportReport report;
  report.format = format_name(format);
  report.vertices = soup.points.size();
  report.faces = polygons.polygon_count();
  report.triangles = soup.triangles.size();
  report.polygons_triangulated = count_polygons(polygons);
  report.vertices_welded = polygons.vertices_welded;
  parallel_invoke(
      [&] {
        report.duplicate_faces = count_duplicates(soup, *mesh.survey);
        report.degenerate_faces = count_degenerate(soup);
      },
      [&] {
        report.coincident_vertices = count_coincident(soup.points);
        report.unreferenced_vertices = count_unreferenced(soup);
      });
  report.missing_colors = polygons.missing_colors;
  report.skipped_elements = polygons.skipped_elements;
  report.has_colors = !soup.colors.empty();
  report.not_kept = polygons.not_kept;
  report.oddities = polygons.oddities;
  return report;
}

/// Points for which another is named go; the faces take that one, here and in the attributes.
/// @param first  per point: itself, or the earlier one that takes its place. @returns how many went.
std::size_t merge(TriangleSoup& soup, ScanAttributes& attributes, const std::vector<int>& first) {
  std::vector<int> place_of(soup.points.size()), rows;
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const auto earlier = static_cast<std::size_t>(first[v]);
    if (earlier == v) rows.push_back(static_cast<int>(v));
    place_of[v] = earlier == v ? static_cast<int>(rows.size()) - 1 : place_of[earlier];
  }
  TriangleSoup merged;
  merged.points.reserve(rows.size());
  merged.colors.reserve(soup.colors.empty() ? 0 : rows.size());
  for (const int row : rows) {
    merged.points.push_back(Vec3(soup.points[row]));
    if (!soup.colors.empty()) merged.colors.push_back(soup.colors[row]);
  }
  merged.triangles = std::move(soup.triangles);
  for (Triangle& triangle : merged.triangles)
    for (int& v : triangle) v = place_of[v];
  const auto first_of = [&](int v) { return rows[place_of[v]]; };
  for (int& v : attributes.corners) v = first_of(v);
  for (Triangle& triangle : attributes.triangles)
    for (int& v : triangle) v = first_of(v);
  merged.point_rows = std::move(rows);
  const std::size_t gone = soup.points.size() - merged.points.size();
  soup = std::move(merged);
  return gone;
}

/// Later points at the place of an earlier one go.
std::size_t weld(TriangleSoup& soup, ScanAttributes& attributes) {
  FirstPoint table = first_point_table(soup.points);
  std::vector<int> first(soup.points.size());
  for (std::size_t v = 0; v < first.size(); ++v) first[v] = table.find_or_add(static_cast<int>(v));
  return merge(soup, attributes, first);
}

/// Boundary vertices that touch become one, in the attributes as well. @returns how many others were joined to the first.
std::size_t join_touching(TriangleSoup& soup, const VertexSurvey& survey, ScanAttributes& attributes) {
  const std::vector<int> named = join_touching_fans(soup, survey);
  if (named.empty()) return 0;
  for (int& v : attributes.corners) v = named[v];
  for (Triangle& triangle : attributes.triangles)
    for (int& v : triangle) v = named[v];
  std::size_t joined = 0;
  for (std::size_t v = 0; v < named.size(); ++v) joined += static_cast<std::size_t>(named[v]) != v ? 1 : 0;
  return joined;
}

ImportedMesh import(const std::filesystem::path& path, CoincidentVertices coincident, FloatText float_text) {
  PolygonSoup polygons;
  MeshFormat format{};
  {
    const FileContent file = load_file(path);  // its memory is given back before the mesh is built
    format = detect_format(file);
    polygons = parse(file, format, float_text);
  }
  require_faces(path, polygons);
  ImportedMesh mesh;
  auto attributes = std::make_shared<ScanAttributes>(std::move(polygons.attributes));
  mesh.soup.triangles = triangulate(path, polygons, attributes->face_of);
  mesh.soup.points = std::move(polygons.points);
  mesh.soup.colors = std::move(polygons.colors);
  attributes->format = format_name(format);
  attributes->file = std::filesystem::absolute(path);
  attributes->point_count = mesh.soup.points.size();
  attributes->triangle_count = mesh.soup.triangles.size();
  if (!attributes->face_of.empty()) {
    attributes->triangles = mesh.soup.triangles;
    attributes->ends = polygons.ends;
  }
  if (!attributes->face_of.empty() || attributes->texture.dimension > 0 || attributes->normals.dimension > 0)
    attributes->corners = polygons.corners;
  std::size_t joined = 0;
  if (coincident == CoincidentVertices::weld) polygons.vertices_welded += weld(mesh.soup, *attributes);
  mesh.survey = survey_vertices(mesh.soup.triangles, mesh.soup.points.size());
  if (coincident == CoincidentVertices::keep) joined = join_touching(mesh.soup, *mesh.survey, *attributes);
  JoinedCracks cracks;
  if (is_stl(format)) cracks = join_rounding_cracks(mesh.soup, *mesh.survey);
  if (cracks.vertices > 0) merge(mesh.soup, *attributes, cracks.first);
  if (joined + cracks.vertices > 0) mesh.survey = survey_vertices(mesh.soup.triangles, mesh.soup.points.size());
  mesh.soup.attributes = std::move(attributes);
  mesh.report = make_report(format, polygons, mesh);
  mesh.report.vertices_joined = joined;
  mesh.report.near_vertices_joined = cracks.vertices;
  mesh.report.largest_join = cracks.largest;
  mesh.report.unreferenced_vertices -= joined;
  mesh.report.coincident_vertices -= joined;
  return mesh;
}

}  // namespace

bool is_mesh_name(const std::filesystem::path& path) {
  constexpr std::array extensions{".ply", ".stl", ".obj", ".off", ".glb", ".gltf", ".3mf", ".vtp", ".vtk"};
  const std::string extension = path_text(without_gzip_name(path).extension());
  return std::any_of(extensions.begin(), extensions.end(),
                     [&](const char* one) { return equals_ignoring_case(extension, one); });
}

ImportedMesh read_mesh(const std::filesystem::path& path, CoincidentVertices coincident, FloatText float_text) {
  try {
    return import(path, coincident, float_text);
  } catch (const std::bad_alloc&) {
    throw ReadError(path, say("the mesh is too large for the memory of this computer"), {},
                    say("Close other programs, or reduce it."));
  } catch (const std::length_error&) {
    throw ReadError(path, say("the mesh is too large for this program"), {}, say("Reduce it first."));
  }
}

}  // namespace loopmend

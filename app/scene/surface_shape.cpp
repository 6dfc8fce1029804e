// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/surface_shape.h"

#include "core/release.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace loopmend {
namespace {

constexpr int blended_rings = 3;

void put(std::vector<float>& out, std::size_t i, const Vec3& v) {
  for (int k = 0; k < 3; ++k) out[3 * i + static_cast<std::size_t>(k)] = static_cast<float>(v[k]);
}

Vec3 get(const std::vector<float>& in, int i) {
  const auto at = 3 * static_cast<std::size_t>(i);
  return {in[at], in[at + 1], in[at + 2]};
}

Points area_weighted_normals(const SurfaceShape& shape) {
  Points normals(shape.points.size() / 3, Vec3::Zero());
  for (std::size_t t = 0; t + 2 < shape.triangles.size(); t += 3) {
    const int a = shape.triangles[t], b = shape.triangles[t + 1], c = shape.triangles[t + 2];
    const Vec3 p = get(shape.points, a);
    const Vec3 n = (get(shape.points, b) - p).cross(get(shape.points, c) - p);
    for (int v : {a, b, c}) normals[v] += n;
  }
  for (Vec3& n : normals) {
    const double length = n.norm();
    n = length > 0 ? Vec3(n / length) : Vec3::UnitZ();
  }
  return normals;
}

void set_area_weighted_normals(SurfaceShape& shape) {
  shape.normals.resize(shape.points.size());
  const Points normals = area_weighted_normals(shape);
  for (std::size_t i = 0; i < normals.size(); ++i) put(shape.normals, i, normals[i]);
}

/// A triangle at a vertex: its corners there, in order, from that vertex on.
struct Corner {
  int vertex = 0, next = 0, previous = 0;
  std::size_t at = 0;  ///< in the list of corners
  Vec3 normal;         ///< unit; zero of a triangle without area
};

/// Which corners of one vertex are connected across edges that are no creases. @returns the number of each one's group, from 0
std::vector<int> groups_of(std::span<const Corner> corners, double least_cosine) {
  std::vector<int> group(corners.size(), -1);
  std::vector<std::size_t> open;
  int groups = 0;
  for (std::size_t first = 0; first < corners.size(); ++first) {
    if (group[first] >= 0) continue;
    group[first] = groups;
    for (open = {first}; !open.empty();) {
      const Corner& one = corners[open.back()];
      open.pop_back();
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Corner& other = corners[k];
        if (group[k] >= 0 || (one.next != other.previous && one.previous != other.next)) continue;
        if (one.normal.dot(other.normal) < least_cosine) continue;
        group[k] = groups;
        open.push_back(k);
      }
    }
    ++groups;
  }
  return group;
}

bool is_known(const Vec3& normal) { return normal.squaredNorm() > 0.5; }

void set_fitted_normals(SurfaceShape& shape, const Points& fitted) {
  for (std::size_t i = 0; i < fitted.size(); ++i)
    if (is_known(fitted[i])) put(shape.normals, i, fitted[i]);
}

std::vector<float> to_floats(const std::vector<double>& values) {
  std::vector<float> out(values.size());
  std::transform(values.begin(), values.end(), out.begin(), [](double v) { return static_cast<float>(v); });
  return out;
}

std::vector<unsigned char> three_bytes(const std::vector<Color>& colors) {
  std::vector<unsigned char> bytes;
  bytes.reserve(3 * colors.size());
  for (const Color& color : colors) bytes.insert(bytes.end(), color.begin(), color.begin() + 3);
  return bytes;
}

TriangleList listed(std::span<const Triangle> triangles) {
  std::vector<int> corners;
  corners.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
  return corners;
}

}  // namespace

Vec3 scene_origin(const TriangleSoup& soup) {
  if (soup.points.empty()) return Vec3::Zero();
  Vec3 low = soup.points.front(), high = low;
  for (const Vec3& p : soup.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return 0.5 * (low + high);
}

SurfaceShape shape_of(const TriangleSoup& soup, const Vec3& origin) {
  SurfaceShape shape;
  shape.points.resize(3 * soup.points.size());
  for (std::size_t i = 0; i < soup.points.size(); ++i) put(shape.points, i, soup.points[i] - origin);
  shape.triangles = listed(soup.triangles);
  shape.own_triangles = static_cast<int>(soup.triangles.size());
  set_area_weighted_normals(shape);
  return shape;
}

TriangleList triangles_of_view(const TriMesh& mesh) {
  std::vector<int> corners;
  corners.reserve(3 * mesh.n_faces());
  for (auto face : mesh.faces())
    for (auto v : mesh.fv_range(face)) corners.push_back(v.idx());
  return corners;
}

SurfaceShape shape_of(const TriMesh& mesh, const Vec3& origin) {
  SurfaceShape shape;
  shape.points.resize(3 * mesh.n_vertices());
  for (std::size_t i = 0; i < mesh.n_vertices(); ++i)
    put(shape.points, i, mesh.point(mesh.vertex_handle(static_cast<unsigned>(i))) - origin);
  shape.triangles = triangles_of_view(mesh);
  shape.own_triangles = static_cast<int>(mesh.n_faces());
  set_area_weighted_normals(shape);
  return shape;
}

SurfaceShape parted_at_creases(SurfaceShape shape, double degrees) {
  const double half_cosine = std::cos(0.5 * degrees * std::numbers::pi / 180),
               least_cosine = std::cos(degrees * std::numbers::pi / 180);
  std::vector<Corner> corners;  // only those that lean far enough for a crease
  std::vector<char> leans(shape.points.size() / 3, 0);
  const auto each_corner = [&shape](auto&& visit) {
    for (std::size_t t = 0; t + 2 < shape.triangles.size(); t += 3) {
      const int v[] = {shape.triangles[t], shape.triangles[t + 1], shape.triangles[t + 2]};
      const Vec3 p = get(shape.points, v[0]);
      const Vec3 normal = (get(shape.points, v[1]) - p).cross(get(shape.points, v[2]) - p).normalized();
      for (std::size_t k = 0; k < 3; ++k) visit(Corner{v[k], v[(k + 1) % 3], v[(k + 2) % 3], t + k, normal});
    }
  };
  each_corner([&](const Corner& c) {
    if (c.normal.dot(get(shape.normals, c.vertex)) < half_cosine) leans[c.vertex] = 1;
  });
  each_corner([&](const Corner& c) {
    if (leans[c.vertex]) corners.push_back(c);
  });
  if (corners.empty()) return shape;
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.vertex < b.vertex; });
  std::vector<int> triangles(shape.triangles.begin(), shape.triangles.end());
  for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
    while (end < corners.size() && corners[end].vertex == corners[begin].vertex) ++end;
    const std::vector<int> group = groups_of(std::span(corners).subspan(begin, end - begin), least_cosine);
    const Vec3 place = get(shape.points, corners[begin].vertex);
    const int added = static_cast<int>(shape.points.size() / 3) - 1;  // the first group keeps the vertex
    shape.points.resize(shape.points.size() +
                        3 * static_cast<std::size_t>(*std::max_element(group.begin(), group.end())));
    for (std::size_t k = 0; k < group.size(); ++k) {
      if (group[k] == 0) continue;
      triangles[corners[begin + k].at] = added + group[k];
      put(shape.points, static_cast<std::size_t>(added + group[k]), place);
    }
  }
  shape.triangles = std::move(triangles);
  set_area_weighted_normals(shape);
  return shape;
}

SurfaceShape with_curvature(const SurfaceShape& shape, CurvatureField field) {
  SurfaceShape colored;
  colored.normals = shape.normals;
  set_fitted_normals(colored, field.normals);
  release(field.normals);
  colored.H = to_floats(field.H);
  release(field.H);
  colored.K = to_floats(field.K);
  release(field.K);
  colored.points = shape.points;
  colored.triangles = shape.triangles;
  colored.own_triangles = shape.own_triangles;
  colored.colors = shape.colors;
  return colored;
}

SurfaceShapePtr shape_of(const Patch& patch, const Vec3& origin,
                         const std::shared_ptr<const std::vector<Color>>& scan_colors) {
  const CurvatureField field = curvature_field(patch);
  auto made = std::make_shared<SurfaceShape>();
  SurfaceShape& shape = *made;
  shape.points.resize(3 * patch.positions.size());
  for (std::size_t i = 0; i < patch.positions.size(); ++i)
    put(shape.points, i, patch.to_mesh(patch.positions[i]) - origin);
  shape.own_triangles = patch.patch_triangles;
  std::vector<Triangle> shown(patch.triangles.begin(), patch.triangles.begin() + patch.patch_triangles);
  std::copy_if(patch.triangles.begin() + patch.patch_triangles, patch.triangles.end(), std::back_inserter(shown),
               [&](const Triangle& t) {
                 return std::all_of(t.begin(), t.end(), [&](int v) { return patch.ring[v] <= blended_rings; });
               });
  shape.triangles = listed(shown);
  shape.normals.resize(shape.points.size());
  if (!std::all_of(field.normals.begin(), field.normals.end(), is_known)) set_area_weighted_normals(shape);
  set_fitted_normals(shape, field.normals);
  shape.H = to_floats(field.H);
  shape.K = to_floats(field.K);
  shape.scan_colors = scan_colors;
  if (scan_colors) shape.colors = three_bytes(patch_colors(patch, *scan_colors));
  return made;
}

const std::vector<float>& values_of(const SurfaceShape& shape, Shading shading) {
  static const std::vector<float> none;
  switch (shading) {
    case Shading::curvature: return shape.H;
    case Shading::gaussian: return shape.K;
    case Shading::deviation: return shape.deviation;
    case Shading::difference: return shape.difference;
    case Shading::plain:
    case Shading::zebra:
    case Shading::isophotes:
    case Shading::scan: break;
  }
  return none;
}

SurfaceShapePtr with_deviation(const SurfaceShape& shape, std::span<const double> of_free_vertices) {
  auto known = std::make_shared<SurfaceShape>(shape);
  known->deviation.assign(of_free_vertices.begin(), of_free_vertices.end());
  if (!known->deviation.empty()) known->deviation.resize(shape.points.size() / 3, 0);
  return known;
}

std::vector<SurfaceShapePtr> colored_parts(const ScanColors& colors, SurfaceShape& view) {
  std::vector<SurfaceShapePtr> parts;
  if (colors.at_vertices.size() * 3 == view.points.size()) view.colors = three_bytes(colors.at_vertices);
  for (const ColoredPart& part : colors.parts) {
    auto shape = std::make_shared<SurfaceShape>();
    shape->points.reserve(3 * part.view_vertex.size());
    shape->normals.reserve(3 * part.view_vertex.size());
    for (int v : part.view_vertex)
      for (std::size_t k = 0; k < 3; ++k) {
        shape->points.push_back(view.points[3 * static_cast<std::size_t>(v) + k]);
        shape->normals.push_back(view.normals[3 * static_cast<std::size_t>(v) + k]);
      }
    shape->triangles = listed(part.triangles);
    shape->own_triangles = static_cast<int>(part.triangles.size());
    shape->colors = three_bytes(part.colors);
    shape->texture = part.texture;
    shape->picture = part.picture;
    shape->view_vertex = part.view_vertex;
    parts.push_back(std::make_shared<SurfaceShape>(with_reduced(std::move(*shape))));
  }
  return parts;
}

std::shared_ptr<SurfaceShape> with_triangles(const SurfaceShape& whole, std::span<const int> triangles,
                                             std::vector<int>& number) {
  auto shape = std::make_shared<SurfaceShape>();
  shape->picture = whole.picture;
  std::vector<int> corners;
  corners.reserve(3 * triangles.size());
  if (number.size() < whole.points.size() / 3) number.resize(whole.points.size() / 3, -1);
  std::vector<int> used;
  for (int t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = whole.triangles[3 * static_cast<std::size_t>(t) + k];
      int& n = number[v];
      if (n < 0) {
        n = static_cast<int>(used.size());
        used.push_back(v);
      }
      corners.push_back(n);
    }
    if (t < whole.own_triangles) ++shape->own_triangles;
  }
  shape->triangles = std::move(corners);
  const auto take = [&used](const auto& from, std::size_t components, auto& to) {
    if (from.empty()) return;
    to.reserve(components * used.size());
    for (int v : used)
      for (std::size_t k = 0; k < components; ++k) to.push_back(from[components * static_cast<std::size_t>(v) + k]);
  };
  take(whole.points, 3, shape->points);
  take(whole.normals, 3, shape->normals);
  take(whole.H, 1, shape->H);
  take(whole.K, 1, shape->K);
  take(whole.deviation, 1, shape->deviation);
  take(whole.colors, 3, shape->colors);
  take(whole.texture, 2, shape->texture);
  for (int v : used) number[v] = -1;
  return shape;
}

double symmetric_range(std::span<const float> values, double percent) {
  constexpr std::size_t enough = 1'000'000;  // all of 7 million take 60 ms on the thread that draws
  const std::size_t stride = 1 + values.size() / (enough + 1);
  std::vector<float> known;
  known.reserve(1 + values.size() / stride);
  for (std::size_t i = 0; i < values.size(); i += stride)
    if (std::isfinite(values[i])) known.push_back(values[i]);
  if (known.empty()) return 1;
  const auto quantile = [&](double q) {
    const auto at = known.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(known.size() - 1));
    std::nth_element(known.begin(), at, known.end());
    return static_cast<double>(*at);
  };
  const double low = quantile(1 - percent / 100), high = quantile(percent / 100);
  double range = std::max(std::abs(low), std::abs(high));
  const bool is_nearly_constant = low * high > 0 && std::min(std::abs(low), std::abs(high)) > 0.5 * range;
  if (is_nearly_constant) range *= 2;
  if (!(range > 0)) return 1;
  const double unit = std::pow(10.0, std::floor(std::log10(range)) - 1);
  return std::round(range / unit) * unit;
}

}  // namespace loopmend

// SPDX-License-Identifier: GPL-3.0-or-later
#include "texture/paint_patches.h"

#include "texture/chart.h"
#include "texture/inpaint.h"
#include "texture/texture_of_triangles.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace loopmend {

namespace {

constexpr int margin = 4;           ///< pixels around a patch, so that filtering finds the right ones
constexpr int most_pixels = 2048;   ///< of one patch, a side
constexpr int most_rings = 24;      ///< of the scan around a patch
constexpr double collar_share = 4;  ///< so many times the triangles of the patch around it
constexpr std::size_t least_collar = 400;
constexpr double most_area = 1.2e8;  ///< pixels of all patches: readers take 16384 a side

/// A patch and the textured triangles around it.
struct Piece {
  std::vector<int> own, around;  ///< soup triangles
};

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Calls `each` with the pixels whose centres lie in the triangle, and their barycentric coordinates.
template <class Each>
void for_each_pixel(const std::array<Vec2, 3>& t, int width, int height, const Each& each) {
  const double area = cross(t[1] - t[0], t[2] - t[0]);
  if (!(std::abs(area) > 0)) return;
  const auto [low_x, high_x] = std::minmax({t[0].x(), t[1].x(), t[2].x()});
  const auto [low_y, high_y] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
  constexpr double edge = 1e-9;
  for (int y = std::max(0, static_cast<int>(std::floor(low_y))); y <= std::min(height - 1, static_cast<int>(high_y));
       ++y)
    for (int x = std::max(0, static_cast<int>(std::floor(low_x))); x <= std::min(width - 1, static_cast<int>(high_x));
         ++x) {
      const Vec2 p(x + 0.5, y + 0.5);
      const double b = cross(p - t[0], t[2] - t[0]) / area, c = cross(t[1] - t[0], p - t[0]) / area;
      if (b < -edge || c < -edge || b + c > 1 + edge) continue;
      each(x, y, std::array<double, 3>{1 - b - c, b, c});
    }
}

/// A patch as it is painted.
struct PaintedPiece {
  Picture picture;
  std::vector<std::array<Vec2, 3>> at;  ///< pixels, per own triangle
  int left = 0, top = 0;                ///< its place in the picture of all
};

class Painter {
 public:
  Painter(const TriangleSoup& soup, const std::function<const Picture*(std::size_t)>& picture_of, TextureFill fill,
          const CancelToken& cancel, const std::function<void(double)>& progress)
      : soup_(soup),
        sources_(soup, picture_of),
        fill_(fill),
        cancel_(cancel),
        progress_(progress) {}

  PaintedPatches result() {
    PaintedPatches result;
    std::vector<Piece> pieces = find_pieces();
    std::vector<int> number(soup_.triangles.size(), -1);
    int count = 0;
    for (std::size_t f = 0; f < soup_.triangles.size(); ++f)
      if (triangle_row(soup_, f) < 0) number[f] = count++;
    result.is_painted.assign(static_cast<std::size_t>(count), 0);
    std::vector<std::pair<const Piece*, PaintedPiece>> painted;
    double area = 0;
    std::size_t before = 0;  // triangles of the pieces that are done
    for (const Piece& piece : pieces) {
      if (cancel_.cancelled()) return {};
      const auto tell = [&, mine = piece.own.size()](double share) {
        if (progress_) progress_((static_cast<double>(before) + share * static_cast<double>(mine)) / count);
      };
      tell(0);
      std::optional<PaintedPiece> one;
      if (area < most_area && !piece.around.empty()) one = paint(piece, tell);
      before += piece.own.size();
      if (one) {
        area += static_cast<double>(one->picture.width) * one->picture.height;
        painted.emplace_back(&piece, std::move(*one));
      } else if (!piece.around.empty()) {
        result.not_painted += piece.own.size();
      }
    }
    if (painted.empty()) return result;
    arrange(painted, result.picture);
    result.texture.dimension = 2;
    result.texture.at.assign(3 * static_cast<std::size_t>(count), -1);
    for (const auto& [piece, one] : painted)
      for (std::size_t k = 0; k < piece->own.size(); ++k) {
        const int mine = number[piece->own[k]];
        result.is_painted[mine] = 1;
        for (int corner = 0; corner < 3; ++corner) {
          result.texture.at[3 * static_cast<std::size_t>(mine) + static_cast<std::size_t>(corner)] =
              static_cast<int>(result.texture.count());
          const Vec2 pixel = one.at[k][corner] + Vec2(one.left, one.top);
          result.texture.values.push_back(pixel.x() / result.picture.width);
          result.texture.values.push_back(1 - pixel.y() / result.picture.height);
        }
      }
    return result;
  }

 private:
  /// New triangles that hang together by vertices, each with rings of the file's around it.
  std::vector<Piece> find_pieces() {
    std::vector<std::vector<int>> at(soup_.points.size());
    for (std::size_t f = 0; f < soup_.triangles.size(); ++f)
      for (int v : soup_.triangles[f]) at[v].push_back(static_cast<int>(f));
    std::vector<int> piece_of(soup_.triangles.size(), -1);
    std::vector<Piece> pieces;
    for (std::size_t f = 0; f < soup_.triangles.size(); ++f) {
      if (triangle_row(soup_, f) >= 0 || piece_of[f] >= 0) continue;
      Piece& piece = pieces.emplace_back();
      const int mine = static_cast<int>(pieces.size()) - 1;
      piece.own.push_back(static_cast<int>(f));
      piece_of[f] = mine;
      for (std::size_t k = 0; k < piece.own.size(); ++k)
        for (int v : soup_.triangles[piece.own[k]])
          for (int other : at[v])
            if (triangle_row(soup_, other) < 0 && std::exchange(piece_of[other], mine) != mine)
              piece.own.push_back(other);
      std::sort(piece.own.begin(), piece.own.end());
      add_rings(at, piece);
    }
    return pieces;
  }

  void add_rings(const std::vector<std::vector<int>>& at, Piece& piece) const {
    const auto most =
        std::max(least_collar, static_cast<std::size_t>(collar_share * static_cast<double>(piece.own.size())));
    std::vector<int> ring = piece.own;
    std::unordered_set<int> seen;
    for (int k = 0; k < most_rings && !ring.empty() && piece.around.size() < most; ++k) {
      std::vector<int> next;
      for (int f : ring)
        for (int v : soup_.triangles[f])
          for (int other : at[v])
            if (triangle_row(soup_, other) >= 0 && seen.insert(other).second && sources_.find(other))
              next.push_back(other);
      piece.around.insert(piece.around.end(), next.begin(), next.end());
      ring = std::move(next);
    }
  }

  /// Pixels for each unit of length, as in the pictures around.
  double density(const std::vector<int>& around) const {
    double pixels = 0, area = 0;
    for (int f : around) {
      const auto source = *sources_.find(f);
      const Vec2 size(source.picture->width, source.picture->height);
      pixels += std::abs(cross((source.at[1] - source.at[0]).cwiseProduct(size),
                               (source.at[2] - source.at[0]).cwiseProduct(size))) /
                2;
      const Triangle& t = soup_.triangles[f];
      area += (soup_.points[t[1]] - soup_.points[t[0]]).cross(soup_.points[t[2]] - soup_.points[t[0]]).norm() / 2;
    }
    return area > 0 ? std::sqrt(pixels / area) : 0;
  }

  std::optional<PaintedPiece> paint(const Piece& piece, const std::function<void(double)>& tell) const {
    std::vector<int> all = piece.own;
    all.insert(all.end(), piece.around.begin(), piece.around.end());
    std::unordered_map<int, int> local;
    Points points;
    Triangles triangles;
    for (int f : all) {
      Triangle t = soup_.triangles[f];
      for (int& v : t) {
        const auto [mine, is_new] = local.emplace(v, static_cast<int>(points.size()));
        if (is_new) points.push_back(soup_.points[v]);
        v = mine->second;
      }
      triangles.push_back(t);
    }
    const auto flat = flatten(points, triangles, piece.own.size());
    double scale = density(piece.around);
    if (!flat || !(scale > 0)) return {};
    // The patch with a frame of the scan, as far as texture is looked for.
    Eigen::AlignedBox2d box;
    for (std::size_t f = 0; f < piece.own.size(); ++f)
      for (int v : triangles[f]) box.extend((*flat)[v]);
    const double longest = box.sizes().maxCoeff();
    if (scale * longest > most_pixels) scale = most_pixels / longest;
    const int frame = std::max(24, static_cast<int>(0.4 * scale * longest));
    const Vec2 corner = box.min() - Vec2::Constant(frame / scale);
    const int width = static_cast<int>(std::ceil(scale * box.sizes().x())) + 2 * frame;
    const int height = static_cast<int>(std::ceil(scale * box.sizes().y())) + 2 * frame;
    const auto place = [&](int v) {  // pixels, y downward
      const Vec2 p = scale * ((*flat)[v] - corner);
      return Vec2(p.x(), height - p.y());
    };
    Picture picture(width, height);
    std::vector<Pixel> pixels(picture.pixels.size(), Pixel::outside);
    const auto at = [&](int x, int y) -> Pixel& {
      return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    };
    for (std::size_t f = piece.own.size(); f < triangles.size(); ++f) {
      const std::array<Vec2, 3> t = {place(triangles[f][0]), place(triangles[f][1]), place(triangles[f][2])};
      if (cross(t[1] - t[0], t[2] - t[0]) >= 0) continue;  // y is downward: turned round in the plane
      const auto source = *sources_.find(piece.around[f - piece.own.size()]);
      for_each_pixel(t, width, height, [&](int x, int y, const std::array<double, 3>& w) {
        picture.at(x, y) = color_at(*source.picture, w[0] * source.at[0] + w[1] * source.at[1] + w[2] * source.at[2]);
        at(x, y) = Pixel::known;
      });
    }
    PaintedPiece result;
    for (std::size_t f = 0; f < piece.own.size(); ++f) {
      result.at.push_back({place(triangles[f][0]), place(triangles[f][1]), place(triangles[f][2])});
      for_each_pixel(result.at.back(), width, height,
                     [&](int x, int y, const std::array<double, 3>&) { at(x, y) = Pixel::wanted; });
    }
    want_margin(pixels, width, height);
    if (fill_ == TextureFill::grain)
      inpaint_like(picture, pixels, cancel_, tell);
    else
      inpaint_smoothly(picture, pixels);
    crop(picture, frame - margin, result);
    return result;
  }

  /// Pixels near the patch that nothing covers: bordering ones are needed where the picture is filtered.
  static void want_margin(std::vector<Pixel>& pixels, int width, int height) {
    for (int round = 0; round < margin; ++round) {
      const std::vector<Pixel> before = pixels;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const auto wanted = [&](int dx, int dy) {
            const int nx = x + dx, ny = y + dy;
            return nx >= 0 && ny >= 0 && nx < width && ny < height &&
                   before[static_cast<std::size_t>(ny) * static_cast<std::size_t>(width) +
                          static_cast<std::size_t>(nx)] == Pixel::wanted;
          };
          Pixel& mine =
              pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
          if (mine == Pixel::outside && (wanted(1, 0) || wanted(-1, 0) || wanted(0, 1) || wanted(0, -1)))
            mine = Pixel::wanted;
        }
    }
  }

  static void crop(const Picture& picture, int cut, PaintedPiece& result) {
    result.picture = Picture(picture.width - 2 * cut, picture.height - 2 * cut);
    for (int y = 0; y < result.picture.height; ++y)
      for (int x = 0; x < result.picture.width; ++x) result.picture.at(x, y) = picture.at(x + cut, y + cut);
    for (auto& t : result.at)
      for (Vec2& p : t) p -= Vec2::Constant(cut);
  }

  /// Side by side in rows, the highest first.
  static void arrange(std::vector<std::pair<const Piece*, PaintedPiece>>& painted, Picture& all) {
    std::vector<std::size_t> order(painted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return painted[a].second.picture.height > painted[b].second.picture.height;
    });
    double area = 0;
    int widest = 0;
    for (const auto& [piece, one] : painted) {
      area += static_cast<double>(one.picture.width) * one.picture.height;
      widest = std::max(widest, one.picture.width);
    }
    const int width = std::max(widest, static_cast<int>(std::ceil(1.1 * std::sqrt(area))));
    int x = 0, y = 0, row_height = 0, used = 0;
    for (std::size_t k : order) {
      PaintedPiece& one = painted[k].second;
      if (x + one.picture.width > width) {
        x = 0;
        y += std::exchange(row_height, 0);
      }
      one.left = x;
      one.top = y;
      x += one.picture.width;
      used = std::max(used, x);
      row_height = std::max(row_height, one.picture.height);
    }
    all = Picture(used, y + row_height);
    for (const auto& [piece, one] : painted)
      for (int py = 0; py < one.picture.height; ++py)
        for (int px = 0; px < one.picture.width; ++px) all.at(one.left + px, one.top + py) = one.picture.at(px, py);
  }

  const TriangleSoup& soup_;
  TextureOfTriangles sources_;
  TextureFill fill_;
  const CancelToken& cancel_;
  const std::function<void(double)>& progress_;
};

}  // namespace

PaintedPatches paint_patches(const TriangleSoup& soup, const std::function<const Picture*(std::size_t)>& picture_of,
                             TextureFill fill, const CancelToken& cancel, const std::function<void(double)>& progress) {
  if (!soup.attributes || soup.attributes->texture.count() == 0 || soup.attributes->texture.at.empty()) return {};
  return Painter(soup, picture_of, fill, cancel, progress).result();
}

}  // namespace loopmend

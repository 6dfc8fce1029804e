// SPDX-License-Identifier: GPL-3.0-or-later
#include "texture/inpaint.h"

#include "core/threads.h"
#include "solvers/linear_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace loopmend {

namespace {

using Rgb = Eigen::Vector3f;
constexpr int rows_at_a_time = 4;

/// A picture in numbers that may lie between the 256.
struct Field {
  int width = 0, height = 0;
  std::vector<Rgb> colors;
  std::vector<Pixel> pixels;

  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
};

Field field_of(const Picture& picture, const std::vector<Pixel>& pixels) {
  Field field{picture.width, picture.height, {}, pixels};
  field.colors.reserve(picture.pixels.size());
  for (const Color& c : picture.pixels) field.colors.emplace_back(c[0], c[1], c[2]);
  return field;
}

void put_back(const Field& field, Picture& picture) {
  for (std::size_t k = 0; k < field.colors.size(); ++k) {
    if (field.pixels[k] != Pixel::wanted) continue;
    for (int c = 0; c < 3; ++c)
      picture.pixels[k][c] = static_cast<unsigned char>(std::lround(std::clamp(field.colors[k][c], 0.0F, 255.0F)));
    picture.pixels[k][3] = 255;
  }
}

/// Half as wide and high. A pixel is wanted if one of its four is, else known if one is; its colour is the mean of the known.
Field half_of(const Field& fine) {
  Field coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}, {}};
  const std::size_t size = static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height);
  coarse.colors.assign(size, Rgb::Zero());
  coarse.pixels.assign(size, Pixel::outside);
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) {
      Rgb sum = Rgb::Zero();
      int known = 0, wanted = 0;
      for (int k = 0; k < 4; ++k) {
        const int fx = 2 * x + k % 2, fy = 2 * y + k / 2;
        if (!fine.contains(fx, fy)) continue;
        const std::size_t at = fine.place(fx, fy);
        wanted += fine.pixels[at] == Pixel::wanted;
        if (fine.pixels[at] != Pixel::known) continue;
        sum += fine.colors[at];
        ++known;
      }
      const std::size_t at = coarse.place(x, y);
      if (known > 0) coarse.colors[at] = sum / static_cast<float>(known);
      coarse.pixels[at] = wanted > 0 ? Pixel::wanted : (known > 0 ? Pixel::known : Pixel::outside);
    }
  return coarse;
}

/// The wanted pixels of the picture of twice the size.
void take_over(const Field& half, Field& field) {
  for (int y = 0; y < field.height; ++y)
    for (int x = 0; x < field.width; ++x)
      if (field.pixels[field.place(x, y)] == Pixel::wanted)
        field.colors[field.place(x, y)] = half.colors[half.place(x / 2, y / 2)];
}

constexpr std::array<std::pair<int, int>, 4> beside = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

void continue_smoothly(Field& field);

/// By the picture at half its size, then some rounds of means.
void continue_by_half(Field& field) {
  Field half = half_of(field);
  continue_smoothly(half);
  take_over(half, field);
  constexpr int rounds = 40;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Rgb> before = field.colors;
    parallel_for(0, field.height, rows_at_a_time, [&](int y) {
      for (int x = 0; x < field.width; ++x) {
        if (field.pixels[field.place(x, y)] != Pixel::wanted) continue;
        Rgb sum = Rgb::Zero();
        int count = 0;
        for (const auto& [dx, dy] : beside) {
          if (!field.contains(x + dx, y + dy) || field.pixels[field.place(x + dx, y + dy)] == Pixel::outside) continue;
          sum += before[field.place(x + dx, y + dy)];
          ++count;
        }
        if (count > 0) field.colors[field.place(x, y)] = sum / static_cast<float>(count);
      }
    });
  }
}

/// The wanted pixels that known ones reach, numbered. −1: others.
std::vector<int> numbers_of(const Field& field, int& count) {
  std::vector<int> number(field.pixels.size(), -1);
  std::vector<std::pair<int, int>> front;
  count = 0;
  const auto take = [&](int x, int y) {
    if (!field.contains(x, y)) return;
    int& mine = number[field.place(x, y)];
    if (mine >= 0 || field.pixels[field.place(x, y)] != Pixel::wanted) return;
    mine = count++;
    front.emplace_back(x, y);
  };
  for (int y = 0; y < field.height; ++y)
    for (int x = 0; x < field.width; ++x)
      if (field.pixels[field.place(x, y)] == Pixel::known)
        for (const auto& [dx, dy] : beside) take(x + dx, y + dy);
  for (std::size_t k = 0; k < front.size(); ++k)
    for (const auto& [dx, dy] : beside) take(front[k].first + dx, front[k].second + dy);
  return number;
}

void continue_smoothly(Field& field) {
  constexpr int most_unknowns = 100'000;
  int count = 0;
  const std::vector<int> number = numbers_of(field, count);
  for (std::size_t k = 0; k < number.size(); ++k)
    if (field.pixels[k] == Pixel::wanted) field.colors[k] = Rgb::Zero();
  if (count == 0) return;
  if (count > most_unknowns) return continue_by_half(field);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(count, 3);
  for (int y = 0; y < field.height; ++y)
    for (int x = 0; x < field.width; ++x) {
      const int row = number[field.place(x, y)];
      if (row < 0) continue;
      double weight = 0;
      for (const auto& [dx, dy] : beside) {
        if (!field.contains(x + dx, y + dy)) continue;
        const std::size_t other = field.place(x + dx, y + dy);
        if (field.pixels[other] == Pixel::outside) continue;
        weight += 1;
        if (number[other] >= 0)
          entries.emplace_back(row, number[other], -1);
        else
          b.row(row) += field.colors[other].cast<double>().transpose();
      }
      entries.emplace_back(row, row, weight);
    }
  Eigen::SparseMatrix<double> A(count, count);
  A.setFromTriplets(entries.begin(), entries.end());
  A.makeCompressed();
  const auto solver = make_spd_solver();
  Eigen::MatrixXd solution;
  if (!solver->factorize(A) || !solver->solve(b, solution)) return;
  for (std::size_t k = 0; k < number.size(); ++k)
    if (number[k] >= 0) field.colors[k] = solution.row(number[k]).transpose().cast<float>();
}

constexpr int reach = 8;               ///< of a square that is compared: 17 by 17 pixels
constexpr int fill_reach = 5;          ///< of the square that is copied from it
constexpr int coarsenings = 4;         ///< what is shading and what is texture part at 2⁴ pixels
constexpr int candidates = 1500;       ///< squares looked at for each that is copied
constexpr int at_once = 250;           ///< of them
constexpr int most_searched = 12'000;  ///< wanted pixels; of more the search begins at half the size
constexpr float nearly_best = 1.1;     ///< the first that fits so well, by chance, so that no square is seen all over

/// The shading: means over 2ᵏ pixels, continued smoothly over what is wanted, between them linear.
std::vector<Rgb> shading_of(const Field& field, int k) {
  if (k == 0) {
    Field smooth = field;
    continue_smoothly(smooth);
    return smooth.colors;
  }
  const Field half = half_of(field);
  const std::vector<Rgb> coarse = shading_of(half, k - 1);
  std::vector<Rgb> result(field.colors.size(), Rgb::Zero());
  parallel_for(0, field.height, rows_at_a_time, [&](int y) {
    for (int x = 0; x < field.width; ++x) {
      const double cx = (x + 0.5) / 2 - 0.5, cy = (y + 0.5) / 2 - 0.5;
      const int x0 = static_cast<int>(std::floor(cx)), y0 = static_cast<int>(std::floor(cy));
      Rgb sum = Rgb::Zero();
      float weights = 0;
      for (int corner = 0; corner < 4; ++corner) {
        const int nx = x0 + corner % 2, ny = y0 + corner / 2;
        if (!half.contains(nx, ny) || half.pixels[half.place(nx, ny)] == Pixel::outside) continue;
        const auto weight =
            static_cast<float>((corner % 2 ? cx - x0 : x0 + 1 - cx) * (corner / 2 ? cy - y0 : y0 + 1 - cy));
        sum += weight * coarse[half.place(nx, ny)];
        weights += weight;
      }
      if (weights > 0) result[field.place(x, y)] = sum / weights;
    }
  });
  return result;
}

/// A place in a picture, x and y. (−1, −1): none.
using Places = std::vector<std::pair<int, int>>;

/// Half as wide and high. A pixel is wanted if one of its four is, and known if all four are.
Field known_half_of(const Field& fine) {
  Field coarse = half_of(fine);
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) {
      Pixel& mine = coarse.pixels[coarse.place(x, y)];
      for (int k = 0; k < 4 && mine == Pixel::known; ++k)
        if (!fine.contains(2 * x + k % 2, 2 * y + k / 2) ||
            fine.pixels[fine.place(2 * x + k % 2, 2 * y + k / 2)] != Pixel::known)
          mine = Pixel::outside;
    }
  return coarse;
}

/// The places of a picture's half, in the picture.
Places doubled(const Places& of_half, const Field& half, const Field& field) {
  Places places(field.pixels.size(), {-1, -1});
  for (int y = 0; y < field.height; ++y)
    for (int x = 0; x < field.width; ++x)
      if (const auto& [hx, hy] = of_half[half.place(x / 2, y / 2)]; hx >= 0)
        places[field.place(x, y)] = {2 * hx + x % 2, 2 * hy + y % 2};
  return places;
}

/// Where the square around a pixel is known throughout.
std::vector<char> whole_squares(const Field& field) {
  const std::size_t row = static_cast<std::size_t>(field.width) + 1;
  std::vector<int> sums(row * (static_cast<std::size_t>(field.height) + 1), 0);  // known pixels above and left
  const auto sum = [&](int x, int y) -> int& {
    return sums[static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < field.height; ++y)
    for (int x = 0; x < field.width; ++x)
      sum(x + 1, y + 1) =
          sum(x, y + 1) + sum(x + 1, y) - sum(x, y) + (field.pixels[field.place(x, y)] == Pixel::known ? 1 : 0);
  constexpr int side = 2 * reach + 1;
  std::vector<char> result(field.pixels.size(), 0);
  for (int y = reach; y + reach < field.height; ++y)
    for (int x = reach; x + reach < field.width; ++x) {
      const int left = x - reach, top = y - reach, right = x + reach + 1, bottom = y + reach + 1;
      result[field.place(x, y)] =
          sum(right, bottom) - sum(left, bottom) - sum(right, top) + sum(left, top) == side * side ? 1 : 0;
    }
  return result;
}

/// Copies squares of known texture to the edge of what is wanted, those places first of which the most is known.
class Quilt {
 public:
  /// @param guess  where each pixel comes from, about; empty: squares are looked for everywhere.
  Quilt(Field& field, Places guess, const CancelToken& cancel)
      : field_(field),
        cancel_(cancel),
        guess_(std::move(guess)),
        from_(field.pixels.size(), {-1, -1}),
        is_source_(whole_squares(field)),
        state_(field.pixels) {
    for (int y = 0; y < field.height; ++y)
      for (int x = 0; x < field.width; ++x)
        if (is_source_[field.place(x, y)]) sources_.emplace_back(x, y);
  }

  /// Fewer would repeat themselves visibly.
  bool has_sources() const { return sources_.size() >= 500; }

  /// @param progress  gets the share that is done
  void run(const std::function<void(double)>& progress) {
    for (int y = 0; y < field_.height; ++y)
      for (int x = 0; x < field_.width; ++x) consider(x, y);
    const auto wanted = static_cast<double>(std::count(state_.begin(), state_.end(), Pixel::wanted));
    constexpr int squares_between = 64;
    int squares = 0;
    while (!front_.empty() && !cancel_.cancelled()) {
      const auto [known, x, y] = front_.top();
      front_.pop();
      if (state_[field_.place(x, y)] != Pixel::wanted) continue;
      if (known_around(x, y) != known) {  // more is known by now
        consider(x, y);
        continue;
      }
      copy_to(x, y);
      if (++squares % squares_between == 0)
        progress(1 - static_cast<double>(std::count(state_.begin(), state_.end(), Pixel::wanted)) / wanted);
    }
  }

  /// Where each pixel came from.
  Places&& places() && { return std::move(from_); }

 private:
  int known_around(int x, int y) const {
    int count = 0;
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx)
        count += field_.contains(x + dx, y + dy) && state_[field_.place(x + dx, y + dy)] == Pixel::known;
    return count;
  }

  /// Into the queue, where it is wanted and has a known neighbour.
  void consider(int x, int y) {
    if (!field_.contains(x, y) || state_[field_.place(x, y)] != Pixel::wanted) return;
    for (const auto& [dx, dy] : beside)
      if (field_.contains(x + dx, y + dy) && state_[field_.place(x + dx, y + dy)] == Pixel::known) {
        front_.emplace(known_around(x, y), x, y);
        return;
      }
  }

  void copy_to(int x, int y) {
    const auto [sx, sy] = best_source(x, y);
    for (int dy = -fill_reach; dy <= fill_reach; ++dy)
      for (int dx = -fill_reach; dx <= fill_reach; ++dx) {
        if (!field_.contains(x + dx, y + dy)) continue;
        const std::size_t at = field_.place(x + dx, y + dy);
        if (state_[at] != Pixel::wanted) continue;
        field_.colors[at] = field_.colors[field_.place(sx + dx, sy + dy)];
        state_[at] = Pixel::known;
        from_[at] = {sx + dx, sy + dy};
      }
    const int edge = fill_reach + 1;
    for (int d = -edge; d <= edge; ++d)
      for (const auto& [nx, ny] : {std::pair(x + d, y - edge), {x + d, y + edge}, {x - edge, y + d}, {x + edge, y + d}})
        consider(nx, ny);
  }

  std::pair<int, int> best_source(int x, int y) {
    // What is compared: the known pixels of the square.
    compared_.clear();
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx)
        if (field_.contains(x + dx, y + dy) && state_[field_.place(x + dx, y + dy)] == Pixel::known)
          compared_.push_back({dx, dy, field_.colors[field_.place(x + dx, y + dy)]});
    ask(x, y);
    std::vector<float> costs(asked_.size());
    const int count = static_cast<int>(asked_.size());
    parallel_for(0, (count + at_once - 1) / at_once, 1, [&](int part) {
      float best = std::numeric_limits<float>::max();  // of this part: what is kept does not depend on the order
      for (int k = part * at_once; k < std::min((part + 1) * at_once, count); ++k) {
        costs[k] = cost(asked_[k], nearly_best * best);
        best = std::min(best, costs[k]);
      }
    });
    const float best = *std::min_element(costs.begin(), costs.end());
    for (std::size_t k = asked_.size(); k-- > 0;)  // the random ones first
      if (costs[k] <= nearly_best * best) return asked_[k];
    return asked_.front();
  }

  /// The squares that go on from which the neighbors came, those guessed, and random ones.
  void ask(int x, int y) {
    asked_.clear();
    const auto ask_one = [&](const std::pair<int, int>& place, int dx, int dy) {
      const std::pair<int, int> source(place.first - dx, place.second - dy);
      if (place.first < 0 || !field_.contains(source.first, source.second)) return;
      if (!is_source_[field_.place(source.first, source.second)]) return;
      if (guess_.empty() || std::find(asked_.begin(), asked_.end(), source) == asked_.end()) asked_.push_back(source);
    };
    const auto ask_around = [&](const Places& places) {
      for (int dy = -reach; dy <= reach; dy += 4)
        for (int dx = -reach; dx <= reach; dx += 4)
          if (field_.contains(x + dx, y + dy)) ask_one(places[field_.place(x + dx, y + dy)], dx, dy);
    };
    ask_around(from_);
    if (!guess_.empty()) {
      ask_around(guess_);
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) ask_one(guess_[field_.place(x, y)], dx, dy);
      if (!asked_.empty()) return;
    }
    Draws draws(x, y);
    while (asked_.size() < candidates) asked_.push_back(sources_[draws.below(static_cast<int>(sources_.size()))]);
  }

  /// Beyond `most` some number beyond it.
  float cost(const std::pair<int, int>& source, float most) const {
    float sum = 0;
    for (std::size_t k = 0; k < compared_.size() && sum <= most; ++k) {
      const Compared& pixel = compared_[k];
      sum +=
          (pixel.color - field_.colors[field_.place(source.first + pixel.dx, source.second + pixel.dy)]).squaredNorm();
    }
    return sum;
  }

  struct Compared {
    int dx, dy;
    Rgb color;
  };

  /// Random numbers that depend on the place alone.
  class Draws {
   public:
    Draws(int x, int y)
        : state_(static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U +
                 static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4FU + 1) {}
    int below(int limit) {
      state_ ^= state_ >> 12;
      state_ ^= state_ << 25;
      state_ ^= state_ >> 27;
      return static_cast<int>(((state_ * 0x2545F4914F6CDD1DU) >> 33) % static_cast<std::uint64_t>(limit));
    }

   private:
    std::uint64_t state_;
  };

  Field& field_;
  const CancelToken& cancel_;
  Places guess_, from_, sources_, asked_;
  std::vector<char> is_source_;
  std::vector<Pixel> state_;  ///< as far as it is filled
  std::vector<Compared> compared_;
  std::priority_queue<std::tuple<int, int, int>> front_;  ///< known pixels around, x, y
};

/// Large gaps first at half the size, whose squares say where to look. @returns where each pixel came from.
Places fill_with_squares(Field& field, const CancelToken& cancel, const std::function<void(double)>& progress) {
  constexpr double of_halves = 0.25;  // they have a quarter of the pixels
  Places guess;
  double before = 0;
  if (std::count(field.pixels.begin(), field.pixels.end(), Pixel::wanted) > most_searched) {
    Field half = known_half_of(field);
    if (Quilt(half, {}, cancel).has_sources()) {
      guess = doubled(fill_with_squares(half, cancel, [&](double share) { progress(of_halves * share); }), half, field);
      before = of_halves;
    }
  }
  Quilt quilt(field, std::move(guess), cancel);
  quilt.run([&](double share) { progress(before + (1 - before) * share); });
  return std::move(quilt).places();
}

}  // namespace

void inpaint_smoothly(Picture& picture, const std::vector<Pixel>& pixels) {
  Field field = field_of(picture, pixels);
  continue_smoothly(field);
  put_back(field, picture);
}

void inpaint_like(Picture& picture, const std::vector<Pixel>& pixels, const CancelToken& cancel,
                  const std::function<void(double)>& progress) {
  Field field = field_of(picture, pixels);
  if (!Quilt(field, {}, cancel).has_sources()) return inpaint_smoothly(picture, pixels);
  const std::vector<Rgb> shading = shading_of(field, coarsenings);
  for (std::size_t k = 0; k < shading.size(); ++k) field.colors[k] -= shading[k];
  fill_with_squares(field, cancel, [&](double share) {
    if (progress) progress(share);
  });
  for (std::size_t k = 0; k < shading.size(); ++k) field.colors[k] += shading[k];
  put_back(field, picture);
}

}  // namespace loopmend

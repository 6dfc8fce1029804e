// SPDX-License-Identifier: GPL-3.0-or-later
#include "texture/inpaint.h"

#include "core/random.h"
#include "core/threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace loopmend {
namespace {

struct Scene {
  Picture picture;
  std::vector<Pixel> pixels;
};

/// A picture with a round gap.
Scene scene(int size, double radius, const std::function<Color(int, int)>& color) {
  Scene made{Picture(size, size), {}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const bool gap = std::hypot(x - size / 2, y - size / 2) < radius;
      made.pixels.push_back(gap ? Pixel::wanted : Pixel::known);
      made.picture.at(x, y) = gap ? Color{0, 0, 0, 0} : color(x, y);
    }
  return made;
}

Color ramp(int x, int y) {
  return {static_cast<unsigned char>(x), static_cast<unsigned char>(y), static_cast<unsigned char>(250 - x), 255};
}

TEST(Inpaint, LinearColoursGoOn) {
  Scene made = scene(200, 60, ramp);
  inpaint_smoothly(made.picture, made.pixels);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) EXPECT_EQ(made.picture.at(x, y), ramp(x, y)) << x << ' ' << y;
}

/// Beyond 100 000 pixels by way of the picture at half its size.
TEST(Inpaint, LinearColoursGoOnOverLargeGaps) {
  const auto slow = [](int x, int y) {
    return Color{static_cast<unsigned char>(x / 4), static_cast<unsigned char>(y / 4), 7, 255};
  };
  Scene made = scene(640, 280, slow);
  inpaint_smoothly(made.picture, made.pixels);
  for (int y = 0; y < 640; y += 5)
    for (int x = 0; x < 640; x += 5) EXPECT_NEAR(made.picture.at(x, y)[0], slow(x, y)[0], 3);
}

TEST(Inpaint, WhatNothingReachesIsBlackAndWhatIsOutsideStays) {
  Scene made{Picture(9, 9, {1, 2, 3, 4}), std::vector<Pixel>(81, Pixel::outside)};
  made.pixels[40] = Pixel::wanted;
  inpaint_smoothly(made.picture, made.pixels);
  EXPECT_EQ(made.picture.at(4, 4), (Color{0, 0, 0, 255}));
  EXPECT_EQ(made.picture.at(0, 0), (Color{1, 2, 3, 4}));
}

double variance(const Scene& made, Pixel which) {
  double sum = 0, squares = 0, count = 0;
  for (std::size_t k = 0; k < made.pixels.size(); ++k) {
    if (made.pixels[k] != which) continue;
    const double value = made.picture.pixels[k][0];
    sum += value;
    squares += value * value;
    count += 1;
  }
  return squares / count - sum * sum / (count * count);
}

bool is_in_stripe(int x) { return x / 5 % 3 == 0; }

Scene grainy(int size = 160, double radius = 40) {
  Random random(5);
  return scene(size, radius, [&](int x, int) {
    return Color{static_cast<unsigned char>(
                     std::lround(120 + 15 * std::clamp(random.bell(), -3.0, 3.0) + (is_in_stripe(x) ? 40 : 0))),
                 90, 60, 255};
  });
}

/// Noise over stripes: as uneven in the gap as around it, where the smooth continuation has next to nothing of it.
TEST(Inpaint, GrainGoesOn) {
  Scene like = grainy(), smooth = grainy();
  const Scene before = like;
  inpaint_like(like.picture, like.pixels);
  inpaint_smoothly(smooth.picture, smooth.pixels);
  EXPECT_LT(variance(smooth, Pixel::wanted), 0.2 * variance(like, Pixel::known));
  EXPECT_GT(variance(like, Pixel::wanted), 0.75 * variance(like, Pixel::known));
  EXPECT_LT(variance(like, Pixel::wanted), 1.25 * variance(like, Pixel::known));
  for (std::size_t k = 0; k < like.pixels.size(); ++k)
    if (like.pixels[k] == Pixel::known) {
      EXPECT_EQ(like.picture.pixels[k], before.picture.pixels[k]);
    }
}

/// Of 70 000 pixels, so that the search begins at a quarter of the size: each stripe goes on where it was.
TEST(Inpaint, StripesGoOnOverLargeGaps) {
  Scene made = grainy(500, 150);
  inpaint_like(made.picture, made.pixels);
  double sums[2] = {0, 0}, counts[2] = {0, 0};
  for (int y = 0; y < 500; ++y)
    for (int x = 0; x < 500; ++x)
      if (made.pixels[500 * y + x] == Pixel::wanted) {
        sums[is_in_stripe(x)] += made.picture.at(x, y)[0];
        counts[is_in_stripe(x)] += 1;
      }
  EXPECT_GT(sums[1] / counts[1] - sums[0] / counts[0], 30);  // 40 around the gap
}

/// For an estimate of the time that is left.
TEST(Inpaint, TellsHowFarItIs) {
  Scene made = grainy(500, 150);
  std::vector<double> shares;
  inpaint_like(made.picture, made.pixels, {}, [&](double share) { shares.push_back(share); });
  ASSERT_GT(shares.size(), 5u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.front(), 0);
  EXPECT_LT(shares.front(), 0.4);
  EXPECT_GT(shares.back(), 0.8);
  EXPECT_LE(shares.back(), 1);
}

TEST(Inpaint, IsTheSameForAnyNumberOfThreads) {
  for (const auto& [size, radius] : {std::pair(160, 40.0), std::pair(320, 100.0)}) {
    Scene one = grainy(size, radius), all = one;
    with_thread_budget(1, [&] { inpaint_like(one.picture, one.pixels); });
    inpaint_like(all.picture, all.pixels);
    EXPECT_EQ(one.picture.pixels, all.picture.pixels);
  }
}

}  // namespace
}  // namespace loopmend

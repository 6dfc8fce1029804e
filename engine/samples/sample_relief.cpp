// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of the sample: a dome with soft bumps, a sleeping face. Only +, −, ×, ÷ are used, so that the heights do not
// depend on anybody's mathematical library.
#include "samples/sample_scan.h"

#include <array>

namespace loopmend {
namespace {

/// A soft bump: `height` at (x, y), and about a third of it one radius away. Turned by the direction (cosine, sine).
struct Bump {
  double x, y;
  double radius_x, radius_y;
  double height;
  double cosine = 1, sine = 0;
};

/// Features on the axis of the face.
constexpr std::array middle_bumps = {
    Bump{0, 46, 34, 20, 3.0},      // forehead
    Bump{0, 8, 6.5, 20, 8.5},      // bridge of the nose
    Bump{0, -9, 8, 9, 9.5},        // tip of the nose
    Bump{0, -24, 3, 6, -1.4},      // groove above the mouth
    Bump{0, -29.5, 13, 3.6, 4.2},  // upper lip
    Bump{0, -33, 17, 2.8, -3.6},   // between the lips
    Bump{0, -37, 11, 4.2, 4.6},    // lower lip
    Bump{0, -44, 12, 4.5, -2.6},   // below the lip
    Bump{0, -55, 13, 9.5, 7.5},    // chin
};

/// Features of one side; the other side is the mirror image.
constexpr std::array side_bumps = {
    Bump{21, 11, 15, 10, -8.0},                // socket of the eye
    Bump{22, 9, 10.5, 6.5, 6.0},               // closed lid
    Bump{22, 5.5, 12, 2.8, -1.5, 0.995, 0.1},  // line of the lashes
    Bump{22, 24, 17, 5.0, 3.4, 0.985, -0.17},  // brow
    Bump{32, -12, 15, 13, 5.0},                // cheek
    Bump{8.5, -13, 4.6, 4.6, 3.6},             // wing of the nose
    Bump{16, -34, 5, 5, -1.2},                 // corner of the mouth
    Bump{47, 20, 12, 22, -3.0},                // temple
};

/// (1 + q/8)⁻⁸: like exp(−q), but rational.
double bell(double q) {
  const double base = 1 / (1 + q / 8);
  const double squared = base * base;
  const double fourth = squared * squared;
  return fourth * fourth;
}

double bump_height(const Bump& bump, double x, double y) {
  const double dx = x - bump.x;
  const double dy = y - bump.y;
  const double u = (bump.cosine * dx + bump.sine * dy) / bump.radius_x;
  const double v = (bump.cosine * dy - bump.sine * dx) / bump.radius_y;
  return bump.height * bell(u * u + v * v);
}

/// The head under the features. The slope at the boundary stays below 45°.
double dome_height(double x, double y) {
  const double q = x * x / (60.0 * 60.0) + y * y / (76.0 * 76.0);
  return 36 * (1 - q) * (1 - 0.35 * q);
}

}  // namespace

double sample_relief_height(double x, double y) {
  double z = dome_height(x, y);
  for (const Bump& bump : middle_bumps) z += bump_height(bump, x, y);
  for (const Bump& bump : side_bumps) z += bump_height(bump, x, y) + bump_height(bump, -x, y);
  return z;
}

}  // namespace loopmend

// SPDX-License-Identifier: GPL-3.0-or-later
// Which points lie inside a closed surface.
#pragma once

#include "core/types.h"

#include <memory>

namespace loopmend {

class InsideShell {
 public:
  /// @param corners  of the triangles of a closed surface, three after another
  explicit InsideShell(Points corners);
  ~InsideShell();
  InsideShell(InsideShell&&) noexcept;
  InsideShell& operator=(InsideShell&&) noexcept;

  enum class Place { inside, on_surface, outside };
  Place of(const Vec3& p) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace loopmend

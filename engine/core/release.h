// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that is not needed any more.
#pragma once

namespace loopmend {

/// Empties a container and gives its memory back. `container = {}` keeps that of a std::vector and of an Eigen
/// sparse matrix.
template <class Container>
void release(Container& container) {
  Container().swap(container);
}

}  // namespace loopmend

// When loops over vertices are worth several threads.
#pragma once

namespace loopmend {

/// Vertices from which on OpenMP is used. Below, two threads save a twentieth of a fill on an idle machine, and lose several
/// times that where other programs, or our own window, keep one of them waiting.
inline constexpr int least_for_threads = 10000;

}  // namespace loopmend

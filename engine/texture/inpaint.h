// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels that are not known, from those that are.
#pragma once

#include "core/cancel.h"
#include "core/picture.h"

#include <functional>
#include <vector>

namespace loopmend {

enum class Pixel : unsigned char {
  known,    ///< its colour is given
  wanted,   ///< its colour shall be found
  outside,  ///< neither: no neighbour of any other
};

/// Harmonic continuation: each wanted pixel is the mean of its neighbours. Where no known pixel is within reach, black.
void inpaint_smoothly(Picture& picture, const std::vector<Pixel>& pixels);

/// Texture like the known one: its shading is continued smoothly, and what remains is copied from the known pixels square by
/// square, each time the one that fits best to what is there already (after Efros and Freeman 2001, and Criminisi, Pérez,
/// Toyama 2004); in large gaps first at a fraction of the size, so that the time is nearly linear in the pixels. Where too little
/// is known, the smooth continuation. The same result for any number of threads. Cancelled, the picture is half done.
/// @param progress  gets the share of the wanted pixels that have a colour, 0..1, from time to time; may be empty
void inpaint_like(Picture& picture, const std::vector<Pixel>& pixels, const CancelToken& cancel = {},
                  const std::function<void(double)>& progress = {});

}  // namespace loopmend

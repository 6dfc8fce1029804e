// SPDX-License-Identifier: GPL-3.0-or-later
// Films of a flow: the camera stands still, the patch passes through the states that the flow has accepted.
#pragma once

#include "mesh/surface_model.h"
#include "scene/gif_writer.h"
#include "scene/offscreen_render.h"
#include "scene/surface_shape.h"

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace loopmend {

/// A longer flow leaves states out, evenly; the first and the last are in it.
inline constexpr std::size_t most_film_states = 120;

/// Which of `count` states are shown, ascending.
std::vector<std::size_t> states_of_film(std::size_t count);

/// Hundredths of a second for each of `shown` states. Without a wanted pace 10 pictures a second at most, some six seconds where
/// there are few. A look at the start, a longer one at the end.
std::vector<int> film_durations(std::size_t shown, const FilmPace& pace = {});

/// The colors that suit these pictures of a film best (median cut). @throws InvalidArgument without a picture.
std::vector<GifColor> film_palette(const std::vector<RgbPicture>& samples);

struct FilmPicture {
  RgbPicture picture;
  int hundredths = 10;
};

/// Asks for one picture after another until there is none. Ends early where the stream has failed; whoever owns it
/// looks at its state.
/// @returns how many there were. @throws what `next` throws.
int write_film(std::ostream& out, int width, int height, const std::vector<GifColor>& palette,
               const std::function<std::optional<FilmPicture>()>& next);

struct FilmState {
  SurfaceShapePtr patch;
  std::string caption;  ///< one line
};

/// A scan with one patch, drawn without a display as render_surface() draws, coloured by H: states_of_film() of these states.
/// @returns how many were shown. @throws as render_surface; InvalidArgument without a state.
std::size_t render_film(std::ostream& out, const SurfaceModel& model, const std::vector<FilmState>& states,
                        const RenderOptions& options);

}  // namespace loopmend

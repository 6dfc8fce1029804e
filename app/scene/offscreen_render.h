// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of surfaces without a window and without a display.
#pragma once

#include "mesh/surface_model.h"
#include "scene/shading.h"
#include "scene/view_direction.h"

#include <optional>
#include <string>
#include <vector>

namespace loopmend {

/// How long the states of a film are seen.
struct FilmPace {
  double rate = 0;     ///< states a second, 0.5..50; 0: by their number, some six seconds in all
  double seconds = 0;  ///< 0..600: the film lasts at least so long, each state is seen for longer; 0: as it comes
};

struct RenderOptions {
  Shading shading = Shading::curvature;
  int width = 1600;   ///< pixels, 64..8192; of the whole picture
  int height = 1200;  ///< likewise
  std::optional<double>
      h_range;  ///< colours over [−h_range, h_range], 1/length; empty: 98th percentile of the (first) surface
  std::optional<Vec3> eye;        ///< from the middle towards the eye, any length; empty: as `view` says
  std::optional<NamedView> view;  ///< empty: towards most of the holes, straight into `loop` where one is named
  std::optional<int> loop;      ///< number of the boundary loop that fills the picture; empty: all of the surface does
  Seams seams = Seams::hidden;  ///< of two surfaces: lines around what the second has filled
  FilmPace pace;                ///< of a film
};

/// One picture: surface, loops as lines, legend when coloured by H.
/// @returns the bytes of a PNG file.
/// @throws InvalidArgument if an option is out of range; Error if this machine cannot draw.
std::string render_surface(const SurfaceModel& model, const RenderOptions& options);

/// Two surfaces side by side: one camera (that of `before`), one colour range, one legend.
/// @returns, @throws as render_surface.
std::string render_before_after(const SurfaceModel& before, const SurfaceModel& after, const RenderOptions& options);

/// One surface of several that are shown together.
struct Panel {
  const SurfaceModel* model = nullptr;
  std::string caption;
  std::optional<Shading> shading = std::nullopt;  ///< empty: that of the options
  Edges edges = Edges::hidden;
};

/// Surfaces in a grid: one camera (that of the first), one colour range (over all of them), one legend.
/// @param columns  ≥ 1.
/// @returns, @throws as render_surface; InvalidArgument without a panel.
std::string render_panels(const std::vector<Panel>& panels, int columns, const RenderOptions& options);

}  // namespace loopmend

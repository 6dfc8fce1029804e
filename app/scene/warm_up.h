// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the graphics' programs ready one by one, each in pictures of its own, so that nobody waits for all of them: on
// the very first start software graphics take 60 to 180 ms for each. Mesa keeps them for later starts.
#pragma once

#include "scene/legend.h"
#include "scene/loop_lines.h"
#include "scene/shading.h"
#include "scene/still_renderer.h"

#include <memory>
#include <optional>
#include <vector>

class vtkActor;
class vtkLookupTable;

namespace loopmend {

class SurfaceActor;

class WarmUp {
 public:
  /// All of them outlive it.
  WarmUp(StillRenderer* renderer, vtkLookupTable* table, Legend& legend);
  ~WarmUp();

  /// Lets the next picture make one of the programs ready that surfaces of this look, their loops and their legend need.
  /// Until they are so for the first look, pictures show no surfaces and no lines. The legend is to be laid out and shown
  /// or hidden before each call. @returns false when all are.
  bool next_for(Shading shading, Edges edges);
  /// The same for any look.
  bool next();

 private:
  enum class Program { smooth, striped, smooth_edged, striped_edged, casings, cores, letters, areas, colored_areas };
  /// A program is put together from its source; and translated for the machine as soon as something is drawn with it, for
  /// a texture that has just been made otherwise than for one that was filled anew.
  enum class Stage { source, fresh, renewed };
  struct Turn {
    Program program;
    Stage stage = Stage::fresh;
    bool operator==(const Turn&) const = default;
  };
  static Program program_of(Shading shading, Edges edges);
  static std::vector<Turn> turns_for(Program surface);
  /// The first turn that a picture with such surfaces still lacks.
  std::optional<Turn> missing(Program surface) const;
  void take(const std::optional<Turn>& turn);
  void begin(const Turn& turn);
  static StillRenderer::Rehearsal rehearsal(Stage stage);
  void begin_surface(Shading shading, Edges edges, Stage stage);
  void begin_lines(const std::vector<vtkActor*>& lines, Stage stage);
  void begin_legend(Legend::Kind kind);
  void end();

  StillRenderer* renderer_;
  vtkLookupTable* table_;
  Legend& legend_;
  std::vector<Turn> done_;  ///< in this order
  bool something_is_ready_ = false;
  std::unique_ptr<SurfaceActor> surface_;
  LoopLines lines_;
};

}  // namespace loopmend

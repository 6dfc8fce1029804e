// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary loops as clear lines over the surface: a coloured core in a pale casing, so that they read on any colour.
#pragma once

#include "scene/shading.h"

#include <vtkNew.h>

#include <vector>

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

namespace loopmend {

enum class LoopStyle {
  open,
  selected,
  left_out,
  filled,
  failed,
  judged,  ///< no line: nothing lies over a seam that a person looks at
};

struct LoopLine {
  std::vector<float> points;  ///< 3 × #V, in the scene's frame; closed by itself
  LoopStyle style = LoopStyle::open;
};

class LoopLines {
 public:
  LoopLines();
  ~LoopLines();
  void add_to(vtkRenderer* renderer);
  std::vector<vtkActor*> actors() const;
  std::vector<vtkActor*> cores() const;
  void set_lines(const std::vector<LoopLine>& lines);
  void set_visible(Seams seams);
  /// Device pixels per logical pixel: widths follow.
  void set_pixel_ratio(double ratio);

 private:
  void set_widths();

  double ratio_ = 1;
  vtkNew<vtkPolyData> thin_, bold_;
  vtkNew<vtkPolyDataMapper> thin_core_mapper_, thin_casing_mapper_, bold_core_mapper_, bold_casing_mapper_;
  vtkNew<vtkActor> thin_core_, thin_casing_, bold_core_, bold_casing_;
};

}  // namespace loopmend

// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/loop_lines.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <array>

namespace loopmend {
namespace {

using Bytes = std::array<unsigned char, 3>;

Bytes core_color(LoopStyle style) {
  switch (style) {
    case LoopStyle::open: return {196, 0, 98};
    case LoopStyle::selected: return {196, 0, 98};
    case LoopStyle::left_out: return {112, 116, 124};
    case LoopStyle::filled: return {30, 38, 48};
    case LoopStyle::failed: return {120, 20, 20};
    case LoopStyle::judged: break;
  }
  return {0, 0, 0};
}

void fill_lines(vtkPolyData* data, const std::vector<LoopLine>& lines, bool selected) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (const LoopLine& line : lines) {
    if ((line.style == LoopStyle::selected) != selected || line.points.empty() || line.style == LoopStyle::judged)
      continue;
    const vtkIdType first = points->GetNumberOfPoints();
    const auto count = static_cast<vtkIdType>(line.points.size() / 3);
    for (vtkIdType i = 0; i < count; ++i) points->InsertNextPoint(line.points.data() + 3 * i);
    cells->InsertNextCell(static_cast<int>(count + 1));
    for (vtkIdType i = 0; i <= count; ++i) cells->InsertCellPoint(first + i % count);
    const Bytes c = core_color(line.style);
    colors->InsertNextTypedTuple(c.data());
  }
  data->SetPoints(points);
  data->SetLines(cells);
  data->GetCellData()->SetScalars(colors);
  data->Modified();
}

void set_up(vtkActor* actor, vtkPolyDataMapper* mapper, vtkPolyData* data, double offset) {
  mapper->SetInputData(data);
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, offset);
  mapper->SetScalarVisibility(0);
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
}

}  // namespace

LoopLines::LoopLines() {
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  set_up(thin_casing_, thin_casing_mapper_, thin_, -12);
  set_up(thin_core_, thin_core_mapper_, thin_, -20);
  set_up(bold_casing_, bold_casing_mapper_, bold_, -28);
  set_up(bold_core_, bold_core_mapper_, bold_, -36);
  for (vtkPolyDataMapper* core : {thin_core_mapper_.Get(), bold_core_mapper_.Get()}) core->ScalarVisibilityOn();
  thin_casing_->GetProperty()->SetColor(1, 1, 1);
  bold_casing_->GetProperty()->SetColor(1.0, 0.84, 0.12);
  set_widths();
}

LoopLines::~LoopLines() = default;

std::vector<vtkActor*> LoopLines::actors() const { return {thin_casing_, thin_core_, bold_casing_, bold_core_}; }
std::vector<vtkActor*> LoopLines::cores() const { return {thin_core_, bold_core_}; }

void LoopLines::add_to(vtkRenderer* renderer) {
  for (vtkActor* actor : actors()) renderer->AddActor(actor);
}

void LoopLines::set_lines(const std::vector<LoopLine>& lines) {
  fill_lines(thin_, lines, false);
  fill_lines(bold_, lines, true);
}

void LoopLines::set_visible(Seams seams) {
  for (vtkActor* actor : actors()) actor->SetVisibility(seams == Seams::shown);
}

void LoopLines::set_pixel_ratio(double ratio) {
  ratio_ = ratio;
  set_widths();
}

void LoopLines::set_widths() {
  const auto width = [this](vtkActor* actor, double logical) {
    actor->GetProperty()->SetLineWidth(static_cast<float>(logical * ratio_));
  };
  width(thin_casing_, 4.5);
  width(thin_core_, 2.25);
  width(bold_casing_, 8);
  width(bold_core_, 3);
}

}  // namespace loopmend

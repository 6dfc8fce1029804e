// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/legend.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkLookupTable.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace loopmend {
namespace {

constexpr int bar_steps = 96;

std::string number(double value, double range, char decimal_mark) {
  if (value == 0) return "0";
  char text[32];
  const double decade = std::floor(std::log10(range));
  if (decade < -3 || decade > 4) {
    std::snprintf(text, sizeof text, "%+.1e", value);
  } else {
    std::snprintf(text, sizeof text, "%+.*f", std::max(0, 1 - static_cast<int>(decade)), value);
  }
  std::string out = text;
  std::replace(out.begin(), out.end(), '.', decimal_mark);
  if (out[0] == '-') out.replace(0, 1, "\xE2\x88\x92");
  return out;
}

void quad(vtkPoints* points, vtkCellArray* cells, double x0, double y0, double x1, double y1) {
  const vtkIdType first = points->InsertNextPoint(x0, y0, 0);
  points->InsertNextPoint(x1, y0, 0);
  points->InsertNextPoint(x1, y1, 0);
  points->InsertNextPoint(x0, y1, 0);
  const vtkIdType ids[4] = {first, first + 1, first + 2, first + 3};
  cells->InsertNextCell(4, ids);
}

void use(vtkActor2D* actor, vtkPoints* points, vtkCellArray* cells, vtkUnsignedCharArray* colors) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  if (colors) data->GetCellData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  actor->SetMapper(mapper);
}

void style(vtkTextActor* text) {
  vtkTextProperty* look = text->GetTextProperty();
  look->SetFontFamilyToArial();
  look->ItalicOff();
  look->ShadowOn();  // readable over a surface, too
  look->SetShadowOffset(1, -1);
  look->BoldOff();
  look->SetJustificationToLeft();
  look->SetVerticalJustificationToCentered();
}

}  // namespace

Legend::Legend(vtkLookupTable* table) : table_(table) {
  for (vtkTextActor* text : {title_.Get(), unit_.Get(), top_.Get(), bottom_.Get()}) style(text);
  for (auto& label : labels_) style(label);
  set_words({});
  title_->GetTextProperty()->BoldOn();
  for (vtkTextActor* text : {title_.Get(), unit_.Get(), top_.Get(), bottom_.Get()})
    text->GetTextProperty()->SetJustificationToRight();
  set_ink(0.15);
}

Legend::~Legend() = default;

void Legend::each_part(const auto& act) {
  for (vtkActor2D* part : {plate_.Get(), bar_.Get(), ticks_.Get()}) act(part);  // the plate under the others
  for (vtkTextActor* text : {title_.Get(), unit_.Get(), top_.Get(), bottom_.Get()}) act(text);
  for (auto& label : labels_) act(label.Get());
}

void Legend::add_to(vtkRenderer* renderer) {
  if (renderer == renderer_) return;
  each_part([&](vtkActor2D* part) {
    if (renderer_) renderer_->RemoveActor2D(part);
    renderer->AddActor2D(part);
  });
  renderer_ = renderer;
}

void Legend::show() {
  shown_ = true;
  each_part([this](vtkActor2D* part) { part->SetVisibility(kinds_ == all_kinds); });
  plate_->SetVisibility(ground_ == Ground::plate && kinds_ > 0);
  ticks_->SetVisibility(kinds_ > 0);
  bar_->SetVisibility(kinds_ > 1);
}

void Legend::hide() {
  shown_ = false;
  each_part([](vtkActor2D* part) { part->VisibilityOff(); });
}

bool Legend::grow() {
  if (!shown_ || kinds_ == all_kinds) return false;
  ++kinds_;
  show();
  return kinds_ < all_kinds;
}

void Legend::grow_up() {
  kinds_ = all_kinds;
  if (shown_) show();
}

void Legend::set_words(const LegendWords& words) {
  title_->SetInput(words.title.c_str());
  unit_->SetInput(words.unit.c_str());
  top_->SetInput(words.top.c_str());
  bottom_->SetInput(words.bottom.c_str());
  decimal_mark_ = words.decimal_mark;
}

void Legend::set_pixel_ratio(double ratio) { ratio_ = ratio; }

void Legend::set_ground(Ground ground) {
  ground_ = ground;
  if (shown_) show();
}

void Legend::set_ink(double brightness) {
  const auto ink = [](vtkTextActor* text, double g) { text->GetTextProperty()->SetColor(g, g, g); };
  const double soft = brightness < 0.5 ? brightness + 0.12 : brightness - 0.12;
  ink(title_, brightness);
  for (vtkTextActor* text : {unit_.Get(), top_.Get(), bottom_.Get()}) ink(text, soft);
  for (auto& label : labels_) ink(label, brightness);
  ticks_->GetProperty()->SetColor(brightness, brightness, brightness);
  constexpr double opacity = 0.78;
  const double plate = brightness < 0.5 ? 0.95 : 0.16;
  plate_->GetProperty()->SetColor(plate, plate, plate);
  plate_->GetProperty()->SetOpacity(opacity);
}

void Legend::lay_out(int width, int height) {
  const double margin = 16 * ratio_, bar_width = 14 * ratio_;
  const double bar_height = std::clamp(0.42 * height, 80 * ratio_, 260 * ratio_);
  const double right = width - margin, top = height - margin;
  place(title_, right, top - 7 * ratio_, 13);
  place(unit_, right, top - 25 * ratio_, 11);
  place(top_, right, top - 46 * ratio_, 11);
  const double bar_top = top - 64 * ratio_, bottom = bar_top - bar_height;
  build_bar(right - bar_width, bottom, bar_width, bar_height);
  bar_box_ = {Eigen::Vector2d(right - bar_width, bottom), Eigen::Vector2d(right, bar_top)};
  place(bottom_, right, bottom - 18 * ratio_, 11);
  const double low = table_->GetRange()[0], range = table_->GetRange()[1];
  for (int i = 0; i < label_count; ++i) {
    const double t = static_cast<double>(i) / (label_count - 1);
    vtkTextActor* label = labels_[i];
    std::string text = number(low + t * (range - low), range, decimal_mark_);
    if (low == 0 && text[0] == '+') text.erase(0, 1);
    label->SetInput(text.c_str());
    label->GetTextProperty()->SetJustificationToRight();
    place(label, right - bar_width - 9 * ratio_, bottom + t * bar_height, 12);
  }
  build_plate();
}

void Legend::build_plate() {
  if (!renderer_ || !renderer_->GetRenderWindow()) return;  // the texts are not measured yet
  const double margin = 8 * ratio_;
  plate_box_ = Eigen::AlignedBox2d();
  for (const Eigen::AlignedBox2d& box : written_boxes()) plate_box_.extend(box);
  plate_box_.min().array() -= margin;
  plate_box_.max().array() += margin;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  quad(points, cells, plate_box_.min().x(), plate_box_.min().y(), plate_box_.max().x(), plate_box_.max().y());
  use(plate_, points, cells, nullptr);
}

std::vector<Eigen::AlignedBox2d> Legend::boxes() {
  return ground_ == Ground::plate ? std::vector{plate_box_} : written_boxes();
}

std::vector<Eigen::AlignedBox2d> Legend::written_boxes() {
  std::vector<Eigen::AlignedBox2d> all{bar_box_};
  const auto add = [&](vtkTextActor* text) {
    double b[4];
    text->GetBoundingBox(renderer_, b);
    const Eigen::Vector2d at(text->GetPosition()[0], text->GetPosition()[1]);
    all.emplace_back(at + Eigen::Vector2d(b[0], b[2]), at + Eigen::Vector2d(b[1], b[3]));
  };
  for (vtkTextActor* text : {title_.Get(), unit_.Get(), top_.Get(), bottom_.Get()}) add(text);
  for (auto& label : labels_) add(label);
  return all;
}

void Legend::place(vtkTextActor* text, double x, double y, int logical_size) {
  // Qt's window scales its DPI, and VTK its text with it; the ratio has been taken into account already.
  constexpr double plain_dpi = 72;
  const double dpi = renderer_ && renderer_->GetRenderWindow() ? renderer_->GetRenderWindow()->GetDPI() : plain_dpi;
  text->GetTextProperty()->SetFontSize(static_cast<int>(std::lround(logical_size * ratio_ * plain_dpi / dpi)));
  text->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  text->SetPosition(std::lround(x), std::lround(y));
}

void Legend::build_bar(double left, double bottom, double width, double height) {
  vtkNew<vtkPoints> points, tick_points;
  vtkNew<vtkCellArray> cells, tick_cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < bar_steps; ++i) {
    quad(points, cells, left, bottom + height * i / bar_steps, left + width, bottom + height * (i + 1) / bar_steps);
    double rgba[4];
    table_->GetTableValue(i * 255 / (bar_steps - 1), rgba);
    for (int k = 0; k < 3; ++k) colors->InsertNextValue(static_cast<unsigned char>(255 * rgba[k]));
  }
  for (int i = 0; i < label_count; ++i) {
    const double y = bottom + height * i / (label_count - 1), half = 0.5 * ratio_;
    quad(tick_points, tick_cells, left - 5 * ratio_, y - half, left, y + half);
  }
  use(bar_, points, cells, colors);
  use(ticks_, tick_points, tick_cells, nullptr);
}

}  // namespace loopmend

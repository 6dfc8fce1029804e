// The legend of the H colours: title, bar, five numbers, what the two ends mean.
#pragma once

#include <vtkNew.h>

#include <array>

class vtkActor2D;
class vtkLookupTable;
class vtkRenderer;
class vtkTextActor;

namespace loopmend {

class Legend {
 public:
  explicit Legend(vtkLookupTable* table);
  ~Legend();
  void add_to(vtkRenderer* renderer);
  void show();
  void hide();
  void set_pixel_ratio(double ratio);
  /// Text in dark or light, over a pale or dark ground, to suit the background.
  void set_ink(double grey);
  /// Places it at the right edge and reads the range from the table. Call when size or range changed.
  void lay_out(int width, int height);

  static constexpr int width_px = 96;  ///< logical pixels that it takes at the right edge

 private:
  void build_ground(double left, double bottom, double right, double top);
  void build_bar(double left, double bottom, double width, double height);
  void place(vtkTextActor* text, double x, double y, int logical_size);

  static constexpr int label_count = 5;
  double ratio_ = 1;
  vtkLookupTable* table_;
  vtkRenderer* renderer_ = nullptr;
  vtkNew<vtkActor2D> ground_, bar_, ticks_;
  vtkNew<vtkTextActor> title_, unit_, hollow_, bulging_;
  std::array<vtkNew<vtkTextActor>, label_count> labels_;
};

}  // namespace loopmend

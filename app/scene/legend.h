// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of the colours: title, bar, five numbers, what the two ends mean.
#pragma once

#include <vtkNew.h>

#include <Eigen/Geometry>

#include <array>
#include <string>
#include <vector>

class vtkActor2D;
class vtkLookupTable;
class vtkRenderer;
class vtkTextActor;

namespace loopmend {

/// UTF-8.
struct LegendWords {
  std::string title = "Mean curvature H";
  std::string unit = "in 1/length";
  std::string top = "hollow";      ///< what the upper end of the bar means
  std::string bottom = "bulging";  ///< the lower one
  char decimal_mark = '.';
};

enum class LegendPlace { none, over_the_picture, beside };

class Legend {
 public:
  explicit Legend(vtkLookupTable* table);
  ~Legend();
  /// Moves it there.
  void add_to(vtkRenderer* renderer);
  void show();
  void hide();
  bool is_shown() const { return shown_; }
  /// Areas, the bar and letters come one after another, when it is shown for the first time: software graphics take 50 ms to make a
  /// program for each.
  void come_by_kinds() { kinds_ = 0; }
  /// One kind more. @returns whether another one is missing.
  bool grow();
  void grow_up();
  void set_words(const LegendWords& words);
  void set_pixel_ratio(double ratio);
  /// Text in dark or light, to suit the background.
  void set_ink(double brightness);
  /// What keeps it readable over a surface.
  enum class Ground { bare, plate };
  void set_ground(Ground ground);
  /// Places it at the right edge and reads the range from the table. Call when size or range changed.
  void lay_out(int width, int height);

  /// What it covers, pixels from the lower left corner of its renderer: the plate, or a box for each of its texts and for the bar.
  std::vector<Eigen::AlignedBox2d> boxes();

  static constexpr int width_px = 150;  ///< logical pixels that it takes at the right edge

 private:
  std::vector<Eigen::AlignedBox2d> written_boxes();
  void build_plate();
  void build_bar(double left, double bottom, double width, double height);
  void each_part(const auto& act);
  void place(vtkTextActor* text, double x, double y, int logical_size);

  static constexpr int label_count = 5, all_kinds = 3;
  int kinds_ = all_kinds;
  bool shown_ = false;
  double ratio_ = 1;
  Ground ground_ = Ground::plate;
  Eigen::AlignedBox2d bar_box_, plate_box_;
  char decimal_mark_ = '.';
  vtkLookupTable* table_;
  vtkRenderer* renderer_ = nullptr;
  vtkNew<vtkActor2D> plate_, bar_, ticks_;
  vtkNew<vtkTextActor> title_, unit_, top_, bottom_;
  std::array<vtkNew<vtkTextActor>, label_count> labels_;
};

}  // namespace loopmend

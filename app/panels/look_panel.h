// SPDX-License-Identifier: GPL-3.0-or-later
// The dock beside the patch dock: shading, colours and their range, overlays.
#pragma once

#include "panels/clipping_box.h"
#include "scene/look.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace loopmend {

/// In the language of the window.
QString color_map_name(ColorMap map);

class LookPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LookPanel(QWidget* parent = nullptr);

  const Look& look() const { return look_; }
  void set_look(const Look& look);
  void set_shading(Shading shading) { set(&Look::shading, shading); }
  void set_edges(Edges edges) { set(&Look::edges, edges); }
  void set_seams(Seams seams) { set(&Look::seams, seams); }
  void set_tint(Tint tint) { set(&Look::tint, tint); }
  void set_color_map(ColorMap map) { set(&Look::map, map); }
  void set_up(UpAxis up) { set(&Look::up, up); }
  /// The half-width in force, to begin with when a range of one's own is wanted.
  void know_range(double half_width);
  ClippingBox& clipping() { return *clipping_; }

 Q_SIGNALS:
  void look_changed(const Look& look);

 private:
  void build();
  QWidget* build_colors();
  void show_look();
  void change();
  template <class T>
  void set(T Look::*part, T value) {
    Look look = look_;
    look.*part = value;
    set_look(look);
  }

  Look look_;
  double range_in_force_ = 1;
  bool syncing_ = false;
  QComboBox *shading_ = nullptr, *map_ = nullptr, *rule_ = nullptr;
  QDoubleSpinBox *percent_ = nullptr, *half_width_ = nullptr;
  QCheckBox *edges_ = nullptr, *seams_ = nullptr, *tint_ = nullptr;
  QSlider* stripes_ = nullptr;
  QWidget *colors_ = nullptr, *striped_ = nullptr;
  QLabel* help_ = nullptr;
  ClippingBox* clipping_ = nullptr;
};

}  // namespace loopmend

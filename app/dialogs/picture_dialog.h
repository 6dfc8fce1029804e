// SPDX-License-Identifier: GPL-3.0-or-later
// A picture to save or copy: how large, on which ground, with what in it.
#pragma once

#include "views/mesh_view.h"

#include <QDialog>

#include <functional>

class QComboBox;
class QLabel;
class QSpinBox;

namespace loopmend {

/// What can be drawn at any size.
struct PictureSource {
  QSize seen;                                         ///< device pixels on the screen
  std::function<QImage(const PictureOptions&)> draw;  ///< null image when the graphics cannot
  enum class Offer { everything, no_axes } offer = Offer::everything;
};

class PictureDialog : public QDialog {
  Q_OBJECT

 public:
  explicit PictureDialog(MeshView& view, QWidget* parent = nullptr);
  explicit PictureDialog(PictureSource source, QWidget* parent = nullptr);

  /// @returns whether it was written; if not, the dialog says why.
  bool save(const QString& path);

 Q_SIGNALS:
  void saved(const QString& path);

 private:
  void build();
  void propose_size();
  PictureOptions options() const;
  void ask_and_save();
  void copy();

  PictureSource source_;
  QComboBox *size_ = nullptr, *ground_ = nullptr, *extras_ = nullptr;
  QSpinBox *width_ = nullptr, *height_ = nullptr;
  QLabel* fault_ = nullptr;
};

}  // namespace loopmend

// SPDX-License-Identifier: GPL-3.0-or-later
// One candidate as a button: its picture, its name, the verdict on it and the figures.
#pragma once

#include "document/document.h"

#include <QAbstractButton>
#include <QImage>

namespace loopmend {

struct CardText {
  QString name, help;
  HoleState state = HoleState::converged;  ///< whose sign it has
  QString verdict, figures;
  bool operator==(const CardText&) const = default;
};

class CandidateCard : public QAbstractButton {
  Q_OBJECT

 public:
  explicit CandidateCard(const QString& name, QWidget* parent = nullptr);

  void set_text(const CardText& text);
  void set_picture(const QImage& picture);
  const QImage& picture() const { return picture_; }
  /// Of the picture, device pixels.
  QSize picture_size() const;
  enum class Place { offered, in_place };
  void set_place(Place place);
  QSize sizeHint() const override;

 Q_SIGNALS:
  void looked_at();  ///< the mouse is over it, or it has the focus
  void left();
  void resized();  ///< its picture has another size

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QRect picture_rect() const;

  CardText text_;
  QImage picture_;
  Place place_ = Place::offered;
};

}  // namespace loopmend

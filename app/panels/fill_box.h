// SPDX-License-Identifier: GPL-3.0-or-later
// First part of the patch dock: close holes by a first patch, of a chosen density.
#pragma once

#include <QGroupBox>
#include <QTimer>

#include <set>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace loopmend {

class Document;
class HoleSelection;
class FillController;
enum class Mending;
struct FillChoice;

class FillBox : public QGroupBox {
  Q_OBJECT

 public:
  FillBox(const Document& document, const HoleSelection& selection, FillController& controller,
          QWidget* parent = nullptr);

  void fill();
  void mend(Mending what);
  void fill_holes(const std::set<int>& loops);
  void update_state();

 private:
  void build();
  FillChoice choice() const;
  QString target_words(const std::set<int>& loops) const;
  QString estimate(const std::set<int>& loops) const;
  void preview_soon();
  void preview_now();

  const Document& document_;
  const HoleSelection& selection_;
  FillController& controller_;
  QLabel *target_ = nullptr, *estimate_ = nullptr;
  QDoubleSpinBox* density_ = nullptr;
  QCheckBox *preview_ = nullptr, *islands_ = nullptr;
  QPushButton *fill_ = nullptr, *trim_ = nullptr, *stitch_ = nullptr, *repair_ = nullptr;
  QTimer preview_timer_;
};

}  // namespace loopmend

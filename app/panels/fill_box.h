// SPDX-License-Identifier: GPL-3.0-or-later
// First part of the patch dock: the button that does the whole job, and how holes are closed.
#pragma once

#include <QGroupBox>
#include <QTimer>

#include <set>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace loopmend {

class QuietLabel;
class Document;
class HoleSelection;
class FillController;
enum class ScanRepair;
struct FillChoice;

class FillBox : public QGroupBox {
  Q_OBJECT

 public:
  FillBox(const Document& document, const HoleSelection& selection, FillController& controller,
          QWidget* parent = nullptr);

  /// The whole job: fills what is open and takes it to the steady state; smooths where nothing is open.
  void fill_and_smooth();
  void fill();
  void repair_scans(ScanRepair what);
  void fill_and_smooth(const std::set<int>& loops);
  void update_state();
  FillChoice choice() const;
  /// What else is chosen before a fill, among those of this box.
  void add_options(QWidget* options);

 Q_SIGNALS:
  void repair_wanted();
  /// The flow is chosen in another box.
  void wanted(const std::set<int>& loops, const std::set<int>& patch_ids, const FillChoice& choice);

 private:
  void build();
  std::set<int> patches_to_smooth() const;
  QString target_words(const std::set<int>& loops) const;
  bool has_crease(int loop) const;
  int count_cutting() const;
  QString advice(const std::set<int>& loops) const;
  QString estimate(const std::set<int>& loops) const;
  void preview_soon();
  void preview_now();

  const Document& document_;
  const HoleSelection& selection_;
  FillController& controller_;
  QuietLabel* target_ = nullptr;
  QuietLabel* estimate_ = nullptr;
  QDoubleSpinBox* density_ = nullptr;
  QCheckBox *preview_ = nullptr, *islands_ = nullptr;
  QPushButton *whole_ = nullptr, *fill_ = nullptr, *prepare_ = nullptr, *trim_ = nullptr, *stitch_ = nullptr,
              *repair_ = nullptr;
  QGridLayout* rest_ = nullptr;
  QTimer preview_timer_{this};
};

}  // namespace loopmend

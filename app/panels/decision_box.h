// SPDX-License-Identifier: GPL-3.0-or-later
// Third part of the patch dock: look back along the run, then keep the patch or throw it away.
#pragma once

#include <QElapsedTimer>
#include <QGroupBox>
#include <QTimer>

class QPushButton;
class QSlider;

namespace loopmend {

class PlayerBar;
class QuietLabel;
class Document;
class HoleSelection;
class FillController;

class DecisionBox : public QGroupBox {
  Q_OBJECT

 public:
  DecisionBox(const Document& document, const HoleSelection& selection, FillController& controller,
              QWidget* parent = nullptr);

  void accept_or_reopen();
  void reject();
  void copy_command();
  /// Of the recorded states.
  PlayerBar& player() { return *player_; }
  /// The timeline and its words, for another box.
  QWidget* states() const { return states_; }
  void update_state();
  void update_timeline();

 Q_SIGNALS:
  void seam_wanted();
  void candidates_wanted();
  void notice(const QString& words);
  /// The patch whose state the timeline shows, or no_patch; again whenever that state is another.
  void state_told(int patch_id);

 private:
  void build();
  void scrub(int place);
  bool all_accepted() const;

  const Document& document_;
  const HoleSelection& selection_;
  FillController& controller_;
  QTimer soon_{this};
  QElapsedTimer clicked_;  ///< since Accept was
  QWidget* states_ = nullptr;
  QuietLabel* place_ = nullptr;
  QSlider* timeline_ = nullptr;
  PlayerBar* player_ = nullptr;
  QPushButton *accept_ = nullptr, *reject_ = nullptr, *others_ = nullptr, *copy_ = nullptr;
  bool syncing_ = false;
};

}  // namespace loopmend

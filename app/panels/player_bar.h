// SPDX-License-Identifier: GPL-3.0-or-later
// Plays the recorded states of a timeline, each shown for a moment: no state is computed for it.
#pragma once

#include <QTimer>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QPushButton;
class QSlider;

namespace loopmend {

/// Moves the slider as a hand does: held down while it plays, released at the end, so that one playback is one change for undo.
class PlayerBar : public QWidget {
  Q_OBJECT

 public:
  explicit PlayerBar(QSlider& timeline, QWidget* parent = nullptr);

  bool is_playing() const { return timer_.isActive(); }
  /// From the state that is shown; at the last one, from the first.
  void play_or_pause();
  void pause();
  /// One state further; after the last one, the first.
  void next();
  /// Speed, single states and more, for a place that is folded at first.
  QWidget* rest() const { return rest_; }
  void add_to_rest(QWidget* widget);
  /// Follows the slider: a disabled one cannot be played.
  void update_state();

 protected:
  /// A hand on the slider ends the playback.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void advance();
  void keep_pace();

  QSlider& timeline_;
  QTimer timer_{this};
  QPushButton *play_ = nullptr, *next_ = nullptr;
  QWidget* rest_ = nullptr;
  QComboBox* pace_ = nullptr;
  QCheckBox* again_ = nullptr;
};

}  // namespace loopmend

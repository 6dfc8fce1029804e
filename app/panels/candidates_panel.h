// SPDX-License-Identifier: GPL-3.0-or-later
// Other patches for the selected hole, side by side: the mouse over one shows it in the view, a click takes it.
#pragma once

#include "jobs/candidate_controller.h"

#include <QWidget>

#include <map>

class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace loopmend {

class CandidateCard;
struct CardText;
class HoleSelection;
class QuietLabel;

class CandidatesPanel : public QWidget {
  Q_OBJECT

 public:
  CandidatesPanel(const Document& document, const HoleSelection& selection, CandidateController& candidates,
                  FillController& controller, QWidget* parent = nullptr);

  /// Of the selected hole. @returns whether it has a patch that may be exchanged.
  bool compute();
  bool can_compute() const;
  CandidateCard* card(CandidateKind kind) const;
  /// The candidate whose card the mouse is over: an index; −1: none.
  int looked_at() const;

 Q_SIGNALS:
  /// looked_at() is another.
  void look_changed();
  /// Cards came or went: their pictures are to be drawn.
  void cards_changed();
  /// Other patches for this hole are on their way.
  void begun(int loop);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void build();
  void update_state();
  void update_cards();
  CardText text_of(const Candidate& candidate) const;
  QString words_on_refused() const;
  int chosen_loop() const;

  const Document& document_;
  const HoleSelection& selection_;
  CandidateController& candidates_;
  FillController& controller_;
  QLabel* title_ = nullptr;
  QuietLabel *note_ = nullptr, *refused_ = nullptr;
  QPushButton* compute_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QGridLayout* grid_ = nullptr;
  std::map<CandidateKind, CandidateCard*> cards_;
  std::optional<CandidateKind> looked_at_;
};

}  // namespace loopmend

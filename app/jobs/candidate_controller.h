// SPDX-License-Identifier: GPL-3.0-or-later
// Other patches for a hole that is filled: computed beside everything else when a person asks, and one of them taken.
#pragma once

#include "document/undo_history.h"
#include "jobs/candidate_jobs.h"
#include "jobs/task_runner.h"

#include <QObject>

#include <chrono>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace loopmend {

class FillController;

class CandidateController : public QObject {
  Q_OBJECT

 public:
  CandidateController(Document& document, UndoHistory& undo, FillController& controller, QObject* parent = nullptr);

  /// Of the patch that closes this hole. What was computed before is dropped.
  void compute(int loop);
  /// Comes back at once; those that are ready stay.
  void cancel();
  bool busy() const { return job_ != nullptr; }
  int done() const { return done_; }
  int total() const { return total_; }

  /// The holes that they close; empty without candidates.
  const std::set<int>& loops() const { return loops_; }
  /// By kind; the patch as it is among them. Two that are equal to the bit are one.
  const std::vector<Candidate>& candidates() const { return candidates_; }
  /// Which of them the document holds: an index; −1: none.
  int in_place() const;
  /// Why there are none of these kinds, in the engine's words; none that the engine merely passed over.
  const std::map<CandidateKind, Message>& refused() const { return refused_; }
  /// The surface around the holes, for small pictures; null until the first candidate is ready.
  const SurfaceShapePtr& neighborhood() const { return neighborhood_; }

  /// The candidate comes in place of what closes the holes: one change that can be undone.
  void take(int index);

  /// For the end of the program. @returns whether every worker has ended.
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void changed();  ///< candidates, progress, or which of them is in place
  void taken(const QString& text);

 private:
  void add(Candidate candidate);
  void forget();
  void follow_document();
  bool holds(const Candidate& candidate) const;

  Document& document_;
  UndoHistory& undo_;
  FillController& controller_;
  TaskRunner tasks_;
  JobPtr job_;
  int done_ = 0, total_ = 0;
  std::set<int> loops_;
  std::vector<Candidate> candidates_;
  std::map<CandidateKind, Message> refused_;
  SurfaceShapePtr neighborhood_;
  std::map<const SurfaceModel*, std::shared_ptr<MirrorPlanes>> mirror_planes_;
};

/// What a kind of candidate is called, and what it is.
namespace labels {
QString candidate(CandidateKind kind);
QString candidate_help(CandidateKind kind);
}  // namespace labels

}  // namespace loopmend

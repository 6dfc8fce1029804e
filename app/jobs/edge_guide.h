// SPDX-License-Identifier: GPL-3.0-or-later
// The sharp edges that would run on across open holes, computed beside other work, and what a person says of them.
#pragma once

#include "document/document.h"
#include "document/hole_selection.h"
#include "jobs/task_runner.h"

#include <QObject>

#include <map>
#include <vector>

namespace loopmend {

class EdgeGuide : public QObject {
  Q_OBJECT

 public:
  EdgeGuide(Document& document, const HoleSelection& selection, QObject* parent = nullptr);

  struct Edge {
    enum class Kind {
      continued,   ///< by itself
      drawn,       ///< by hand
      not_fitting  ///< drawn, but no sharp edge was found there
    } kind = Kind::continued;
    int scan = 0;
    Points line;               ///< scene's frame
    int begin = -1, end = -1;  ///< soup points on the boundary; −1: it ends within the hole
  };

  enum class Watch { nothing, open_holes };
  /// Those selected, else the largest.
  void watch(Watch what);
  const std::vector<Edge>& edges() const { return edges_; }
  bool busy() const { return job_ != nullptr; }

  void draw(int scan, int soup_a, int soup_b);
  /// An edge that was drawn is forgotten; another one does not run on.
  void remove(const Edge& edge);
  /// Forgets what was drawn and removed, in all scans.
  void restore();
  bool has_edits() const;
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void changed();

 private:
  /// What was found for a loop, and for which edits of it.
  struct Known {
    EdgeEdits edits;
    std::vector<Edge> edges;
  };
  struct Asked {
    std::shared_ptr<const OpenedScan> scan;
    int index = 0, loop = 0;
    BoundaryLoop boundary;
    EdgeEdits edits;
  };
  void forget();
  void follow();
  void ask(const std::vector<Asked>& wanted);
  void collect();
  std::vector<int> loops() const;
  EdgeEdits edits_at_loop(int loop) const;
  bool is_known(int loop) const;

  Document& document_;
  const HoleSelection& selection_;
  Watch watch_ = Watch::nothing;
  std::vector<Edge> edges_;
  std::map<int, Known> known_;      ///< by loop
  std::map<int, EdgeEdits> asked_;  ///< of the running job, by loop
  JobPtr job_;
  TaskRunner tasks_;
};

}  // namespace loopmend

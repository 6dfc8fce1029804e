// SPDX-License-Identifier: GPL-3.0-or-later
// A run on the patches of a document: its states come in place of what was there, and all of it is one change.
#pragma once

#include "document/changes.h"
#include "jobs/run_recorder.h"

#include <map>
#include <vector>

namespace loopmend {

class DocumentRun {
 public:
  /// @param timeline_budget  bytes of each timeline
  DocumentRun(Document& document, std::size_t timeline_budget);

  /// Patches get their new states, loops without one get a patch. Where a run parts or joins patches of the document, those stay
  /// until one of the new patches has moved and, together with others that have started, closes their loops.
  void place(const PatchRuns& news);
  /// After the last news: what has not been placed is, also where it leaves loops open.
  void place_rest();
  /// What the run has changed.
  std::vector<PatchChange::Pair> changes() const;

 private:
  enum class Open { none, some };
  std::set<int> patches_at(const std::set<int>& loops) const;
  OpenPatch opened(const PatchRun& run, const std::set<int>& loops) const;
  TimelinePtr timeline(const PatchRun& run) const;
  void part(Open allowed);

  Document& document_;
  std::size_t timeline_budget_;
  std::map<int, OpenPatch> before_;  ///< by id
  PatchRuns waiting_;
};

}  // namespace loopmend

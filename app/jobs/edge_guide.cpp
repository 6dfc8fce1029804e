// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/edge_guide.h"

#include "core/error.h"
#include "document/targets.h"
#include "pipeline/edge_preview.h"

#include <algorithm>

namespace loopmend {
namespace {

using GuideEdge = EdgeGuide::Edge;

constexpr std::size_t most_loops = 30;

/// The ends on one loop, where both are on it.
bool joins(const GuideEdge& edge, const std::pair<int, int>& ends) {
  return std::minmax(edge.begin, edge.end) == std::minmax(ends.first, ends.second);
}

/// @param edits  at the loop
std::vector<GuideEdge> edges_of(const OpenedScan& scan, int index, const BoundaryLoop& loop, const EdgeEdits& edits,
                                const Vec3& origin, const CancelToken& cancel) {
  constexpr double density = 1;
  std::vector<GuideEdge> edges;
  for (ContinuedEdge& found : continued_edges(*scan.model, loop, edits, density, cancel)) {
    for (Vec3& p : found.line) p -= origin;
    edges.push_back({GuideEdge::Kind::continued, index, std::move(found.line), found.begin, found.end});
  }
  for (const auto& ends : edits.drawn) {
    const auto found =
        std::find_if(edges.begin(), edges.end(), [&](const GuideEdge& edge) { return joins(edge, ends); });
    if (found != edges.end()) {
      found->kind = GuideEdge::Kind::drawn;
      continue;
    }
    GuideEdge straight{GuideEdge::Kind::not_fitting, index, {}, ends.first, ends.second};
    for (int point : {ends.first, ends.second}) straight.line.push_back(scan.model->soup.points[point] - origin);
    edges.push_back(std::move(straight));
  }
  return edges;
}

}  // namespace

EdgeGuide::EdgeGuide(Document& document, const HoleSelection& selection, QObject* parent)
    : QObject(parent),
      document_(document),
      selection_(selection) {
  for (auto signal : {&Document::opened, &Document::scans_changed})
    connect(&document_, signal, this, &EdgeGuide::forget);
  connect(&document_, &Document::patches_changed, this, &EdgeGuide::follow);
  connect(&document_, &Document::edge_edits_changed, this, &EdgeGuide::follow);
  connect(&selection_, &HoleSelection::selection_changed, this, &EdgeGuide::follow);
}

void EdgeGuide::watch(Watch what) {
  watch_ = what;
  follow();
}

void EdgeGuide::forget() {
  known_.clear();
  asked_.clear();
  follow();
}

std::vector<int> EdgeGuide::loops() const {
  if (watch_ == Watch::nothing) return {};
  return largest(document_, loops_to_fill(document_, selection_), most_loops);
}

EdgeEdits EdgeGuide::edits_at_loop(int loop) const {
  const int scan = document_.scan_of(loop);
  return edits_at(*document_.scan(scan)->model, {document_.loop(loop)}, document_.edge_edits(scan));
}

bool EdgeGuide::is_known(int loop) const {
  const auto known = known_.find(loop);
  return known != known_.end() && known->second.edits == edits_at_loop(loop);
}

void EdgeGuide::collect() {
  edges_.clear();
  for (int loop : loops())
    if (is_known(loop)) edges_.insert(edges_.end(), known_.at(loop).edges.begin(), known_.at(loop).edges.end());
  Q_EMIT changed();
}

/// Asks for what neither is known nor asked for: a fill of many holes changes the document often.
void EdgeGuide::follow() {
  std::vector<Asked> wanted;
  for (int loop : loops())
    if (!is_known(loop)) {
      const int scan = document_.scan_of(loop);
      wanted.push_back({document_.scan(scan), scan, loop, document_.loop(loop), edits_at_loop(loop)});
    }
  const bool is_asked = std::all_of(wanted.begin(), wanted.end(), [this](const Asked& one) {
    const auto asked = asked_.find(one.loop);
    return asked != asked_.end() && asked->second == one.edits;
  });
  if (wanted.empty() || !is_asked) ask(wanted);
  collect();
}

/// Each loop appears when it is done. @param wanted  instead of what the running job looks for
void EdgeGuide::ask(const std::vector<Asked>& wanted) {
  drop(job_);
  asked_.clear();
  if (wanted.empty()) return;
  for (const Asked& one : wanted) asked_[one.loop] = one.edits;
  job_ = std::make_shared<Job>(this);
  const auto end = [this] {
    job_.reset();
    asked_.clear();
    collect();
  };
  tasks_.run(
      job_,
      [this, wanted, job = job_, origin = document_.origin()] {
        for (const Asked& one : wanted) {
          Known found{one.edits, {}};
          try {
            found.edges = edges_of(*one.scan, one.index, one.boundary, one.edits, origin, job->token());
          } catch (const std::exception&) {  // a preview alone, and the other loops have theirs
          }
          if (job->token().cancelled()) break;
          job->post([this, loop = one.loop, found = std::move(found)] {
            known_[loop] = found;
            collect();
          });
        }
        return 0;
      },
      [end](int) { end(); }, [end](const QString&) { end(); });
}

void EdgeGuide::draw(int scan, int soup_a, int soup_b) {
  EdgeEdits edits = document_.edge_edits(scan);
  edits.drawn.emplace_back(soup_a, soup_b);
  std::erase_if(edits.stopped, [&](int point) { return point == soup_a || point == soup_b; });
  try {
    std::vector<BoundaryLoop> loops;
    for (int loop = 0; loop < document_.loop_count(); ++loop)
      if (document_.scan_of(loop) == scan && document_.present(loop)) loops.push_back(document_.loop(loop));
    check(edits, *document_.scan(scan)->model, loops);
  } catch (const InvalidArgument&) {  // a vertex beside the first one
    return;
  }
  document_.set_edge_edits(scan, std::move(edits));
}

void EdgeGuide::remove(const Edge& edge) {
  EdgeEdits edits = document_.edge_edits(edge.scan);
  if (edge.kind == Edge::Kind::continued) {
    const int end = edge.begin >= 0 ? edge.begin : edge.end;
    if (end < 0) return;
    edits.stopped.push_back(end);
  } else {
    std::erase_if(edits.drawn, [&](const auto& ends) { return joins(edge, ends); });
  }
  document_.set_edge_edits(edge.scan, std::move(edits));
}

void EdgeGuide::restore() {
  for (int scan : document_.scans()) document_.set_edge_edits(scan, {});
}

bool EdgeGuide::has_edits() const {
  const std::vector<int> scans = document_.scans();
  return std::any_of(scans.begin(), scans.end(), [this](int scan) { return !document_.edge_edits(scan).empty(); });
}

bool EdgeGuide::shut_down(std::chrono::milliseconds at_most) { return tasks_.stop(at_most); }

}  // namespace loopmend

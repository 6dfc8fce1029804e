// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/edge_guide.h"

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

std::vector<GuideEdge> edges_of(const OpenedScan& scan, int index, const BoundaryLoop& loop, const EdgeEdits& edits,
                                const Vec3& origin, const CancelToken& cancel) {
  constexpr double density = 1;
  std::vector<GuideEdge> edges;
  for (ContinuedEdge& found : continued_edges(*scan.model, loop, edits, density, cancel)) {
    for (Vec3& p : found.line) p -= origin;
    edges.push_back({GuideEdge::Kind::continued, index, std::move(found.line), found.begin, found.end});
  }
  const auto is_on_loop = [&](int point) {
    return std::any_of(loop.vertices.begin(), loop.vertices.end(),
                       [&](int v) { return scan.model->soup_vertex[static_cast<std::size_t>(v)] == point; });
  };
  for (const auto& ends : edits.drawn) {
    if (!is_on_loop(ends.first) || !is_on_loop(ends.second)) continue;
    const auto found =
        std::find_if(edges.begin(), edges.end(), [&](const GuideEdge& edge) { return joins(edge, ends); });
    if (found != edges.end()) {
      found->kind = GuideEdge::Kind::drawn;
      continue;
    }
    GuideEdge straight{GuideEdge::Kind::not_fitting, index, {}, ends.first, ends.second};
    for (int point : {ends.first, ends.second})
      straight.line.push_back(scan.model->soup.points[static_cast<std::size_t>(point)] - origin);
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

EdgeGuide::~EdgeGuide() {
  if (job_) job_->cancel();
}

void EdgeGuide::watch(Watch what) {
  watch_ = what;
  follow();
}

void EdgeGuide::forget() {
  known_.clear();
  follow();
}

std::vector<int> EdgeGuide::loops() const {
  if (watch_ == Watch::nothing) return {};
  std::vector<int> loops;
  const auto take = [&](int loop) {
    if (document_.present(loop) && document_.fillable(loop) && !document_.patch_of(loop)) loops.push_back(loop);
  };
  for (int loop : selection_.selected()) take(loop);
  if (loops.empty())
    for (int loop = 0; loop < document_.loop_count(); ++loop) take(loop);
  std::stable_sort(loops.begin(), loops.end(),
                   [this](int a, int b) { return document_.loop(a).diameter > document_.loop(b).diameter; });
  if (loops.size() > most_loops) loops.resize(most_loops);
  return loops;
}

/// Loops whose edges are known for the present edits are not asked again.
void EdgeGuide::follow() {
  if (job_) job_->cancel();
  job_.reset();
  edges_.clear();
  struct Wanted {
    std::shared_ptr<const OpenedScan> scan;
    int index = 0, loop = 0;
    BoundaryLoop boundary;
    EdgeEdits edits;
  };
  std::vector<Wanted> wanted;
  for (int loop : loops()) {
    const int scan = document_.scan_of(loop);
    const EdgeEdits& edits = document_.edge_edits(scan);
    const auto known = known_.find(loop);
    if (known != known_.end() && known->second.edits == edits)
      edges_.insert(edges_.end(), known->second.edges.begin(), known->second.edges.end());
    else
      wanted.push_back({document_.scan(scan), scan, loop, document_.loop(loop), edits});
  }
  if (!wanted.empty()) {
    job_ = std::make_shared<Job>(this);
    tasks_.run(
        job_,
        [wanted, job = job_, origin = document_.origin()] {
          std::map<int, Known> found;
          for (const Wanted& one : wanted)
            found[one.loop] = {one.edits,
                               edges_of(*one.scan, one.index, one.boundary, one.edits, origin, job->token())};
          return found;
        },
        [this](const std::map<int, Known>& found) {
          job_.reset();
          for (const auto& [loop, known] : found) {
            known_[loop] = known;
            edges_.insert(edges_.end(), known.edges.begin(), known.edges.end());
          }
          Q_EMIT changed();
        },
        [this](const QString&) {  // a preview alone
          job_.reset();
          Q_EMIT changed();
        });
  }
  Q_EMIT changed();
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

bool EdgeGuide::shut_down(std::chrono::milliseconds at_most) {
  if (job_) job_->cancel();
  return tasks_.wait(at_most);
}

}  // namespace loopmend

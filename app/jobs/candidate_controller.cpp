// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/candidate_controller.h"

#include "core/threads.h"
#include "document/changes.h"
#include "document/labels.h"
#include "jobs/fill_controller.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace loopmend {
namespace {

/// The faces of the scan that lie near the holes.
SurfaceShapePtr surface_around(const SurfaceShape& scan, const std::vector<BoundaryLoop>& loops, const Vec3& origin) {
  constexpr double reach = 1.0;  // diameters of the box around the loops, beyond it
  Eigen::AlignedBox3d box;
  for (const BoundaryLoop& loop : loops) {
    const Vec3 half = Vec3::Constant(0.5 * loop.diameter);
    box.extend(loop.center - origin - half);
    box.extend(loop.center - origin + half);
  }
  const double most = (0.5 + reach) * box.diagonal().norm() / std::sqrt(3.0);
  const Vec3 middle = box.center();
  const auto is_near = [&](int v) {
    const auto at = 3 * static_cast<std::size_t>(v);
    return (Vec3(scan.points[at], scan.points[at + 1], scan.points[at + 2]) - middle).norm() < most;
  };
  std::vector<int> close;
  for (std::size_t t = 0; t + 2 < scan.triangles.size(); t += 3)
    if (is_near(scan.triangles[t]) || is_near(scan.triangles[t + 1]) || is_near(scan.triangles[t + 2]))
      close.push_back(static_cast<int>(t / 3));
  std::vector<int> number(scan.points.size() / 3, -1);
  const std::shared_ptr<SurfaceShape> around = with_triangles(scan, close, number);
  const auto reduced = reduced_shape(*around);
  return reduced ? reduced : around;
}

}  // namespace

CandidateController::CandidateController(Document& document, UndoHistory& undo, FillController& controller,
                                         QObject* parent)
    : QObject(parent),
      document_(document),
      undo_(undo),
      controller_(controller) {
  connect(&document_, &Document::opened, this, &CandidateController::forget);
  connect(&document_, &Document::scans_changed, this, [this] {
    forget();
    mirror_planes_.clear();
  });
  connect(&document_, &Document::patches_changed, this, &CandidateController::follow_document);
  connect(&document_, &Document::patch_moved, this, &CandidateController::follow_document);
}

void CandidateController::compute(int loop) {
  const OpenPatch* patch = document_.patch_of(loop);
  if (!patch || controller_.busy()) return;
  forget();
  CandidateTask task{*patch, controller_.context_of(patch->scan), {}, nullptr, document_.origin()};
  for (int k : patch->loops) task.loops.push_back(document_.loop(k));
  auto& planes = mirror_planes_[&task.scan_context->model()];
  if (!planes) planes = std::make_shared<MirrorPlanes>();
  task.mirror_planes = planes;
  loops_ = {patch->loops.begin(), patch->loops.end()};
  candidates_.push_back({kind_of(patch->state->recipe).value_or(CandidateKind::as_it_is), {*patch}, {}});
  const std::vector<CandidateKind> kinds = kinds_for(*patch);
  total_ = static_cast<int>(kinds.size());
  job_ = std::make_shared<Job>(this);
  const JobPtr job = job_;
  tasks_.run(
      job,
      [this, job, task, kinds, scan = document_.scan(patch->scan)->shape] {
        const auto around = surface_around(*scan, task.loops, task.origin);
        job->post([this, around] {
          neighborhood_ = around;
          Q_EMIT changed();
        });
        parallel_for(0, static_cast<int>(kinds.size()), 1, [&](int k) {
          if (job->token().cancelled()) return;
          auto candidate = std::make_shared<Candidate>(make_candidate(task, kinds[k], job->token()));
          job->post([this, candidate] { add(std::move(*candidate)); });
        });
        return true;
      },
      [this](bool) {
        job_.reset();
        Q_EMIT changed();
      },
      [this](const QString&) {
        job_.reset();
        Q_EMIT changed();
      });
  Q_EMIT changed();
}

void CandidateController::add(Candidate candidate) {
  ++done_;
  if (candidate.patches.empty()) {
    refused_[candidate.kind] = candidate.why_not;
  } else {
    candidates_.push_back(std::move(candidate));
    // The patch as it is stays, whatever kind is equal to it.
    std::stable_sort(candidates_.begin(), candidates_.end(), [this](const Candidate& a, const Candidate& b) {
      return std::make_pair(!holds(a), a.kind) < std::make_pair(!holds(b), b.kind);
    });
    for (std::size_t k = 0; k < candidates_.size(); ++k)
      candidates_.erase(std::remove_if(candidates_.begin() + static_cast<std::ptrdiff_t>(k) + 1, candidates_.end(),
                                       [&](const Candidate& other) { return are_equal(candidates_[k], other); }),
                        candidates_.end());
    std::sort(candidates_.begin(), candidates_.end(),
              [](const Candidate& a, const Candidate& b) { return a.kind < b.kind; });
  }
  Q_EMIT changed();
}

bool CandidateController::holds(const Candidate& candidate) const {
  return std::all_of(candidate.patches.begin(), candidate.patches.end(), [this](const OpenPatch& patch) {
    const OpenPatch* now = document_.patch_of(patch.loops.front());
    return now && now->state == patch.state;
  });
}

int CandidateController::in_place() const {
  const auto found = std::find_if(candidates_.begin(), candidates_.end(), [this](const auto& c) { return holds(c); });
  return found == candidates_.end() ? -1 : static_cast<int>(found - candidates_.begin());
}

void CandidateController::take(int index) {
  if (controller_.busy() || index < 0 || index >= static_cast<int>(candidates_.size()) || index == in_place()) return;
  std::vector<PatchChange::Pair> pairs;
  std::set<int> replaced;
  for (int loop : loops_)
    if (const OpenPatch* old = document_.patch_of(loop); old && replaced.insert(old->id).second) {
      if (old->acceptance == Acceptance::accepted) return;
      pairs.push_back({*old, std::nullopt});
    }
  const Candidate& chosen = candidates_[index];
  for (OpenPatch patch : chosen.patches) {
    patch.id = document_.next_patch_id();
    patch.acceptance = Acceptance::pending;
    pairs.push_back({std::nullopt, std::move(patch)});
  }
  const QString text =
      tr("%1: %2").arg(labels::sentence(labels::holes(document_, loops_)), labels::candidate(chosen.kind));
  undo_.push(std::make_unique<PatchChange>(document_, std::move(pairs), text));
  Q_EMIT taken(text);
  Q_EMIT changed();
}

/// Undo and redo go from one candidate to another; anything else leads away from all of them.
void CandidateController::follow_document() {
  if (loops_.empty()) return;
  in_place() < 0 ? forget() : Q_EMIT changed();
}

void CandidateController::cancel() {
  if (!job_) return;
  drop(job_);
  constexpr std::size_t least_to_choose_from = 2;
  candidates_.size() < least_to_choose_from ? forget() : Q_EMIT changed();
}

void CandidateController::forget() {
  if (loops_.empty()) return;
  drop(job_);
  done_ = total_ = 0;
  loops_.clear();
  candidates_.clear();
  refused_.clear();
  neighborhood_.reset();
  Q_EMIT changed();
}

bool CandidateController::shut_down(std::chrono::milliseconds at_most) { return tasks_.stop(at_most); }

namespace labels {

QString candidate(CandidateKind kind) {
  switch (kind) {
    case CandidateKind::as_it_is: return CandidateController::tr("As it is");
    case CandidateKind::automatic: return CandidateController::tr("Automatic");
    case CandidateKind::tangent: return CandidateController::tr("Tangent");
    case CandidateKind::flat: return CandidateController::tr("Flat");
    case CandidateKind::robust: return CandidateController::tr("Robust");
    case CandidateKind::exact: return CandidateController::tr("Exact");
    case CandidateKind::rounded: return CandidateController::tr("Edges rounded");
    case CandidateKind::mirror: return CandidateController::tr("Mirror image");
  }
  return {};
}

QString candidate_help(CandidateKind kind) {
  switch (kind) {
    case CandidateKind::as_it_is: return CandidateController::tr("The patch that closes the hole now.");
    case CandidateKind::automatic: return CandidateController::tr("What Fill and smooth makes.");
    case CandidateKind::tangent:
      return CandidateController::tr("Continues the tangent of the scan, but not its curvature: calmer than the flow.");
    case CandidateKind::flat:
      return CandidateController::tr("A minimal surface: as flat as the boundary allows, with a crease at the seam.");
    case CandidateKind::robust:
      return CandidateController::tr("Hardly follows the curvature around the hole: for noisy scans.");
    case CandidateKind::exact:
      return CandidateController::tr("Takes the boundary literally: the flow itself, also on a rough scan.");
    case CandidateKind::rounded:
      return CandidateController::tr("One smooth patch: sharp edges that end at the hole are not continued.");
    case CandidateKind::mirror: return CandidateController::tr("A copy of the other side of the scan, mirrored.");
  }
  return {};
}

}  // namespace labels

}  // namespace loopmend

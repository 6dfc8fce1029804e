// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/mirror_guide.h"

#include "document/targets.h"
#include "pipeline/candidates.h"
#include "pipeline/initial_patch.h"

namespace loopmend {
namespace {

constexpr std::size_t most_compared = 12;

/// Of one hole.
MirrorGuide::Fit fit_of(ScanContext& context, int loop, const BoundaryLoop& boundary, const MirrorPlane& plane,
                        const Vec3& origin, const CancelToken& cancel) {
  MirrorGuide::Fit result{loop, {}, nullptr};
  const InitialPatch initial = make_initial_patch(context.model(), {boundary}, {}, cancel);
  if (!initial.patch || cancel.cancelled()) return result;
  const std::vector<MirrorPlane> planes{plane};
  const PatchResult made =
      solve_patch({context.index(), *initial.patch, {boundary}, &planes}, EvolutionOptions{}, {}, cancel);
  result.fit = made.mirror;
  if (made.mirror.is_used() && is_filled(made.status)) result.ghost = shape_of(made.patch, origin);
  return result;
}

}  // namespace

MirrorGuide::MirrorGuide(Document& document, const HoleSelection& selection, ContextOf context_of, QObject* parent)
    : PlaneGuide(parent),
      document_(document),
      selection_(selection),
      context_of_(std::move(context_of)) {
  for (auto signal : {&Document::opened, &Document::scans_changed, &Document::patches_changed})
    connect(&document_, signal, this, &MirrorGuide::follow);
  connect(&selection_, &HoleSelection::selection_changed, this, &MirrorGuide::follow);
}

void MirrorGuide::watch(Watch what) {
  watch_ = what;
  follow();
}

void MirrorGuide::follow() {
  const int scan = watch_ == Watch::scan ? scan_of_selection(document_, selection_) : -1;
  if (scan == scan_ && (scan < 0 || document_.scan(scan))) {
    if (scan >= 0 && plane_ && loops() != compared_) compare();
    return;
  }
  stop();
  scan_ = scan;
  planes_.clear();
  plane_.reset();
  fits_.clear();
  compared_.clear();
  if (scan_ >= 0) find_planes();
  Q_EMIT changed();
}

void MirrorGuide::stop() {
  drop(job_);
  has_failed_ = false;
}

template <class Work, class Done>
void MirrorGuide::start(Work work, Done done) {
  stop();
  job_ = std::make_shared<Job>(this);
  tasks_.run(
      job_, [work = std::move(work), job = job_] { return work(job->token()); },
      [this, done = std::move(done)](const auto& result) {
        job_.reset();
        done(result);
      },
      [this](const QString&) {  // a preview alone
        job_.reset();
        has_failed_ = true;
        Q_EMIT changed();
      });
}

void MirrorGuide::find_planes() {
  plane_ = document_.mirror_plane(scan_);
  start([context =
             context_of_(scan_)](const CancelToken& cancel) { return find_mirror_planes(context->model(), cancel); },
        [this](const std::vector<MirrorPlane>& found) {
          planes_ = found;
          if (!plane_ && !found.empty()) plane_ = found.front();
          compare();
        });
}

std::vector<int> MirrorGuide::loops() const {
  std::set<int> loops = loops_to_fill(document_, selection_);
  std::erase_if(loops, [this](int loop) { return document_.scan_of(loop) != scan_; });
  return largest(document_, loops, most_compared);
}

void MirrorGuide::compare() {
  stop();
  fits_.clear();
  compared_ = loops();
  if (plane_ && !compared_.empty()) {
    std::vector<std::pair<int, BoundaryLoop>> wanted;
    for (int loop : compared_) wanted.emplace_back(loop, document_.loop(loop));
    start(
        [wanted, plane = *plane_, context = context_of_(scan_),
         origin = document_.origin()](const CancelToken& cancel) {
          std::vector<Fit> fits;
          for (const auto& [loop, boundary] : wanted) {
            try {
              fits.push_back(fit_of(*context, loop, boundary, plane, origin, cancel));
            } catch (const std::exception&) {  // a preview alone, and the other holes have theirs
            }
          }
          return fits;
        },
        [this](const std::vector<Fit>& fits) {
          fits_ = fits;
          Q_EMIT changed();
        });
  }
  Q_EMIT changed();
}

void MirrorGuide::move_plane(const MirrorPlane& plane) {
  stop();
  plane_ = plane;
  fits_.clear();
  Q_EMIT changed();
}

void MirrorGuide::let_go() {
  if (use() == Use::where_it_fits) document_.set_mirror_plane(scan_, plane_);
  compare();
}

void MirrorGuide::use(Use use) {
  if (scan_ < 0) return;
  document_.set_mirror_plane(scan_, use == Use::where_it_fits ? plane_ : std::nullopt);
  Q_EMIT changed();
}

bool MirrorGuide::shut_down(std::chrono::milliseconds at_most) { return tasks_.stop(at_most); }

}  // namespace loopmend

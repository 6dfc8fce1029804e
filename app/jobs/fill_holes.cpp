#include "jobs/fill_holes.h"

#include "analysis/curvature_field.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace loopmend {
namespace {

PatchStatePtr first_state(Patch patch, const std::string& message, const Vec3& origin) {
  auto state = std::make_shared<PatchState>();
  state->shape = std::make_shared<SurfaceShape>(shape_of(patch, curvature_field(patch), origin));
  state->seam = seam_reports(patch);
  state->seam_before = state->seam;
  state->message = message;
  state->patch = std::move(patch);
  return state;
}

/// One group of loops: into `result` under its lock.
class GroupFiller {
 public:
  GroupFiller(const FillTask& task, FillResult& result) : task_(task), result_(result) {}

  void fill(const std::vector<int>& group, const CancelToken& cancel) {
    std::vector<BoundaryLoop> loops;
    loops.reserve(group.size());
    for (int i : group) loops.push_back(task_.loops[static_cast<std::size_t>(i)]);
    PatchStart start;
    std::string trouble;
    try {
      start = start_patch(*task_.model, loops, task_.options, cancel);
    } catch (const std::exception& error) {
      trouble = error.what();
    }
    if (cancel.cancelled()) return;
    record(group, std::move(start), trouble);
  }

 private:
  void record(const std::vector<int>& group, PatchStart start, const std::string& trouble) {
    OpenPatch open;
    std::map<int, std::string> failures, remarks;
    for (std::size_t k = 0; k < group.size(); ++k) {
      const int index = task_.loop_indices[static_cast<std::size_t>(group[k])];
      const bool filled = k < start.fillers.size() && start.fillers[k].filler.has_value() && start.patch.has_value();
      const std::string words = k < start.fillers.size() ? start.fillers[k].message : trouble;
      if (filled) open.loops.push_back(index);
      if (!filled) failures[index] = words.empty() ? "No valid triangulation of this loop was found." : words;
      if (filled && !words.empty()) remarks[index] = words;
    }
    std::string message;
    for (const auto& [index, words] : remarks) message += (message.empty() ? "" : " ") + words;
    if (start.patch) open.state = first_state(std::move(*start.patch), message, task_.origin);
    const std::lock_guard lock(mutex_);
    if (open.state) result_.patches.push_back(std::move(open));
    result_.failures.merge(failures);
    result_.remarks.merge(remarks);
  }

  const FillTask& task_;
  FillResult& result_;
  std::mutex mutex_;
};

}  // namespace

FillResult fill_holes(const FillTask& task, const std::function<void(int)>& progress, const CancelToken& cancel) {
  FillResult result;
  GroupFiller filler(task, result);
  const std::vector<std::vector<int>> groups = group_loops(*task.model, task.loops);
  std::atomic<std::size_t> next{0};
  std::mutex progress_mutex;
  int done = 0;
  const auto work = [&] {
    for (std::size_t g = next++; g < groups.size() && !cancel.cancelled(); g = next++) {
      filler.fill(groups[g], cancel);
      const std::lock_guard lock(progress_mutex);
      done += static_cast<int>(groups[g].size());
      progress(done);
    }
  };
  std::vector<std::thread> helpers;
  const std::size_t wanted = std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), groups.size());
  for (std::size_t i = 1; i < wanted; ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  std::sort(result.patches.begin(), result.patches.end(),
            [](const OpenPatch& a, const OpenPatch& b) { return a.loops < b.loops; });
  return result;
}

}  // namespace loopmend
